// The same bits on every machine: whole runs of evolution by their hashes, and the first random draws.
/** @import { Check, Core, Golden } from './check.js' */
import { check, same, sameBits } from './check.js';

/** @param {Golden} golden @returns {Check[]} */
export const bitChecks = ({ evolutions, draws }) => [
  ...evolutions.map(({ task, preset, changes, generations, hash }) =>
    check('hash', [task, preset, Number(changes.evolution?.seed), generations], (core) => {
      const evolution = new core.Evolution(core.experiment(preset, changes));
      for (let i = 0; i < generations; i++) evolution.step();
      return same(hash, hashOf(evolution));
    }),
  ),
  check('watched', [watchedGenerations], (core) => {
    const [straight, watched] = [new core.Evolution({}), new core.Evolution({})];
    for (let i = 0; i < watchedGenerations; i++) {
      straight.step();
      watched.record(Math.floor(i / 2));
      watched.step();
      watched.population(0);
    }
    return same(hashOf(straight), hashOf(watched));
  }),
  check('draws', [draws.seed], (core) => sameBits(drawsOf(draws), firstDraws(core, draws.seed))),
];

const watchedGenerations = 40;

/** @param {InstanceType<Core['Evolution']>} evolution */
function hashOf(evolution) {
  const hash = evolution.hash();
  evolution.free();
  return hash;
}

/** @param {Golden['draws']} draws */
const drawsOf = ({ parent, gains, common, sigmas, opponents, noise }) => [
  ...parent,
  ...gains,
  common,
  ...sigmas,
  ...opponents,
  ...noise,
];

/** The same numbers as they are drawn now. @param {Core} core @param {number} seed */
function firstDraws(core, seed) {
  const evolution = new core.Evolution({ evolution: { seed } });
  evolution.step();
  const [founders, first] = [evolution.record(0), evolution.record(1)];
  evolution.free();
  const disturbance = { kind: /** @type {const} */ ('random'), linear: 1, angular: 1, seed };
  const { x, theta } = core.simulate({ disturbance }, [0, 0, 0]);
  const { gains, common, sigmas } = first.mutations[0];
  const [parent] = founders.parents;
  return [...parent.gains, ...gains, common, ...sigmas, ...first.opponents[0], x[1], theta[1]];
}
