// What is being computed, and how it is stopped.

/** @param {'begin' | 'generation' | 'recorded'} what @param {number} generation @param {number | null} newest Up to which evolution catches up. */
export const computingText = (what, generation, newest) =>
  what === 'begin'
    ? 'The new evolution is being computed.'
    : newest !== null
      ? `Evolution catches up: generation ${generation} of ${newest}.`
      : what === 'generation'
        ? `Generation ${generation + 1} is being computed.`
        : 'A recorded generation is being computed again.';

export const stopComputing = 'Stop (Esc)';

/** @param {number | null} generation The one that evolution has come to; null when it was to begin anew. */
export const stoppedText = (generation) =>
  generation === null
    ? 'Stopped: what was here before stays.'
    : `Stopped at generation ${generation}: what has been computed stays.`;
