// V and V̇ of a run in numbers.
/** @import { Stability } from '../../../core/engine.js' */
import { readableSamples } from '../numbers.js';
import words from './words/index.js';

/** @param {string} name @param {Stability} run @returns {import('../../../kit/table.js').Table} */
export function stabilityTable(name, run) {
  const { every, samples } = readableSamples(run.time.length);
  const step = every * (run.time[1] ?? 0);
  return {
    caption: words.tableCaption(name, step),
    columns: words.tableColumns,
    count: samples.length,
    rowOf(row) {
      const i = samples[row];
      return [
        words.timeText(run.time[i], step),
        ...[run.errorX, run.errorY].map((values) => words.amount(values[i])),
        words.angleText(run.errorTheta[i]),
        words.amount(run.lyapunov[i]),
        ...[run.promisedX, run.promisedY, run.promisedTheta].map((values) => words.amount(values[i])),
        words.amount(run.promisedX[i] + run.promisedY[i] + run.promisedTheta[i]),
        words.amount(run.rate[i]),
        words.limitedText(run.limited[i] === 1),
      ];
    },
  };
}
