// Laws of evolution, in the record of a whole run: mutation, tournament, survival.
/** @import { Check, Core, Golden } from './check.js' */
import { once } from '../once.js';
import { atMost, between, check, largest, near, same, sameBits } from './check.js';

/** So many generations are looked at in full. */
const generations = 30;

/** @param {Golden} golden @returns {Check[]} */
export function evolutionChecks({ optimum }) {
  const history = once((/** @type {Core} */ core) => recorded(core, optimum));
  return [...mutationChecks(history), ...tournamentChecks(history), ...progressChecks(history, optimum)];
}

/** One run: the best J of all its generations, and the whole record of the first ones. @param {Core} core @param {Golden['optimum']} optimum */
function recorded(core, optimum) {
  const experiment = core.experiment({ evolution: { seed: optimum.seed } });
  const evolution = new core.Evolution(experiment);
  const best = [evolution.statistics().best.cost];
  while (best.length <= optimum.generations) best.push(evolution.step().best.cost);
  const [founders, ...records] = Array.from({ length: generations + 1 }, (_, generation) => {
    const record = evolution.record(generation);
    return { ...record, all: [...record.parents, ...record.offspring] };
  });
  evolution.free();
  return { experiment, best, founders, records };
}

/** @typedef {(core: Core) => ReturnType<typeof recorded>} History */

/** @param {History} history @returns {Check[]} */
function mutationChecks(history) {
  const draws = (/** @type {Core} */ core) =>
    history(core).records.flatMap(({ mutations }) =>
      mutations.flatMap(({ gains, common, sigmas }) => [...gains, common, ...sigmas]),
    );
  /** Five standard errors, beyond which one sample of this size in a million would be. @param {number} count @param {number} variance */
  const room = (count, variance) => Number((5 * Math.sqrt(variance / count)).toPrecision(2));
  return [
    check('learningRates', [], (core) => {
      const { own, common } = core.learningRates();
      const n = 3;
      return near([1 / Math.sqrt(2 * Math.sqrt(n)), 1 / Math.sqrt(2 * n)], [own, common], 1e-14, []);
    }),
    check('offspringGains', [generations], (core) => {
      const pairs = history(core).records.flatMap(({ parents, offspring, mutations }) =>
        offspring.flatMap(({ gains }, i) =>
          gains.map((gain, j) => [gain, parents[i].gains[j] + parents[i].sigmas[j] * mutations[i].gains[j]]),
        ),
      );
      return samePairs(pairs);
    }),
    check('offspringSigmas', [], (core) => {
      const { own, common } = core.learningRates();
      const differences = history(core).records.flatMap(({ parents, offspring, mutations }) =>
        offspring.flatMap(({ sigmas }, i) =>
          sigmas.map((sigma, j) => {
            const power = common * mutations[i].common + own * mutations[i].sigmas[j];
            return sigma / (parents[i].sigmas[j] * Math.exp(power)) - 1;
          }),
        ),
      );
      return atMost([1e-14], [largest(differences)]);
    }),
    check('drawMean', [], (core) => {
      const all = draws(core);
      const bound = room(all.length, 1);
      return between(-bound, bound, meanOf(all));
    }),
    check('drawVariance', [], (core) => {
      const all = draws(core);
      const bound = room(all.length, 2);
      return between(1 - bound, 1 + bound, meanOf(all.map((draw) => draw ** 2)) - meanOf(all) ** 2);
    }),
    check('drawCorrelation', [], (core) => {
      const products = history(core).records.flatMap(({ mutations }) =>
        mutations.flatMap(({ gains, sigmas }) => gains.map((gain, j) => gain * sigmas[j])),
      );
      const bound = room(products.length, 1);
      return between(-bound, bound, meanOf(products));
    }),
    check('offspringCosts', [], (core) => {
      const { experiment, records } = history(core);
      const offspring = records.flatMap((record) => record.offspring);
      const gains = offspring.flatMap((one) => one.gains);
      const costs = offspring.map((one) => one.cost);
      return sameBits(core.evaluate(experiment, gains), costs);
    }),
  ];
}

/** @param {History} history @returns {Check[]} */
function tournamentChecks(history) {
  return [
    check('strangers', [], (core) => {
      const { records } = history(core);
      const meetings = records.flatMap(({ opponents }) =>
        opponents.flatMap((met, own) => met.map((other) => (other === own ? 1 : 0))),
      );
      return same(0, sumOf(meetings));
    }),
    check('wins', [], (core) => {
      const pairs = history(core).records.flatMap(({ all, opponents, wins }) =>
        opponents.map((met, own) => [
          met.filter((other) => Number.isFinite(all[own].cost) && all[own].cost <= all[other].cost).length,
          wins[own],
        ]),
      );
      return samePairs(pairs);
    }),
    check('survivors', [], (core) => {
      const pairs = history(core).records.flatMap(({ all, wins, survivors }) => {
        const ranking = all
          .map((_, number) => number)
          .sort((a, b) => wins[b] - wins[a] || all[a].cost - all[b].cost || a - b);
        return survivors.map((number, place) => [number, ranking[place]]);
      });
      return samePairs(pairs);
    }),
    check('parents', [], (core) => {
      const { founders, records } = history(core);
      const pairs = records.flatMap(({ parents }, i) => {
        const before = i === 0 ? founders : records[i - 1];
        return before.survivors.flatMap((number, place) => {
          const [a, b] = [before.all[number], parents[place]];
          return [...a.gains, ...a.sigmas, a.cost].map((value, j) => [
            value,
            [...b.gains, ...b.sigmas, b.cost][j],
          ]);
        });
      });
      return samePairs(pairs);
    }),
  ];
}

/** @param {History} history @param {Golden['optimum']} optimum @returns {Check[]} */
const progressChecks = (history, { generations, cost: [low, high] }) => [
  check('neverWorse', [generations], (core) => {
    const { best } = history(core);
    return same(0, best.filter((cost, i) => i > 0 && !(cost <= best[i - 1])).length);
  }),
  check('optimum', [generations], (core) => between(low, high, history(core).best[generations])),
];

/** @param {readonly number[][]} pairs */
const samePairs = (pairs) =>
  sameBits(
    pairs.map(([a]) => a),
    pairs.map(([, b]) => b),
  );

/** @param {readonly number[]} values */
const sumOf = (values) => (values.length === 0 ? Number.NaN : values.reduce((sum, value) => sum + value, 0));

/** @param {readonly number[]} values */
const meanOf = (values) => sumOf(values) / values.length;
