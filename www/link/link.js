// The link is the run: everything that defines what is on screen, as short readable text, and back again.
//
// #part&key=value&…: only what differs from the preset. Keys are the core's own names of the experiment's fields, and those
// of the tables that are handed in.
/** @import { Engine, Experiment, Preset } from '../core/engine.js' */
/** @import { Places } from '../run/actions/basis.js' */
/** @import { Opened } from '../run/actions/page.js' */
/** @import { Language } from '../words/language.js' */
/** @import { Key, Linked, PartKey, Steps } from './keys.js' */
import { noExercise } from '../run/exercise.js';
import { noPins } from '../run/pins.js';
import { nothingDone, presets } from '../run/state.js';
import { nobody } from '../run/variant.js';
import { messageOf } from '../words/errors.js';
import { link as words } from '../words/index.js';
import { language, languageNames, usualLanguage } from '../words/language.js';
import { asGiven, exerciseKeys, givenKey, givenPairs, withVariant } from './exercise.js';
import { changesOf, namesIn, pathOf, withField } from './experiment.js';
import { driveKeys, lessonKey, pinKeys } from './keys.js';
import { sealOf } from './seal.js';
import { PartlyRead, readAll } from './together.js';
import { beginningOf, plainText, seenText } from '../kit/text.js';
import {
  decoded,
  encoded,
  mostCharacters,
  mostPairs,
  oneOf,
  pairOf,
  piecesOf,
  wellFormed,
} from './values.js';
import { percent } from '../kit/host.js';

/** @typedef {(preset: Preset) => Experiment} ExperimentOf */
/**
 * What the parts of the page and the lesson put into links.
 * @typedef {object} Tables
 * @property {readonly string[]} pages The names of the parts.
 * @property {Pick<Places, 'triesStarts' | 'triesDisturbance'>} places
 * @property {readonly PartKey[]} keys Of the parts.
 * @property {(opened: Opened, refuse: (key: string, why: string) => void) => Opened} mend What goes wrong only together.
 * @property {Steps} lesson
 */
/** @typedef {ReturnType<typeof createLinks>} Links */

const version = 1;
/** Of what is wrong, so much is said. */
const mostNamed = 5;
const mostOfName = 60;
const mostOfReason = 400;

/** What somebody wrote, within a sentence. @param {string} text */
const quoted = (text, most = mostOfName) => plainText(beginningOf(text, most));

/** Stands for no value in itself. @type {readonly Key[]} */
const signs = [
  {
    key: 'v',
    text: () => null,
    read(opened, text) {
      if (text !== String(version)) throw new Error(words.otherVersion(text, version));
      return opened;
    },
  },
  {
    // The page has it already, when it is a link that was followed.
    key: 'lang',
    text: () => null,
    read(opened, text) {
      oneOf(languageNames, text);
      return opened;
    },
  },
  {
    // What was handed in: it stays as long as the run is that one, also where it came in part.
    key: 'handin',
    text: () => null,
    read: (opened, text) => ({ ...opened, student: { ...opened.student, handin: text } }),
  },
  {
    key: 'preset',
    text: ({ preset }) => (preset === presets[0] ? null : preset),
    read(opened, text) {
      oneOf(presets, text);
      return opened;
    },
  },
];

