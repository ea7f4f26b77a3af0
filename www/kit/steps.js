// Round numbers at even distances: on axes, between bins, from dot to dot.

/** What rounding may be wrong by, as a share of a step. */
const slip = 1e-9;

/** The least number that is one of these factors times a power of ten, and not below `least`. @param {number} least @param {readonly number[]} [factors] */
export function roundStep(least, factors = [1, 2, 5]) {
  const power = 10 ** Math.floor(Math.log10(least) + slip);
  return power * (factors.find((factor) => factor * power >= least * (1 - slip)) ?? 10);
}

/** @param {number} from @param {number} to @param {number} step */
export function multiples(from, to, step) {
  const first = Math.ceil(from / step - slip);
  const count = Math.floor(to / step + slip) - first + 1;
  return Array.from({ length: Math.max(0, count) }, (_, i) => (first + i) * step);
}
