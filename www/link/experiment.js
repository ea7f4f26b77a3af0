// An experiment in a link: every number and word of it by its path, as text, and back again.
/** @import { Experiment } from '../core/engine.js' */
import { rememberEach } from '../kit/memo.js';
import { valueAt, withValue } from '../run/paths.js';
import { link as words } from '../words/index.js';
import { angle, angleText, number, numberText, posture, postureText } from './values.js';

/** Shorter names of what links carry most. @type {readonly (readonly [string, string])[]} */
const shortNames = [
  ['evolution.seed', 'seed'],
  ['evolution.population', 'population'],
  ['evolution.opponents', 'opponents'],
  ['starts', 'start'],
];
/** @param {string} path */
const nameOf = (path) => shortNames.find(([long]) => long === path)?.[1] ?? path;
/** @param {string} name */
export const pathOf = (name) => shortNames.find(([, short]) => short === name)?.[0] ?? name;

/** What an experiment has different, as names and texts. @param {Experiment} experiment @param {Experiment} usual @returns {[string, string][]} */
export function changesOf(experiment, usual) {
  const fields = fieldsOf(usual);
  return [...fieldsOf(experiment)]
    .filter(([path, value]) => value !== fields.get(path))
    .map(([path, value]) => [nameOf(path), value]);
}

/** The same as one text, within a key. @param {Experiment} experiment @param {Experiment} usual */
export const changesText = (experiment, usual) =>
  changesOf(experiment, usual).map(([name, value]) => `${name}:${value}`);

/** An experiment with changes read from such texts, which the core has still to accept. @param {Experiment} usual @param {readonly string[]} changes */
export function withChanges(usual, changes) {
  /** @param {string} change @returns {[string, string]} */
  const pathAndValue = (change) => {
    const at = Math.max(change.indexOf(':'), 0);
    return [pathOf(change.slice(0, at)), change.slice(at + 1)];
  };
  return [...new Map(changes.map(pathAndValue))].reduce(
    (before, [path, value]) => withField(before, path, value),
    usual,
  );
}

/** Of an experiment with many starts a page writes many links. */
const fieldsOf = rememberEach((/** @type {Experiment} */ experiment) => {
  /** @type {Map<string, string>} */
  const fields = new Map();
  const walk = (/** @type {unknown} */ value, /** @type {string} */ path) => {
    if (path === 'starts') fields.set(path, experiment.starts.map(postureText).join(';'));
    else if (Array.isArray(value)) fields.set(path, value.map(numberText).join(','));
    else if (value !== null && typeof value === 'object')
      for (const [key, inner] of Object.entries(value)) walk(inner, path ? `${path}.${key}` : key);
    else if (typeof value === 'number')
      fields.set(path, path.endsWith('theta') ? angleText(value) : numberText(value));
    else fields.set(path, value === null ? 'off' : String(value));
  };
  walk(experiment, '');
  return fields;
});

/** What of an experiment links can name. @param {Experiment} experiment @returns {{ has: (path: string) => boolean }} */
export const namesIn = (experiment) => fieldsOf({ ...experiment, starts: [] });

/** The experiment with one field read from text, which the core has still to accept. @param {Experiment} experiment @param {string} path @param {string} text */
export function withField(experiment, path, text) {
  if (!namesIn(experiment).has(path)) throw new Error(words.unknownField);
  return withValue(experiment, path, readLike(valueAt(experiment, path), path, text));
}

/** @param {unknown} before What stands there. @param {string} path @param {string} text @returns {any} */
function readLike(before, path, text) {
  if (path === 'starts') return text.split(';').map(posture);
  if (Array.isArray(before)) return text.split(',').map(number);
  if (typeof before === 'string') return text;
  if (text === 'off') return null;
  return /(?:theta|heading)$/.test(path) ? angle(text) : number(text);
}