/** @param {Tables} tables */
export function createLinks({ pages, places, keys: partKeys, mend, lesson }) {
  const keys = [...driveKeys(places), ...partKeys, ...pinKeys, lessonKey(lesson), ...exerciseKeys];
  /** What the parts show when a link says nothing of it. @type {Record<string, Record<string, unknown>>} */
  const usualParts = {};
  for (const { slice, field, stays } of partKeys)
    if (!stays) usualParts[slice.name] = { ...usualParts[slice.name], [field]: slice.first[field] };
  const known = new Map([...signs, ...keys, givenKey].map((row) => [row.key, row]));

  /** The text after # for a state. @param {Linked} all @param {ExperimentOf} experimentOf @param {Language} [read] The language of who opens it. */
  function linkOf(all, experimentOf, read = language) {
    const state = asGiven(all);
    const usual = experimentOf(state.preset);
    const pairs = [
      ...pairsOf(signs, state, usual),
      ...changesOf(state.experiment, usual),
      ...pairsOf(keys, state, usual),
      ...givenPairs(state, experimentOf),
    ];
    if (read !== usualLanguage) pairs.unshift(['lang', read]);
    if (pairs.length > 0) pairs.unshift(['v', String(version)]);
    const link = [state.page, ...pairs.map(written)].join('&');
    const { handin, of } = state.student;
    return handin && sealOf(link, '') === of ? `${link}&${written(['handin', handin])}` : link;
  }

  /**
   * What a link asks for. What it has wrong is named, and the rest is used.
   * @param {string} written the text after # @param {Engine} engine @param {string} [who] works on it, if the link does not say.
   * @returns {{ opened: Opened, problems: string[] }}
   */
  function openLink(written, engine, who = '') {
    const link = wellFormed(asWritten(written));
    const { pieces, isWhole } = piecesOf(link);
    const [name, ...rest] = whole(pieces.join('&'), lesson).split('&');
    const page = pages.find((one) => one === (name || 'lab'));
    const problems = page ? [] : [words.unknownPart(quoted(decoded(name)), [...pages, 'lesson'])];
    if (!isWhole) problems.push(words.longLink(mostCharacters, mostPairs));
    const given = new Map(rest.filter((text) => text !== '').map(pairOf));
    const step = aloneIn(link)?.step ?? given.get('lesson');
    if (step !== undefined && !lesson.named(step).isThere) problems.push(words.noStep(quoted(step)));
    const preset = presets.find((one) => one === given.get('preset')) ?? presets[0];
    const empty = {
      ...emptyRun(page ?? 'lab', preset, engine),
      student: { ...nobody, who: seenText(who) && who },
    };
    /** @type {Opened} */
    const first = { ...empty, parts: usualParts };
    const fields = namesIn(empty.experiment);
    // One for all, for there may be thousands.
    const stranger = new Error(words.unknownField);
    const { opened, refused } = readAll(given, first, (before, key, text) => {
      const row = known.get(key);
      if (row) return row.read(before, text, engine);
      const path = pathOf(key);
      if (!fields.has(path)) throw stranger;
      return { ...before, experiment: engine.experiment(withField(before.experiment, path, text)) };
    });
    problems.push(...ignoredOf(refused));
    const refuse = (/** @type {string} */ key, /** @type {string} */ why) => {
      problems.push(words.ignored(key, why));
    };
    const varied = withVariant(withGains(opened, refuse), refuse, engine.experiment);
    return { opened: withReceipt(mend(varied, refuse), (run) => linkOf(run, engine.experiment)), problems };
  }

  return {
    pages,
    places,
    keys,
    linkOf,
    openLink,
    /** The link of a step of the lesson. */
    linkOfStep: lesson.linkOf,
    /** Everything that a link carries, to be compared with what it was. @param {Linked} state */
    carried: ({ page, lesson: step, preset, experiment, generation, driver, ...state }) => [
      ...[page, step, preset, experiment, generation, driver],
      ...[state.handGains, state.found, state.trial, state.pins, state.exercise, state.student],
      ...[state.work?.tries, state.work?.spent],
      ...partKeys.map(({ slice, field }) => slice.of(state)[field]),
    ],
  };
}

/** What was handed in stays beside the run that it came with. @param {Opened} opened @param {(run: Linked) => string} linkOf @returns {Opened} */
function withReceipt(opened, linkOf) {
  const { parts, student } = opened;
  if (!student.handin) return opened;
  const of = sealOf(linkOf({ ...opened, slices: parts }), '');
  return { ...opened, student: { ...student, of } };
}

