// The names of points on the map: each beside its mark, where it covers nothing that one looks for.
/** @import { Frame } from '../../kit/chart.js' */

/** @typedef {{ x: number, y: number, name: string, width: number }} Named In pixels; `width` that of its name. */
/** @typedef {{ left: number, top: number, width: number }} Place Of a name. */
/** @typedef {readonly [x: number, y: number, radius: number]} Spot What no name should cover. */

const [gap, high] = [12, 17];
/** As far from the edge of the map its halo is seen whole. */
const inset = 6;

/** Right of the mark, left, above and below. @param {Named} named @returns {Place[]} */
const around = ({ x, y, width }) =>
  [
    [x + gap, y - high / 2],
    [x - gap - width, y - high / 2],
    [x - width / 2, y - gap - high],
    [x - width / 2, y + gap],
  ].map(([left, top]) => ({ left, top, width }));

/** Within the map. @param {Frame} frame @param {Place} place @returns {Place} */
const within = ({ left, right, top, bottom }, place) => ({
  left: Math.max(left + inset, Math.min(place.left, right - place.width - inset)),
  top: Math.max(top + inset, Math.min(place.top, bottom - high - inset)),
  width: place.width,
});

/** @param {Place} place @param {Spot} spot */
const isCovered = ({ left, top, width }, [x, y, radius]) =>
  x > left - radius && x < left + width + radius && y > top - radius && y < top + high + radius;

/** @param {Place} a @param {Place} b */
const overlap = (a, b) =>
  a.left < b.left + b.width && b.left < a.left + a.width && Math.abs(a.top - b.top) < high;

/** One after the other; what covers least is taken, the first of those that cover as little; to be moved from the edge counts as one. A name gives way that would lie on one before, or on what is sought. @param {Frame} frame @param {readonly Named[]} named @param {readonly Spot[]} spots @param {readonly Spot[]} [sought] @returns {(Place | null)[]} */
export function placeNames(frame, named, spots, sought = []) {
  /** @type {Place[]} */
  const taken = [];
  return named.map((one) => {
    const free = around(one)
      .map((beside) => ({ beside, place: within(frame, beside) }))
      .filter(({ place }) => !taken.some((other) => overlap(place, other)))
      .filter(({ place }) => !sought.some((spot) => isCovered(place, spot)));
    const covers = free.map(
      ({ beside, place }) =>
        spots.filter((spot) => isCovered(place, spot)).length + Number(place.left !== beside.left),
    );
    const place = free[covers.indexOf(Math.min(...covers))]?.place ?? null;
    if (place) taken.push(place);
    return place;
  });
}

/** The middle of a name's height. @param {Place} place */
export const middleOf = ({ top }) => top + high / 2;
