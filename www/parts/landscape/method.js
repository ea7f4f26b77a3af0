// What a method other than the paper's sees of the land: the ellipse of CMA-ES, the differences of DE, the simplex of Nelder and Mead,
// and of the others the step that was tried. In gains; the map draws it.
/** @import { Experiment, GenerationRecord } from '../../core/engine.js' */
/** @import { Place, Shadow } from '../../kit/ellipse.js' */
import { ringOf } from '../../kit/ellipse.js';

/**
 * @typedef {object} Sketch
 * @property {readonly (readonly Place[])[]} rings Closed lines.
 * @property {readonly (readonly [Place, Place])[]} lines
 * @property {readonly (readonly [Place, Place])[]} faint
 */

const none = /** @type {Sketch} */ ({ rings: [], lines: [], faint: [] });

/** Whether each robot steps from where it stands, and by the σ that it has. @param {Experiment['evolution']['method']} method */
export const hasCrosses = (method) => method === 'ep' || method === 'one-plus-one-es';

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

/** @param {Experiment['evolution']['method']} method @param {GenerationRecord} record @param {Shadow} shadow @returns {Sketch} */
export function sketchOf(method, record, shadow) {
  const { ellipse, parents, offspring } = record;
  switch (method) {
    case 'cma-es':
      return ellipse
        ? { ...none, rings: [1, 2].map((deviations) => ringOf(ellipse, shadow, deviations)) }
        : none;
    case 'de':
      return differences(record, shadow);
    case 'nelder-mead':
      return record.generation === 0
        ? simplex({ ...record, offspring: [] }, shadow)
        : simplex(record, shadow);
    case 'one-plus-one-es':
    case 'one-at-a-time':
    case 'finite-differences':
      return { ...none, lines: offspring.map(({ gains }) => [shadow(parents[0].gains), shadow(gains)]) };
    default:
      return none;
  }
}
