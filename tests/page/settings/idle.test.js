// A setting is shown as idle just where it changes nothing, whatever word another one has.
import assert from 'node:assert/strict';
import { rows } from '../../../www/settings/table.js';
import { experiment, fields, historyOf, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */

const general = (/** @type {string} */ path) => path.replace(/\[\d\]/, '[]');
const wordsOf = new Map(wordFields().map(({ path, words }) => [path, words]));
const numbers = new Map(fields().map((field) => [field.path, field]));

/** A copy, and where the setting stands in it. @param {Experiment} from @param {string} path */
function placeOf(from, path) {
  const changed = structuredClone(from);
  const names = path.replace(/\[(\d)\]/, '.$1').split('.');
  const last = /** @type {string} */ (names.pop());
  const holder = names.reduce((/** @type {any} */ one, name) => one[name], changed);
  return { changed, holder, last };
}

/** The experiment with this setting at other values. @param {Experiment} from @param {string} path @returns {Experiment[]} */
function othersOf(from, path) {
  const now = placeOf(from, path);
  const value = now.holder[now.last];
  const words = wordsOf.get(general(path));
  const field = numbers.get(general(path));
  const near = [value * 0.5, value * 1.5, value * 0.001, value + 1, value - 1, value + 4].map((one) =>
    field?.integer ? Math.round(one) : one,
  );
  return (words ?? near).flatMap((other) => {
    const { changed, holder, last } = placeOf(from, path);
    holder[last] = other;
    try {
      return other === value ? [] : [experiment(changed)];
    } catch {
      return [];
    }
  });
}

/** Which gains, at what J; the hash tells too what a method never uses. @param {Experiment} from */
const found = (from) =>
  JSON.stringify(
    historyOf(from, 12).map(({ best, median, worst }) => [best.gains, best.cost, median, worst]),
  );

/** One in which every setting can matter. @type {Experiment} */
const lively = (() => {
  const { disturbance, evolution, ...rest } = experiment('velocity-limits');
  return {
    ...rest,
    tolerance: { ...rest.tolerance },
    disturbance: { ...disturbance, linear: 0.1, angular: 0.1 },
    evolution: { ...evolution, population: 8, opponents: 3, initialSigma: 5, initialRange: [-3, 5] },
  };
})();

/** @param {string} path @param {string | number} value @returns {Experiment} */
function livelyBut(path, value) {
  const { changed, holder, last } = placeOf(lively, path);
  holder[last] = value;
  return changed;
}

const experiments = [
  ...wordFields().flatMap(({ path, words }) => words.map((word) => livelyBut(path, word))),
  livelyBut('evolution.crossover', 0.5),
  livelyBut('evolution.initialSigma', 0),
  livelyBut('evolution.population', 1),
];

test('a setting is idle just where no other value of it changes what is found', () => {
  for (const from of experiments) {
    const now = found(from);
    for (const { path, isIdle } of rows.filter(({ path }) => /^(disturbance|evolution)\./.test(path))) {
      const changes = othersOf(from, path).some((other) => found(other) !== now);
      const { law, disturbance, evolution } = from;
      assert.equal(
        isIdle?.(from) ?? false,
        !changes,
        `${path} in ${JSON.stringify({ law, disturbance, evolution })}`,
      );
    }
  }
});

test('a setting that is never idle matters in the one run', () => {
  const now = found(lively);
  for (const { path, isIdle } of rows)
    if (!isIdle)
      assert.ok(
        othersOf(lively, path).some((other) => found(other) !== now),
        path,
      );
});
