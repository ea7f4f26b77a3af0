// You against evolution and random search: who finds the gains with the lowest J in the yard?
import { rememberEach } from '../../kit/memo.js';
import { sliderRange } from '../../run/drivers.js';
import { taskText } from './tally.js';

/** @import { Engine, Experiment, Preset, Triple } from '../../core/engine.js' */
/** @import { Verdict } from '../words/common.js' */
/** @import { Tally } from '../state.js' */

/**
 * The best J of each generation, what random search had found by then, and the gains that each is judged by.
 * @typedef {{ seed: number, evolution: ArrayLike<number>, random: ArrayLike<number>, champion: Triple, drawn: Triple }} Round
 */
/**
 * What was locked in, and what the others have done since.
 * @typedef {object} Duel
 * @property {Experiment} experiment In which all three drive: from all starts of the yard.
 * @property {readonly number[]} costs J of each trial by hand.
 * @property {Triple | null} gains The best by hand.
 * @property {readonly Round[]} rounds One for each seed; the newest is shown.
 * @property {boolean} goesOn The others are shown beyond what they are judged by.
 */

/** The choices of the prediction, and who can win. */
export const winners = /** @type {const} */ (['you', 'evolution', 'random', 'both']);

/** With fewer it has hardly begun: so many generations evolution always has. */
const fewestGenerations = 20;
/** So far the others go on, or twice as far. */
const fewestDrives = 1220;

/** Only J counts, whether all robots arrived or not: as for evolution. @param {readonly number[]} costs */
export const lowestOf = (costs) =>
  costs.reduce((lowest, cost) => Math.min(lowest, cost), Number.POSITIVE_INFINITY);

/** @param {Tally} tally @param {Experiment} experiment @returns {Duel} */
export const lockedIn = ({ costs, lowest }, experiment) => ({
  experiment,
  costs,
  gains: lowest?.gains ?? null,
  rounds: [],
  goesOn: false,
});

/** Whether a duel was about what is driven now. @param {Duel} duel @param {Experiment} experiment */
export const isDuelOf = (duel, experiment) => taskText(duel.experiment) === taskText(experiment);

/** The last generation of an evolution that has no more trials than that. @param {number} drives @param {number} population */
export const generationAt = (drives, population) => Math.max(0, Math.floor(drives / population) - 1);

/** The same, but at least its twenty: what evolution is judged by. @param {number} drives @param {number} population */
export const generationsIn = (drives, population) =>
  Math.max(fewestGenerations, generationAt(drives, population));

/** How many trials a generation ends with. @param {number} generation @param {number} population */
export const drivesUntil = (generation, population) => population * (generation + 1);

/** How far the others go on. @param {Duel} duel */
export const longestOf = ({ costs, experiment }) => {
  const { population } = experiment.evolution;
  const drives = Math.max(fewestDrives, 2 * costs.length);
  return drivesUntil(generationsIn(drives, population), population);
};

/** What the workers have not answered yet. @type {(engine: Engine) => Map<string, Promise<Round>>} */
const askedOf = rememberEach(() => new Map());

/** Evolution and random search with a seed, both from the same first population; who asks meanwhile waits for the same. @param {Engine} engine @param {Duel} duel @param {number} seed @returns {Promise<Round>} */
export function roundOf(engine, duel, seed) {
  const asked = askedOf(engine);
  const name = JSON.stringify([duel.experiment, duel.costs.length, seed]);
  const round = asked.get(name) ?? compute(engine, duel, seed).finally(() => asked.delete(name));
  asked.set(name, round);
  return round;
}

/** @param {Engine} engine @param {Duel} duel @param {number} seed @returns {Promise<Round>} */
async function compute(engine, duel, seed) {
  const { experiment, costs } = duel;
  const { population } = experiment.evolution;
  const generations = generationsIn(longestOf(duel), population);
  // Whatever searches in the lab.
  const by = (/** @type {'ep' | 'random'} */ method) => ({
    ...experiment,
    evolution: { ...experiment.evolution, method, seed },
  });
  const judged = generationsIn(costs.length, population);
  const [[{ best, random }], champion, drawn] = await Promise.all([
    engine.surveys.seedRuns(by('ep'), { first: seed, count: 1, generations }),
    engine.surveys.evolve(by('ep'), judged),
    engine.surveys.evolve(by('random'), judged),
  ]);
  const gainsIn = (/** @type {{ gains: Triple }} */ { gains }) => /** @type {Triple} */ ([...gains]);
  return { seed, evolution: best, random, champion: gainsIn(champion), drawn: gainsIn(drawn) };
}

/** The seed of the next round: the experiment's own, then those that follow it. @param {Duel} duel */
export const nextSeed = ({ experiment, rounds }) =>
  (rounds.at(-1)?.seed ?? experiment.evolution.seed - 1) + 1;

/** Whether evolution's ky is where neither a slider nor random search goes. @param {Pick<Duel, 'experiment'>} duel @param {Pick<Round, 'champion'>} round @param {Preset} preset */
export const isBeyond = ({ experiment }, { champion: [, ky] }, preset) =>
  ky > sliderRange[preset][1] && ky > experiment.evolution.initialRange[1];

/** @param {Duel} duel @param {Pick<Round, 'seed' | 'evolution' | 'random'>} round @returns {Verdict} */
export function judge(duel, { seed, evolution, random }) {
  const { costs, experiment } = duel;
  const { population } = experiment.evolution;
  const drives = costs.length;
  const generation = Math.min(generationsIn(drives, population), evolution.length - 1);
  const own = lowestOf(costs);
  const last = evolution.length - 1;
  const others = { evolution: evolution[generation], random: random[generation] };
  const passedAt = Array.from(evolution).findIndex((cost) => cost < own);
  return {
    seed,
    drives,
    generation,
    given: drivesUntil(generation, population),
    costs: { you: own, ...others },
    winner: winnerOf(own, others),
    longest: drivesUntil(last, population),
    later: { evolution: evolution[last], random: random[last] },
    passed: passedAt < 0 ? null : drivesUntil(passedAt, population),
  };
}

/** @param {number} own @param {{ evolution: number, random: number }} others @returns {typeof winners[number]} */
function winnerOf(own, { evolution, random }) {
  if (own <= evolution && own <= random) return 'you';
  if (evolution === random) return 'both';
  return evolution < random ? 'evolution' : 'random';
}

/** How many of the rounds each has won. @param {Duel} duel @returns {Record<typeof winners[number], number>} */
export function scoreOf(duel) {
  const score = { you: 0, evolution: 0, random: 0, both: 0 };
  for (const round of duel.rounds) score[judge(duel, round).winner] += 1;
  return score;
}
