// What is being computed, and how it is stopped.

/** @param {'begin' | 'generation' | 'recorded'} what @param {number} generation @param {number | null} newest Up to which evolution catches up. */
export const computingText = (what, generation, newest) =>
  what === 'begin'
    ? '새 진화를 계산하고 있습니다.'
    : newest !== null
      ? `진화를 처음부터 다시 계산하고 있습니다: ${newest}세대 가운데 ${generation}세대.`
      : what === 'generation'
        ? `${generation + 1}세대를 계산하고 있습니다.`
        : '기록된 세대를 다시 계산하고 있습니다.';

export const stopComputing = '중지(Esc)';

/** @param {number | null} generation The one that evolution has come to; null when it was to begin anew. */
export const stoppedText = (generation) =>
  generation === null
    ? '중지했습니다. 이전 상태가 그대로 남습니다.'
    : `${generation}세대에서 중지했습니다. 계산한 것은 그대로 남습니다.`;
