// Round numbers at even distances, and how they are written: on axes, between bins, from dot to dot.

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

/** Digits after the point that mean anything. */
const mostDigits = 15;

/** What the numbers of a long axis are counted in, the largest first. */
const units = /** @type {const} */ ([
  ['T', 1e12],
  ['G', 1e9],
  ['M', 1e6],
  ['k', 1e3],
]);

/** As many digits as the step needs, at every tick; as many as it needs itself, where it is alone. @param {readonly number[]} ticks @returns {string[]} */
export function sameDigits(ticks) {
  const step = Math.abs(ticks.length > 1 ? ticks[1] - ticks[0] : ticks[0]) || 1;
  const largest = Math.max(...ticks.map(Math.abs));
  // Of wild gains; beyond, no letter is known.
  if (largest >= 1e15 && step >= 1000)
    return ticks.map((tick) =>
      Number(tick.toPrecision(3)).toExponential().replace('e+', 'e').replace('-', '−').replace(/^0e0$/, '0'),
    );
  const unit = units.find(([, one]) => largest >= one && step >= 1000 && 100 * step >= one);
  if (unit) {
    const [name, one] = unit;
    const texts = sameDigits(ticks.map((tick) => tick / one));
    return texts.map((text, i) => (ticks[i] === 0 ? '0' : text + name));
  }
  let digits = Math.min(mostDigits, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));
  // How far apart they are is not known to the last bit.
  const isWhole = (/** @type {number} */ value) => Math.abs(value - Math.round(value)) < 1e-3;
  while (digits < mostDigits && !isWhole(step * 10 ** digits)) digits += 1;
  return ticks.map((tick) => tick.toFixed(digits).replace('-', '−'));
}
