// What a method other than the paper's sees of the land: the ellipse of CMA-ES, the differences of DE, the simplex of Nelder and Mead,
// and of the others the step that was tried. In gains; the map draws it.
/** @import { Experiment, GenerationRecord, Triple } from '../../core/engine.js' */

/** Over the two gains of the axes. @typedef {readonly [number, number]} Place */
/**
 * @typedef {object} Sketch
 * @property {readonly (readonly Place[])[]} rings Closed lines.
 * @property {readonly (readonly [Place, Place])[]} lines
 * @property {readonly (readonly [Place, Place])[]} faint
 */

const none = /** @type {Sketch} */ ({ rings: [], lines: [], faint: [] });
const turn = 72;

/** @typedef {(gains: Triple) => Place} Shadow How a point of three gains falls on the map. */

/**
 * The ellipse at so many standard deviations, seen along the third gain.
 * @param {{ mean: Triple, axes: readonly Triple[] }} ellipse @param {Shadow} shadow @param {number} deviations @returns {Place[]}
 */
export function ringOf({ mean, axes }, shadow, deviations) {
  const [mx, my] = shadow(mean);
  const flat = axes.map(shadow);
  // The square root of the covariance of the two gains.
  const [a, b, c] = [0, 1, 2].map((k) =>
    flat.reduce((sum, [x, y]) => sum + (k === 0 ? x * x : k === 1 ? x * y : y * y), 0),
  );
  const along = Math.sqrt(a);
  const [across, rest] = along > 0 ? [b / along, Math.sqrt(Math.max(0, c - (b * b) / a))] : [0, Math.sqrt(c)];
  return Array.from({ length: turn }, (_, i) => {
    const angle = (2 * Math.PI * i) / turn;
    const [u, v] = [deviations * Math.cos(angle), deviations * Math.sin(angle)];
    return [mx + along * u, my + across * u + rest * v];
  });
}

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
