// The values in a link as text, and back again; what cannot be read throws an Error that says what it must be.
/** @import { Experiment, Posture, Triple } from '../core/engine.js' */
import { link as words } from '../words/index.js';
import { numberOf } from '../words/numbers.js';

/** So much is read of a link; only with thousands of starts one is longer. */
export const mostCharacters = 200_000;
export const mostPairs = 5000;

/** What is read of a link, none of it cut through, and whether that is all of it. @param {string} link */
export function piecesOf(link) {
  const all = link.slice(0, mostCharacters).split('&');
  const isShort = link.length <= mostCharacters;
  const pieces = (isShort ? all : all.slice(0, -1)).slice(0, 1 + mostPairs);
  return { pieces, isWhole: isShort && pieces.length === all.length };
}

/** @param {number} value The shortest text that gives back the same bits. */
export const numberText = (value) => (Object.is(value, -0) ? '-0' : String(value));

/** An angle in degrees where that gives back the same bits, else in radians. @param {number} radians */
export function angleText(radians) {
  const degrees = numberText(Number(((radians * 180) / Math.PI).toFixed(9)));
  return Object.is(angle(`${degrees}deg`), radians) ? `${degrees}deg` : numberText(radians);
}

/** @param {string} text */
export const angle = (text) =>
  text.endsWith('deg') ? (number(text.slice(0, -3)) * Math.PI) / 180 : number(text);

/** @param {Posture} posture */
export const postureText = ({ x, y, theta }) => [numberText(x), numberText(y), angleText(theta)].join(',');

/** @param {string} text @returns {Posture} */
export function posture(text) {
  const parts = text.split(',');
  if (parts.length !== 3) throw new Error(words.expected(words.aPosture, text));
  return { x: number(parts[0]), y: number(parts[1]), theta: angle(parts[2]) };
}

/** @param {Experiment['disturbance']} disturbance */
export const disturbanceText = ({ kind, linear, angular, seed }) =>
  [kind, numberText(linear), numberText(angular), String(seed)].join(',');

/** @param {string} text @returns {Experiment['disturbance']} */
export function disturbanceOf(text) {
  const [kind, ...numbers] = text.split(',');
  const [linear, angular, seed] = numbers.map(number);
  return { kind: /** @type {Experiment['disturbance']['kind']} */ (kind), linear, angular, seed };
}

/** @param {string} text @returns {Triple} */
export function triple(text) {
  const gains = text.split(',').map(number);
  if (gains.length !== 3) throw new Error(words.expected(words.threeNumbers, text));
  return /** @type {[number, number, number]} */ (gains);
}

/** @param {string} text @param {number} most */
export function gainsUpTo(text, most) {
  const gains = triple(text);
  if (gains.some((gain) => gain < 0 || gain > most))
    throw new Error(words.expected(words.gainsUpTo(most), text));
  return gains;
}

/** @param {string} text */
export function number(text) {
  const value = numberOf(text);
  if (!Number.isFinite(value)) throw new Error(words.expected(words.aNumber, text));
  return value;
}

/** @param {string} text @param {number} most */
export function wholeNumber(text, most) {
  const value = numberOf(text);
  if (!Number.isInteger(value) || value < 0 || value > most)
    throw new Error(words.expected(words.wholeNumber(most), text));
  // No −0.
  return value + 0;
}

/** @template {string} T @param {readonly T[]} choices @param {string} text */
export function oneOf(choices, text) {
  const found = choices.find((choice) => choice === text);
  if (found === undefined) throw new Error(words.expected(words.oneOf(choices), text));
  return found;
}

/** @param {readonly number[]} choices @param {string} text */
export const oneNumberOf = (choices, text) => Number(oneOf(choices.map(String), text));

/** @param {string} text @returns {[string, string]} */
export function pairOf(text) {
  const at = text.indexOf('=');
  return at < 0 ? [decoded(text), ''] : [decoded(text.slice(0, at)), decoded(text.slice(at + 1))];
}

/** Only what would end a value, or what browsers change, is written as %. @param {string} text */
export const encoded = (text) => wellFormed(text).replaceAll(/[^\w,;.!~*'()-]+/g, encodeURIComponent);

/** Half a character, which a cut can leave, has no code in an address. @param {string} text */
export const wellFormed = (text) => text.replaceAll(/[\ud800-\udfff]/gu, '\ufffd');

/** @param {string} text */
export function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
