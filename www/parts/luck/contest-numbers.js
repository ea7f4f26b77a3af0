// What the words of a contest tell of how it is judged, so that they need nothing else of it.

/** Of fewer runs no interval is told: it would hold far less often than it says. */
export const leastRuns = 15;
