// What is typed in the maker of an aim and its points, read in the unit of what is asked for.
/** @import { Exercise } from '../../run/exercise.js' */
/** @import { Wanted } from '../../run/aim.js' */
import { aimOf, scaleOf } from '../../link/exercise.js';
import { number, numberText } from '../../link/values.js';
import { most } from '../../run/aim.js';
import { narrowed } from '../../words/numbers.js';
import words from '../words/index.js';

/** As they are typed; `points`: a value, the points at it, another value, the points at that. @typedef {{ kind: 'none' | 'cost' | 'parks' | 'unseen', value: string, drives: string, points: readonly string[] }} Fields */

/** How an aim of each kind begins in a link. */
export const heads = { cost: 'J<', parks: 'parks:', unseen: 'unseen:' };

/** In the order of what is typed, and of a link. */
export const pointIds = ['maker-at-0', 'maker-points-0', 'maker-at-1', 'maker-points-1'];

/** Which field is wrong, by its id, and why. */
export class WrongField extends Error {
  /** @param {string} field @param {string} why */
  constructor(field, why) {
    super(why);
    this.field = field;
  }
}

/** What is wrong is said in the words of the field that it is in. @template T @param {string} field @param {string} why @param {() => T} read */
function orSay(field, why, read) {
  try {
    return read();
  } catch {
    throw new WrongField(field, why);
  }
}

/** As links have it: nine tenths, for who types 90 %. @param {string} text */
const shareOf = (text) =>
  text.endsWith('%') ? numberText(Number((number(text.slice(0, -1)) / 100).toPrecision(15))) : text;

/** As one writes by hand. @param {string} text */
const unspaced = (text) => text.replace(/\s*\/\s*/, '/');

/** How a link has what is typed of each aim. */
const inLink = {
  cost: (/** @type {string} */ text) => numberText(number(text)),
  parks: unspaced,
  unseen: shareOf,
};

/** A number within what there can be. @param {string} text @param {number} highest */
function upTo(text, highest) {
  const value = number(text);
  if (value < 0 || value > highest) throw new Error();
  return value;
}

/** A value at which there are points, as the aim itself is typed. @param {Wanted} wanted @param {string} text */
function measuredIn(wanted, text) {
  if (wanted.kind === 'cost') return upTo(text, most.cost);
  if (wanted.kind === 'unseen') return upTo(shareOf(text), 1);
  const parks = unspaced(text);
  return upTo(parks.endsWith(`/${wanted.of}`) ? parks.slice(0, parks.indexOf('/')) : parks, wanted.of);
}

/** @param {Wanted} wanted @param {readonly string[]} points */
function scaleIn(wanted, points) {
  if (points.every((text) => text === '')) return null;
  const read = points.map((text, at) => {
    if (text === '') return null;
    const i = at >> 1;
    return at % 2 === 0
      ? orSay(pointIds[at], words.wrongAt(i, wanted, most), () => measuredIn(wanted, text))
      : orSay(pointIds[at], words.wrongPoints(i, most), () => upTo(text, most.points));
  });
  if (read.includes(null)) throw new WrongField(pointIds[read.indexOf(null)], words.lacksPoints);
  const [a, p, b, q] = read.map((value) => numberText(value ?? 0));
  return orSay(pointIds[2], words.sameAt, () => scaleOf(`${a}:${p},${b}:${q}`));
}

/** @param {Fields} fields @returns {Pick<Exercise, 'aim' | 'scale'>} */
export function asked({ kind, ...fields }) {
  if (kind === 'none') return { aim: null, scale: null };
  const [value, drives, ...points] = [fields.value, fields.drives, ...fields.points].map(narrowed);
  const wanted = orSay('maker-value', words.wrongValue(kind, most), () => {
    const text = `${heads[kind]}${inLink[kind](value)}`;
    aimOf(text);
    return text;
  });
  const aim = orSay('maker-budget', words.wrongDrives(most), () =>
    aimOf(drives ? `${wanted};drives<=${number(drives)}` : wanted),
  );
  return { aim, scale: scaleIn(aim.wanted, points) };
}

/** What is better has fewer points. @param {Pick<Exercise, 'aim' | 'scale'>} exercise */
export function isTurned({ aim, scale }) {
  if (!aim || !scale) return false;
  const [[a, b], [p, q]] = [scale.values, scale.points];
  const isHigherBetter = aim.wanted.kind !== 'cost';
  return p !== q && (b > a === q > p) !== isHigherBetter;
}
