// The number of ours by which a contest is judged. The words tell it too, and need nothing else of it.

/** Of fewer runs no interval is told: it would hold far less often than it says. */
export const leastRuns = 15;
