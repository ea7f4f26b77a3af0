// The package's `ep-locomotion/link`: what a link of the page runs. It reads numbers as the page does, and none of its words but
// those that say what is wrong.
import { experiment as completed, evaluate } from '../pkg/ep_locomotion.js';
import { linkIn } from '../www/embed/link-in.js';
import { stepNamed } from '../www/lesson/path.js';
import { pathOf, withField } from '../www/link/experiment.js';
import { readAll } from '../www/link/together.js';
import {
  decoded,
  mostCharacters,
  mostPairs,
  oneOf,
  pairOf,
  piecesOf,
  triple,
  wholeNumber,
} from '../www/link/values.js';
import { pageNames } from '../www/parts/parts.js';
import { drivers, presets } from '../www/run/state.js';
import * as words from '../www/words/en/link.js';

/** @typedef {import('./link.d.ts').LinkedRun} LinkedRun */

const version = 1;
const mostOfName = 60;

/** What is about the page, or not applied here. @param {LinkedRun} run @param {string} key @param {string} text */
const kept = (run, key, text) => ({ ...run, others: { ...run.others, [key]: text } });

/** What is read besides the fields of the experiment. @type {Record<string, (run: LinkedRun, text: string) => LinkedRun>} */
const keys = {
  v(run, text) {
    if (text !== String(version)) throw new Error(words.otherVersion(text, version));
    return kept(run, 'v', text);
  },
  preset: (run, text) => ({ ...run, preset: oneOf(presets, text) }),
  generation: (run, text) => ({ ...run, generation: wholeNumber(text, 100_000) }),
  drives: (run, text) => ({ ...run, drives: oneOf(drivers, text) }),
  gains(run, text) {
    const gains = triple(text);
    // The core knows which gains cannot be driven; one sample tells.
    evaluate({ horizon: 0.01 }, gains);
    return { ...run, gains };
  },
};

/** Whether a key is a field of the experiment, or a shorter name of one. @param {string} key @param {object} experiment */
const isField = (key, experiment) => pathOf(key).split('.')[0] in experiment;

/** A link as the page reads it: from HTML `&` comes as `&amp;`, and learning platforms add `?name=value` to the end of an address, or who works there before its #. @param {string} link */
function asWritten(link) {
  return piecesOf(linkIn(link.replaceAll('&amp;', '&')).replace(/\?(?=\w+=)/g, '&'));
}

/** What the page would say before it reads a value. @param {string} name @param {ReadonlyMap<string, string>} given */
function misplaced(name, given) {
  const isThere = name === 'lesson' || pageNames.includes(name);
  const step = name === 'lesson' ? given.get('step') : given.get('lesson');
  return [
    ...(isThere ? [] : [words.unknownPart(decoded(name).slice(0, mostOfName), [...pageNames, 'lesson'])]),
    ...(step === undefined || stepNamed(step).isThere ? [] : [words.noStep(step.slice(0, mostOfName))]),
  ];
}

/** @type {typeof import('./link.d.ts').openLink} */
export function openLink(link) {
  if (typeof link !== 'string') {
    const found = Object(link) === link ? `of type ${typeof link}` : String(link);
    throw new TypeError(`link must be a text, but was ${found}`);
  }
  const { pieces, isWhole } = asWritten(link);
  const [name = '', ...rest] = pieces;
  const given = new Map(rest.filter((pair) => pair !== '').map(pairOf));
  const problems = misplaced(name || 'lab', given);
  const preset = presets.find((one) => one === given.get('preset')) ?? presets[0];
  /** @type {LinkedRun} */
  const first = {
    part: name === 'lesson' || pageNames.includes(name) ? name : 'lab',
    preset,
    experiment: completed(preset),
    generation: 0,
    drives: 'evolved',
    gains: null,
    others: {},
    problems,
  };
  const { opened, refused } = readAll(given, first, (run, key, value) => {
    if (Object.hasOwn(keys, key)) return keys[key](run, value);
    if (!isField(key, run.experiment)) return kept(run, key, value);
    return { ...run, experiment: completed(preset, withField(run.experiment, pathOf(key), value)) };
  });
  problems.push(...refused.map(([key, error]) => `${key}: ${/** @type {Error} */ (error).message}`));
  if (!isWhole) problems.push(words.longLink(mostCharacters, mostPairs));
  if (opened.drives !== 'hand' || opened.gains !== null) return opened;
  problems.push(`drives: ${words.noGains}`);
  return { ...opened, drives: 'evolved' };
}
