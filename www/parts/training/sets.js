// The starts that gains are evolved on, and those that no evolution sees. All lie around the goal and move with it.
/** @import { Engine, Experiment, Posture } from '../../core/engine.js' */
import { remember } from '../../kit/memo.js';

/** @typedef {typeof setNames[number]} SetName */
/** @typedef {Record<SetName | 'unseen', Posture[]>} Sets */

export const setNames = /** @type {const} */ (['one', 'circle', 'grid']);

/** @param {string} name Of a row. @returns {name is SetName} */
export const isSet = (name) => setNames.some((set) => set === name);

/** As far as the paper's start is from its goal, in metres. */
const circleRadius = 2 * Math.SQRT2;
export const circleCount = 32;
const gridHalf = 3;
const gridSide = 6;
export const gridCount = gridSide * gridSide;

/** The unseen starts fill a disc of this radius in metres. */
export const unseenRadius = 4;
const rings = 18;
export const unseenCount = 1000;

/** As many as the area within so many rings asks for. @param {number} inner */
const startsWithin = (inner) => Math.round(unseenCount * (inner / rings) ** 2);

/** Their headings are drawn with seeds of their own, which have nothing to do with that of evolution. */
const circleSeed = 1;
const unseenSeed = 1000;

/** @param {Pick<Engine, 'startsOnCircle'>} engine @returns {(experiment: Experiment) => Sets} */
export function createSets({ startsOnCircle }) {
  const around = remember((/** @type {Posture} */ goal) => {
    const circle = (/** @type {number} */ radius, /** @type {number} */ count, /** @type {number} */ seed) =>
      startsOnCircle({ x: goal.x, y: goal.y, radius, count, seed });
    return {
      circle: circle(circleRadius, circleCount, circleSeed),
      grid: gridAround(goal),
      unseen: Array.from({ length: rings }, (_, i) =>
        circle((unseenRadius * (i + 0.5)) / rings, startsWithin(i + 1) - startsWithin(i), unseenSeed + i),
      ).flat(),
    };
  });
  return remember((experiment) => ({ one: experiment.starts, ...around(experiment.goal) }));
}

/** Positions on a square; from one to the next the heading turns by a quarter. @param {Posture} goal @returns {Posture[]} */
function gridAround({ x, y, theta }) {
  const offset = (/** @type {number} */ index) => gridHalf * ((2 * index) / (gridSide - 1) - 1);
  return Array.from({ length: gridCount }, (_, i) => {
    const [column, row] = [i % gridSide, Math.floor(i / gridSide)];
    const heading = theta + Math.PI / 4 + (((column + 2 * row) % 4) * Math.PI) / 2;
    return {
      x: x + offset(column),
      y: y + offset(row),
      // No sine or arc tangent: their last bits differ between browsers, and evolution would with them.
      theta: heading > Math.PI ? heading - 2 * Math.PI : heading,
    };
  });
}

/** A population of one, because who drives from many starts here is not evolved on them; only EP can be so small. @param {Experiment} experiment @param {Posture[]} starts @returns {Experiment} */
export const testOn = (experiment, starts) => ({
  ...experiment,
  starts,
  evolution: { ...experiment.evolution, method: 'ep', population: 1 },
});
