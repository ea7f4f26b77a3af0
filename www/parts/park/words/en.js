// Every word of Park.
/** @import { Bred } from '../state.js' */
/** @import { Model } from '../sight.js' */
import { fixed, grouped } from '../../../words/en/numbers.js';

export const title = 'Park them all';
export const pictureName = 'The parking place';

/** @param {number} count */
export const invitation = (count) =>
  `${count} robots, one parking place. All of them obey the same three numbers. Find three that park every robot.`;

/** @param {Model} model @param {Bred} found */
export function ending({ best, count, most }, { gains, parked, generation }) {
  const mine = best?.parked ?? 0;
  if (parked <= mine)
    return `Evolution stopped at ${parked} of ${count}; you had ${mine}. That was luck, good or bad: try another seed.`;
  const beyond = gains[1] / most;
  const where =
    beyond > 1.5
      ? ` Your slider for ky ends at ${most}; evolution, which has no slider, went to ${fixed(gains[1], 0)}.`
      : '';
  const after = `After ${generation} ${generation === 1 ? 'generation' : 'generations'}`;
  return parked === count
    ? `${after} one robot parks from all ${count} starts. Nobody told evolution how: it was given one number for each robot, and kept what drove well.${where}`
    : `${after} evolution parks ${parked} of ${count}.${where}`;
}

/** @param {number} count */
export const ofParked = (count) => `of ${count} parked`;
/** @param {number} parked @param {number} count */
export const share = (parked, count) => `${parked} of ${count}`;
export const yours = 'with your numbers';
/** Before anybody has moved one. */
export const given = 'with these numbers';
/** @param {number} generation @param {number} population */
export const swarm = (generation, population) =>
  generation === 0 ? `best of ${population} random robots` : `best robot of generation ${generation}`;

export const sliders = 'The three numbers';
export const evolve = 'Let evolution try';
export const stop = 'Stop';
export const otherSeed = 'Evolve again, another seed';
export const again = 'Drive again';
export const first = 'First move a slider: all robots drive again at once. Then evolution may try.';
/** @param {number} population */
export const ready = (population) =>
  `Stuck? Evolution starts from ${population} random robots and knows nothing else.`;

/** @param {number} value */
export const gain = (value) => fixed(value, 1);

/** @param {Bred} newest */
export const climb = ({ generation, parked, drives }) =>
  `Generation ${generation}: ${parked} parked · ${grouped(drives)} drives so far`;

export const parkedColumn = 'parked';
export const bestByHand = 'yours';
export const evolved = 'evolution’s';
export const how = 'How does it do that?';
export const openLab = 'Open this evolution in the lab';

/** @param {number} parked @param {number} count */
export const picture = (parked, count) => `${parked} of ${count} robots have parked.`;

/** What red means. @param {{ position: number, heading: number }} tolerance */
export const missed = ({ position, heading }) =>
  `Red has missed: more than ${fixed(100 * position, 0)} cm or ${fixed((180 / Math.PI) * heading, 1)}° off.`;
