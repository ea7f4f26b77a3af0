// One number between the core and the screen: angles in degrees there, radians here; its range as the core gives it.
/** @import { Field } from '../core/engine.js' */

/** @typedef {{ from: number, to: number, step?: number, log?: boolean }} SliderRange In the unit on screen; with `log` the left end is 0 where 0 is allowed. */

const positionsPerDecade = 40;
/** @type {Record<string, string>} */
const onScreen = { rad: '°', 'rad/s': '°/s', 'rad/s²': '°/s²' };

/** Without the digits that only rounding has put there. @param {number} value @param {number} digits */
const rounded = (value, digits) => Number(value.toPrecision(digits));

/** @param {Field} field */
export function createQuantity({ unit, min, max, integer }) {
  const isAngle = unit in onScreen;
  const shown = (/** @type {number} */ value) =>
    rounded(isAngle ? (value * 180) / Math.PI : value, integer ? 10 : 6);
  const range = /** @type {const} */ ([shown(min), shown(max)]);
  return {
    unit: isAngle ? onScreen[unit] : unit,
    integer,
    /** The smallest and largest on screen. */
    range,
    shown,
    /** What the core gets for a number on screen. @param {number} number */
    value(number) {
      // As it is shown it may lie a little beyond.
      if (range.includes(number)) return number === range[0] ? min : max;
      return isAngle ? (number * Math.PI) / 180 : number;
    },
    /** @param {number} value */
    allows: (value) => value >= min && value <= max && (!integer || Number.isInteger(value)),
  };
}

/** Where a number on screen stands on a slider, and back. @param {SliderRange} range @param {boolean} hasZero */
export function createSliderScale({ from, to, step = 1, log = false }, hasZero) {
  if (!log)
    return {
      min: from,
      max: to,
      step,
      number: (/** @type {number} */ position) => rounded(position, 6),
      position: (/** @type {number} */ number) => Math.min(Math.max(number, from), to),
    };
  const decades = Math.log10(to / from);
  const last = Math.round(decades * positionsPerDecade);
  return {
    min: hasZero ? -1 : 0,
    max: last,
    step: 1,
    /** @param {number} position */
    number: (position) => (position < 0 ? 0 : rounded(from * 10 ** ((decades * position) / last), 2)),
    /** @param {number} number */
    position(number) {
      if (number < from) return hasZero && number === 0 ? -1 : 0;
      return Math.min(last, Math.round((Math.log10(number / from) / decades) * last));
    },
  };
}