/** What is said of the pairs that could not be read. @param {[key: string, error: unknown][]} refused */
function ignoredOf(refused) {
  const said = refused.slice(0, mostNamed).map(([key, error]) => {
    const say = error instanceof PartlyRead ? words.partlyIgnored : words.ignored;
    return say(quoted(key), quoted(messageOf(error), mostOfReason));
  });
  const more = refused.length - mostNamed;
  return more > 0 ? [...said, words.moreIgnored(more)] : said;
}

/** A step of the lesson may be asked for alone, as lesson&step=3; what else stands there is kept. @param {string} link @param {Steps} lesson */
function whole(link, lesson) {
  const alone = aloneIn(link);
  if (!alone) return link;
  return [lesson.linkOf(Math.max(lesson.named(alone.step).number, 1)), ...alone.pairs].join('&');
}

/** The step that is asked for alone, and the other pairs. @param {string} link */
function aloneIn(link) {
  const [name, ...pairs] = link.split('&');
  if (name !== 'lesson') return undefined;
  const isStep = (/** @type {string} */ pair) => pairOf(pair)[0] === 'step';
  const [, step] = pairOf(pairs.find(isStep) ?? 'step=1');
  return { step, pairs: pairs.filter((pair) => !isStep(pair)) };
}

/** A name may end as sentences do, of which its link may be the end. @param {readonly [string, string]} pair */
const written = ([key, value]) =>
  `${key}=${key === 'who' ? encoded(value).replace(/[^\w-]$/, percent) : encoded(value)}`;

/** @param {readonly Key[]} keys @param {Linked} state @param {Experiment} usual */
function pairsOf(keys, state, usual) {
  /** @type {[string, string][]} */
  const pairs = [];
  for (const { key, text } of keys) {
    const value = text(state, usual);
    if (value !== null) pairs.push([key, value]);
  }
  return pairs;
}

/** As it was written: from HTML `&` comes as `&amp;`, and learning platforms add `?name=value` to the end of an address. @param {string} link */
const asWritten = (link) => link.replaceAll('&amp;', '&').replace(/\?(?=\w+=)/g, '&');

/** The same link for who reads another language. @param {string} link @param {Language} read */
export function inLanguage(link, read) {
  const pairs = asWritten(link)
    .split('&')
    .filter((pair) => !pair.startsWith('lang='));
  return [...pairs, ...(read === usualLanguage ? [] : [written(['lang', read])])].join('&');
}

/** A link with an exercise, for who goes on within it: the exercise has its own experiment, and the link another. @param {string} link @param {Pick<Linked, 'exercise' | 'student'>} within @param {ExperimentOf} experimentOf */
export function withExercise(link, within, experimentOf) {
  // Another run does not drive again what was driven for the generation that is shown.
  const state = { .../** @type {Linked} */ (within), generation: 0 };
  const pairs = pairsOf(exerciseKeys, state, /** @type {Experiment} */ ({}));
  return [link, ...[...pairs, ...givenPairs(within, experimentOf)].map(written)].join('&');
}

/** @param {string} page @param {Preset} preset @param {Engine} engine @returns {Opened} */
const emptyRun = (page, preset, engine) => ({
  ...nothingDone,
  page,
  preset,
  experiment: engine.experiment(preset),
  pins: noPins,
  exercise: noExercise,
  student: nobody,
  parts: {},
});

/** Who drives by hand has gains. @param {Opened} opened @param {(key: string, why: string) => void} refuse @returns {Opened} */
function withGains(opened, refuse) {
  if (opened.handGains !== null) return opened;
  if (opened.driver === 'hand') refuse('drives', words.noGains);
  if (opened.found !== 'hand') refuse('found', words.noGains);
  return { ...opened, driver: opened.driver === 'hand' ? 'evolved' : opened.driver, found: 'hand' };
}
