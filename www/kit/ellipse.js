// An ellipsoid of three dimensions, as its shadow falls on two.

/** @typedef {readonly [number, number, number]} Triple */
/** Over two axes. @typedef {readonly [number, number]} Place */
/** How a point of three dimensions falls on two. @typedef {(point: Triple) => Place} Shadow */
/** Its semi-axes stand at right angles. @typedef {{ mean: Triple, axes: readonly Triple[] }} Ellipsoid */

const turn = 72;

/** Its outline at so many standard deviations. @param {Ellipsoid} ellipsoid @param {Shadow} shadow @param {number} deviations @returns {Place[]} */
export function ringOf({ mean, axes }, shadow, deviations) {
  const [mx, my] = shadow(mean);
  const flat = axes.map(shadow);
  // The square root of the covariance of the two.
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

/** The standard deviation along one dimension. @param {Ellipsoid} ellipsoid @param {number} j */
export const deviationOf = ({ axes }, j) => Math.hypot(...axes.map((axis) => axis[j]));
