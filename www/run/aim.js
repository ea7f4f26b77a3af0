// When an exercise is solved: what of an answer is measured, what it must come to, and how many points that is worth.

/**
 * J, the mean over the starts of the experiment; from how many starts the robot parks; from which share of starts that nobody
 * has evolved on.
 * @typedef {{ kind: 'cost', below: number } | { kind: 'parks', least: number, of: number } | { kind: 'unseen', share: number }} Wanted
 */
/** `drives`: at most so many, or null. @typedef {{ wanted: Wanted, drives: number | null }} Aim */
/** Points at two values of what is measured, to hundredths on the straight line between them, and beyond them as at the nearer. @typedef {{ values: readonly [number, number], points: readonly [number, number] }} Scale */
/** What an answer came to. `value`: what is wanted, measured. @typedef {{ value: number, drives: number }} Reached */
/** @typedef {{ isMet: boolean, points: number | null, most: number | null }} Judged `points` out of `most`, if there are any. */

/** What may be asked for. */
export const most = { cost: 1e9, starts: 1000, drives: 1e9, points: 1000 };

/** @param {Wanted} wanted @param {number} value */
function isEnough(wanted, value) {
  if (wanted.kind === 'cost') return value < wanted.below;
  return value >= (wanted.kind === 'parks' ? wanted.least : wanted.share);
}

/** @param {Scale} scale @param {number} value */
function pointsAt({ values: [a, b], points: [p, q] }, value) {
  const share = Math.min(1, Math.max(0, (value - a) / (b - a)));
  // A value that is no number, as J of a robot that is lost, is as bad as can be.
  const points = Number.isFinite(value) ? p + share * (q - p) : Math.min(p, q);
  return Math.round(100 * points) / 100;
}

/** @param {Aim} aim @param {Scale | null} scale @param {Reached} reached @returns {Judged} */
export function judged({ wanted, drives }, scale, reached) {
  const isWithin = drives === null || reached.drives <= drives;
  const isMet = isWithin && isEnough(wanted, reached.value);
  if (!scale) return { isMet, points: null, most: null };
  const points = isWithin ? pointsAt(scale, reached.value) : Math.min(...scale.points);
  return { isMet, points, most: Math.max(...scale.points) };
}
