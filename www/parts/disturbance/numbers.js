// The numbers of ours by which it is judged. The words tell them too, and need nothing else of it.

/** How many other starts there are, unless their samples were too many. */
export const usualStarts = 32;

/** So near is on the edge, inside or outside: there a slip lets robots come to rest. */
export const edgePercent = 1;
