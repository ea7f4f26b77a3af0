// Every word of Park.
import { fixed } from '../../../words/en/numbers.js';

export const title = 'Park them all';
export const pictureName = 'The parking place';

/** @param {number} count */
export const invitation = (count) =>
  `${count} robots, one parking place. All of them obey the same three numbers. How many can you park?`;

/** @param {number} count */
export const ofParked = (count) => `of ${count} parked`;
export const yours = 'with your numbers';
/** Before anybody has moved one. */
export const given = 'with these numbers';
/** @param {number} generation @param {number} population */
export const swarm = (generation, population) =>
  generation === 0 ? `best of ${population} random robots` : `best robot of generation ${generation}`;

export const sliders = 'The three numbers';
/** What each of them is for. */
export const whatFor = ['ahead', 'aside', 'turn'];
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

export const how = 'How does it do that?';
export const openLab = 'Open this evolution in the lab';

/** @param {number} parked @param {number} count */
export const picture = (parked, count) =>
  `${parked} of ${count} robots ${parked === 1 ? 'has' : 'have'} parked.`;

/** @param {number} parked @param {number} count */
export const planeLabel = (parked, count) =>
  `${picture(parked, count)} Arrow keys tell of one after the other.`;

/** What red means. @param {{ position: number, heading: number }} tolerance */
export const missed = ({ position, heading }) =>
  `Red and hollow: missed by more than ${fixed(100 * position, 0)} cm or ${fixed((180 / Math.PI) * heading, 1)}°.`;
export const pressOne = 'Press one to see why.';
