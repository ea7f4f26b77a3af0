// What a method other than the paper's sees of the land: the ellipse of CMA-ES, the differences of DE, the simplex of Nelder and Mead,
// and of the others the step that was tried. In gains; the map draws it.
/** @import { GenerationRecord } from '../../core/engine.js' */
/** @import { Method } from '../../core/methods.js' */
/** @import { Place, Shadow } from '../../kit/ellipse.js' */
import { methods } from '../../core/methods.js';
import { ringOf } from '../../kit/ellipse.js';

/**
 * @typedef {object} Sketch
 * @property {readonly (readonly Place[])[]} rings Closed lines.
 * @property {readonly (readonly [Place, Place])[]} lines
 * @property {readonly (readonly [Place, Place])[]} faint
 */

const none = /** @type {Sketch} */ ({ rings: [], lines: [], faint: [] });

/** Whether each robot steps from where it stands, and by the σ that it has. @param {Method} method */
export const hasCrosses = (method) => methods[method].sigma === 'robot';

/** @param {GenerationRecord} record @param {Shadow} shadow @returns {Sketch} */
function differences({ parents, offspring, donors, survivors }, shadow) {
  const at = (/** @type {number} */ i) => shadow(parents[i].gains);
  const stays = new Set(survivors);
  /** @type {Sketch['lines'][number][]} */
  const lines = [];
  /** @type {Sketch['lines'][number][]} */
  const faint = [];
  for (const [i, [a, b, c]] of donors.entries()) {
    const won = stays.has(parents.length + i);
    // Of those that won also the two whose difference it is.
    if (won) faint.push([at(c), at(b)]);
    (won ? lines : faint).push([at(a), shadow(offspring[i].gains)]);
  }
  return { ...none, lines, faint };
}

/** The corners are joined; a trial that decides over one stands beside them. @param {GenerationRecord} record @param {Shadow} shadow @returns {Sketch} */
function simplex({ parents, offspring, survivors }, shadow) {
  const all = [...parents, ...offspring];
  const standing = survivors.map((number) => all[number].gains);
  const beside = survivors.length > 4 ? offspring.at(-1)?.gains : undefined;
  const corners = standing.filter((gains) => gains !== beside).slice(0, 4);
  /** @type {Sketch['lines'][number][]} */
  const lines = corners.flatMap((one, i) =>
    corners.slice(i + 1).map((other) => /** @type {const} */ ([shadow(one), shadow(other)])),
  );
  // What was tried, or where it was taken over, the corner that it took the place of.
  const tried = offspring.length === 1 ? offspring[0].gains : null;
  const gone = parents.filter((_, i) => !survivors.includes(i)).at(-1)?.gains;
  const beyond = tried && corners.includes(tried) ? gone : tried;
  return { ...none, lines, faint: beyond ? corners.map((one) => [shadow(one), shadow(beyond)]) : [] };
}

/** What was tried, from where. @param {GenerationRecord} record @param {Shadow} shadow @returns {Sketch} */
const steps = ({ parents, offspring }, shadow) => ({
  ...none,
  lines: offspring.map(({ gains }) => [shadow(parents[0].gains), shadow(gains)]),
});

/** Of those without one, robots and crosses are all. @type {Readonly<Record<Method, ((record: GenerationRecord, shadow: Shadow) => Sketch) | null>>} */
const drawings = {
  ep: null,
  random: null,
  de: differences,
  'cma-es': ({ ellipse }, shadow) =>
    ellipse ? { ...none, rings: [1, 2].map((deviations) => ringOf(ellipse, shadow, deviations)) } : none,
  'one-plus-one-es': steps,
  'nelder-mead': (record, shadow) =>
    simplex(record.generation === 0 ? { ...record, offspring: [] } : record, shadow),
  'one-at-a-time': steps,
  'finite-differences': steps,
};

/** @param {Method} method */
export const hasSketch = (method) => drawings[method] !== null;

/** @param {Method} method @param {GenerationRecord} record @param {Shadow} shadow */
export const sketchOf = (method, record, shadow) => drawings[method]?.(record, shadow) ?? none;
