// What a figure may be told: every message, its fields, and what each of them must be. What else a message has is refused by name.
/** @import { Experiment, Triple } from '../core/engine.js' */
import { lastGeneration } from '../run/pace.js';
import { embed as words } from '../words/index.js';
import { version } from './frame.js';

/** @typedef {(name: string, value: unknown) => unknown} Check The value as it is used, or an error that names the field. */

/** So that the answer is not long in coming. */
const mostAtOnce = 10_000;

/** Of a value that is wrong. */
const mostTold = 40;
/** Of what is answered. */
const mostOfError = 600;

/** @param {unknown} value */
function told(value) {
  if (typeof value === 'string') return `“${value.slice(0, mostTold)}”`;
  if (isList(value)) return words.aList(value.length);
  if (typeof value === 'object' && value !== null) return words.anObject;
  return String(value).slice(0, mostTold);
}

/** @param {unknown} value @returns {value is ArrayLike<unknown> & Iterable<unknown>} */
const isList = (value) =>
  Array.isArray(value) || value instanceof Float64Array || value instanceof Float32Array;

/** @param {number} least @param {number} most */
const wholeNumber = (least, most) => (/** @type {string} */ name, /** @type {unknown} */ value) => {
  if (typeof value !== 'number' || !Number.isInteger(value) || value < least || value > most)
    throw new Error(words.wholeNumber(name, least, most, told(value)));
  return value;
};

/** @param {string} _ @param {unknown} value @returns {Triple | null} */
function gainsIn(_, value) {
  if (value === undefined || value === null) return null;
  if (!isList(value) || value.length !== 3 || ![...value].every(Number.isFinite))
    throw new Error(words.threeGains(told(value)));
  return /** @type {[number, number, number]} */ ([...value]);
}

/** What is no text is none: then an experiment is set. @param {string} _ @param {unknown} value */
const linkIn = (_, value) => (typeof value === 'string' ? value : null);

/** The core knows what may be in it; a Map or a Date has no fields of its own. @param {string} _ @param {unknown} value @returns {Partial<Experiment> | null} */
const experimentIn = (_, value) =>
  Object.prototype.toString.call(value) === '[object Object]' ? /** @type {object} */ (value) : null;

/** By type. */
const messages = {
  set: {
    link: linkIn,
    experiment: experimentIn,
    gains: gainsIn,
    generation: wholeNumber(0, lastGeneration),
  },
  step: { generations: wholeNumber(1, mostAtOnce) },
  run: {},
  pause: {},
  read: {},
};

/** What a field is when it is left out. @type {Readonly<Record<string, unknown>>} */
const usual = { generation: 0, generations: 1 };

/** @typedef {keyof typeof messages} Type */
/** What each message says. @typedef {{ set: { link: string | null, experiment: Partial<Experiment> | null, gains: Triple | null, generation: number }, step: { generations: number }, run: {}, pause: {}, read: {} }} Said */

/** Whether it is meant for a figure, of whatever version: other things are said in a page too. @param {unknown} message @returns {message is Record<string, unknown>} */
export const isForFigure = (message) => message !== null && typeof message === 'object' && 'ep' in message;

/** The id with which the answer is to come back, if there is one that can. @param {Record<string, unknown>} message */
export function idIn({ id }) {
  try {
    return id === undefined ? {} : { id: structuredClone(id) };
  } catch {
    // A thing that was handed over, as a port is.
    return {};
  }
}

/** What a message says; an error names what is wrong with it. @param {Record<string, unknown>} message @returns {{ [T in Type]: { type: T, said: Said[T] } }[Type]} */
export function messageIn({ ep, type, ...given }) {
  if (ep !== version) throw new Error(words.otherVersion(told(ep), version));
  if (typeof type !== 'string' || !Object.hasOwn(messages, type))
    throw new Error(words.unknownType(told(type), Object.keys(messages)));
  /** @type {Readonly<Record<string, Check>>} */
  const fields = messages[/** @type {Type} */ (type)];
  // A link has all of it, and what stands beside it is not read.
  const looked = type === 'set' && typeof given.link === 'string' ? { link: given.link } : given;
  const known = ['ep', 'type', 'id', ...Object.keys(fields)];
  const unknown = Object.keys(looked).find((name) => looked[name] !== undefined && !known.includes(name));
  if (unknown !== undefined) throw new Error(words.unknownField(type, told(unknown), known));
  /** What is undefined is left out. @param {string} name */
  const saidOf = (name) => (looked[name] === undefined ? usual[name] : looked[name]);
  const checked = Object.entries(fields).map(([name, check]) => [name, check(name, saidOf(name))]);
  const said = Object.fromEntries(checked);
  if (type === 'set' && said.link === null && said.experiment === null)
    throw new Error(words.linkOrExperiment);
  return /** @type {any} */ ({ type, said });
}

/** @param {string} text */
export const shortError = (text) => (text.length > mostOfError ? `${text.slice(0, mostOfError)}…` : text);
