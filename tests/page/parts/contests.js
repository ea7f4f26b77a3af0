// A contest as Node has it.
import { trials } from '../../../pkg/ep_locomotion.js';
import { entered } from '../../../www/parts/luck/contestants.js';
import { standingsOf } from '../../../www/parts/luck/contest-summary.js';
import { pairsText } from '../../../www/parts/luck/words/common.js';
import { experiment } from '../harness/core.js';

/** @typedef {import('../../../www/parts/luck/contestants.js').Contestant} Contestant */
/** @typedef {import('../../../www/parts/luck/contest-request.js').Contest} Contest */

export const velocityLimits = experiment('velocity-limits');

/** The same contest in Node. @param {readonly Contestant[]} others @param {number} seeds @param {number} budget @returns {Contest} */
export const contestOf = (others, seeds, budget) => ({
  experiment: velocityLimits,
  seeds,
  budget,
  lines: [null, ...others].map((name) => ({
    name,
    trials: trials(entered(velocityLimits, name), { seeds: [1, 1 + seeds], drives: budget }),
    error: '',
  })),
  cancelled: false,
});
/** @type {Contestant[]} */
export const others = ['truncation', 'fixed', 'de'];
export const small = contestOf(others, 15, 1000);

/** @param {Contest} contest @param {number | null} target */
export const expectedTable = (contest, target) =>
  standingsOf(contest, { target }).lines.map(
    ({ name, reached, count, ert, interval, median, comparison }) => ({
      name: name ?? 'lab',
      cells: [
        `${reached} of ${count}`,
        ert === Infinity
          ? '∞'
          : `${Math.round(ert)} ${(interval ?? []).map((end) => (end === Infinity ? '∞' : Math.round(end))).join('–')}`,
        median.toFixed(4),
        comparison ? pairsText(comparison.a12) : '',
        comparison ? (comparison.p < 0.001 ? '< 0.001' : comparison.p.toFixed(3)) : '',
      ],
    }),
  );
