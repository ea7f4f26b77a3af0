// The link is the run: everything that defines what is on screen, as short readable text, and back again.
//
// #part&key=value&…: only what differs from the preset. Keys are the core's own names of the experiment's fields.
import { groupNames, mostOfTask, noExercise, tidyTask } from '../run/exercise.js';
import { firstGeneration, phases } from '../parts/generation/record.js';
import { firstLandscape } from '../parts/landscape/request.js';
import {
  angle,
  angleText,
  axisOf,
  axisText,
  decoded,
  disturbanceOf,
  disturbanceText,
  encoded,
  number,
  numberText,
  oneOf,
  pairOf,
  posture,
  postureText,
  triple,
  wellFormed,
  wholeNumber,
} from './values.js';
import { linkOfStep, steps } from '../lesson/steps.js';
import { messageOf } from '../words/errors.js';
import { noPins, styles } from '../run/pins.js';
import { headings } from '../parts/robustness/grid.js';
import { firstRobustness, halves } from '../parts/robustness/request.js';
import { finds, noTrial, pageNames } from '../run/state.js';
import { link as words } from '../words/index.js';
import { language, languageNames, usualLanguage } from '../words/language.js';

/** @typedef {import('../core/engine.js').Engine} Engine */
/** @typedef {import('../core/engine.js').Experiment} Experiment */
/** @typedef {import('../core/engine.js').Preset} Preset */
/** @typedef {import('../run/exercise.js').Exercise} Exercise */
/** @typedef {import('../run/pins.js').Pin} Pin */
/** @typedef {import('../run/state.js').Driver} Driver */
/** @typedef {import('../run/state.js').State} State */
/** @typedef {import('../words/language.js').Language} Language */
/** @typedef {(preset: Preset) => Experiment} ExperimentOf */

/**
 * What the parts show, beside the run itself.
 * @typedef {object} View
 * @property {Pick<State['anatomy'], 'phase' | 'chosen'>} anatomy
 * @property {Pick<State['curves'], 'view' | 'lab' | 'scale'>} curves
 * @property {Pick<State['landscape'], 'x' | 'y' | 'third'>} landscape
 * @property {Pick<State['robustness'], 'quantity' | 'half' | 'heading'>} robustness
 */
/** @typedef {Pick<State, 'page' | 'lesson' | 'preset' | 'experiment' | 'generation' | 'driver' | 'handGains' | 'found' | 'trial' | 'pins' | 'exercise'>} Run */
/** What a link carries. @typedef {Run & View} Linked */
/** @typedef {Run & { view: View }} Opened */

const version = 1;
/** Links are short; what is longer was not written here. */
export const mostCharacters = 20_000;
/** @type {readonly Preset[]} */
const presets = ['velocity-limits', 'acceleration-limits'];
/** @type {readonly Driver[]} */
const drivers = ['evolved', 'hand', 'paper-ep', 'paper-arbitrary'];

/** @type {View} */
const usualView = {
  anatomy: { phase: firstGeneration.phase, chosen: null },
  curves: { view: 'time', lab: 'cost', scale: 'linear' },
  landscape: { x: firstLandscape.x, y: firstLandscape.y, third: null },
  robustness: { quantity: firstRobustness.quantity, half: firstRobustness.half, heading: null },
};

/** @template T @typedef {{ key: string, of: (view: View) => T, with: (view: View, value: T) => View, text: (value: T) => string, read: (text: string) => T }} ViewKey */

/**
 * One thing that a part shows.
 * @template {keyof View} P @template {keyof View[P]} F
 * @param {string} key @param {P} part @param {F} field
 * @param {(text: string) => View[P][F]} read @param {(value: View[P][F]) => string} [text]
 * @returns {ViewKey<any>}
 */
const viewKey = (key, part, field, read, text = String) => ({
  key,
  of: (view) => view[part][field],
  with: (view, value) => ({ ...view, [part]: { ...view[part], [field]: value } }),
  text,
  read,
});

const viewKeys = [
  viewKey('phase', 'anatomy', 'phase', (text) => oneOf(phases, text)),
  viewKey('individual', 'anatomy', 'chosen', (text) => wholeNumber(text, 3999)),
  viewKey('view', 'curves', 'view', (text) => oneOf(['time', 'stability', 'compare', 'numbers'], text)),
  viewKey('curve', 'curves', 'lab', (text) => oneOf(['cost', 'sigmas'], text)),
  viewKey('scale', 'curves', 'scale', (text) => oneOf(['linear', 'log'], text)),
  viewKey('x', 'landscape', 'x', axisOf, axisText),
  viewKey('y', 'landscape', 'y', axisOf, axisText),
  viewKey('third', 'landscape', 'third', number, (value) => (value === null ? '' : numberText(value))),
  viewKey('colour', 'robustness', 'quantity', (text) => oneOf(['share', 'time', 'cost'], text)),
  viewKey('half', 'robustness', 'half', (text) => Number(oneOf(halves.map(String), text))),
  viewKey('heading', 'robustness', 'heading', (text) => wholeNumber(text, headings - 1)),
];

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
const pathOf = (name) => shortNames.find(([, short]) => short === name)?.[0] ?? name;

/** The text after # for a state. @param {Linked} state @param {ExperimentOf} experimentOf @param {Language} [read] The language of who opens it. */
export function linkOf(state, experimentOf, read = language) {
  const { page, lesson, preset, generation, driver, handGains, found, trial, pins } = state;
  /** @type {[string, string][]} */
  const pairs = preset === presets[0] ? [] : [['preset', preset]];
  pairs.push(...changesOf(state.experiment, experimentOf(preset)));
  if (generation > 0) pairs.push(['generation', String(generation)]);
  if (driver !== 'evolved') pairs.push(['drives', driver]);
  if (handGains) pairs.push(['gains', handGains.map(numberText).join(',')]);
  if (handGains && found !== 'hand') pairs.push(['found', found]);
  if (trial.start) pairs.push(['from', postureText(trial.start)]);
  if (trial.disturbance && page === 'disturbance') pairs.push(['under', disturbanceText(trial.disturbance)]);
  for (const { key, of, text } of viewKeys)
    if (of(state) !== null && text(of(state)) !== text(of(usualView))) pairs.push([key, text(of(state))]);
  for (const pin of pins) pairs.push([`pin${pin.slot + 1}`, pinText(pin, experimentOf(preset))]);
  if (lesson > 0) pairs.push(['lesson', String(lesson)]);
  pairs.push(...exercisePairs(state.exercise));
  if (read !== usualLanguage) pairs.unshift(['lang', read]);
  if (pairs.length > 0) pairs.unshift(['v', String(version)]);
  return [page, ...pairs.map(([key, value]) => `${key}=${encoded(value)}`)].join('&');
}

/** A link with an exercise, for who goes on within it. @param {string} link @param {Exercise} exercise */
export const withExercise = (link, exercise) =>
  [link, ...exercisePairs(exercise).map(([key, value]) => `${key}=${encoded(value)}`)].join('&');

/** @param {Exercise} exercise @returns {[string, string][]} */
function exercisePairs({ task, locked, hidden }) {
  /** @type {[string, string][]} */
  const pairs = [
    ['lock', locked.join(',')],
    ['hide', hidden.join(',')],
    ['task', tidyTask(task)],
  ];
  return pairs.filter(([, value]) => value !== '');
}

/**
 * What a link asks for. What it has wrong is named, and the rest is used.
 * @param {string} link the text after # @param {Engine} engine
 * @returns {{ opened: Opened, problems: string[] }}
 */
export function openLink(link, engine) {
  const [name, ...rest] = stepLink(link.slice(0, mostCharacters)).split('&');
  const page = pageNames.find((known) => known === (name || 'lab'));
  const problems = page ? [] : [words.unknownPart(decoded(name), pageNames)];
  if (link.length > mostCharacters) problems.push(words.longLink(mostCharacters));
  const given = new Map(rest.filter((text) => text !== '').map(pairOf));
  const preset = presets.find((known) => known === given.get('preset')) ?? presets[0];
  /** @type {Opened} */
  let opened = {
    page: page ?? 'lab',
    lesson: 0,
    preset,
    experiment: engine.experiment(preset),
    generation: 0,
    driver: 'evolved',
    handGains: null,
    found: 'hand',
    trial: noTrial,
    pins: noPins,
    exercise: noExercise,
    view: usualView,
  };
  /** @type {[string, string, unknown?][]} */
  let refused = [...given];
  let before;
  // A value may be allowed only beside one that comes after it, as a short sample time is with a short horizon.
  do {
    before = refused;
    refused = [];
    for (const [key, value] of before) {
      try {
        opened = read(opened, key, value, engine);
      } catch (error) {
        refused.push([key, value, error]);
      }
    }
  } while (refused.length < before.length);
  problems.push(...refused.map(([key, , error]) => words.ignored(key, messageOf(error))));
  if (opened.driver === 'hand' && opened.handGains === null) {
    problems.push(words.ignored('drives', words.noGains));
    opened = { ...opened, driver: 'evolved' };
  }
  if (opened.found !== 'hand' && opened.handGains === null) {
    problems.push(words.ignored('found', words.noGains));
    opened = { ...opened, found: 'hand' };
  }
  const { x, y } = opened.view.landscape;
  if (x.gain === y.gain) {
    problems.push(words.ignored('y', words.expected(words.otherGain, y.gain)));
    const other = axisOf(x.gain === 'ktheta' ? 'kx' : 'ktheta');
    opened = { ...opened, view: { ...opened.view, landscape: { ...opened.view.landscape, y: other } } };
  }
  return { opened, problems };
}

/** A step of the lesson may be asked for alone, as lesson&step=3. @param {string} link */
function stepLink(link) {
  const step = /^lesson(?:&(?:v|lang)=\w+)*(?:&step=(\d+))?(?:&(?:v|lang)=\w+)*$/.exec(link);
  return step ? linkOfStep(Math.min(Math.max(Number(step[1] ?? 1), 1), steps.length)) : link;
}

/** With one value of a link where it belongs; throws if it has no place. @param {Opened} opened @param {string} key @param {string} value @param {Engine} engine @returns {Opened} */
function read(opened, key, value, engine) {
  const viewed = viewKeys.find((one) => one.key === key);
  if (viewed) return { ...opened, view: viewed.with(opened.view, viewed.read(value)) };
  if (/^pin[1-4]$/.test(key))
    return {
      ...opened,
      pins: [...opened.pins, pinOf(value, Number(key.slice(3)) - 1, opened.preset, engine)],
    };
  switch (key) {
    case 'v':
      if (value !== String(version)) throw new Error(words.otherVersion(value, version));
      return opened;
    case 'lang':
      // The page has it already, when it is a link that was followed.
      oneOf(languageNames, value);
      return opened;
    case 'lesson':
      return { ...opened, lesson: wholeNumber(value, steps.length) };
    case 'preset':
      oneOf(presets, value);
      return opened;
    case 'generation':
      return { ...opened, generation: wholeNumber(value, 100_000) };
    case 'drives':
      return { ...opened, driver: oneOf(drivers, value) };
    case 'gains': {
      const handGains = triple(value);
      // The core knows which gains cannot be driven.
      engine.drive(opened.experiment, [handGains]);
      return { ...opened, handGains };
    }
    case 'found':
      return { ...opened, found: oneOf(finds, value) };
    case 'lock':
      return { ...opened, exercise: { ...opened.exercise, locked: groupsOf(value) } };
    case 'hide':
      return { ...opened, exercise: { ...opened.exercise, hidden: groupsOf(value) } };
    case 'task': {
      const task = tidyTask(value);
      if (task.length > mostOfTask) throw new Error(words.longTask(mostOfTask, task.length));
      return { ...opened, exercise: { ...opened.exercise, task } };
    }
    case 'from': {
      const start = posture(value);
      engine.experiment({ starts: [start] });
      return { ...opened, trial: { ...opened.trial, start } };
    }
    case 'under': {
      const { disturbance } = engine.experiment({ disturbance: disturbanceOf(value) });
      return { ...opened, trial: { ...opened.trial, disturbance } };
    }
    default:
      return { ...opened, experiment: engine.experiment(withField(opened.experiment, pathOf(key), value)) };
  }
}

/** Groups of controls, each once. @param {string} text */
function groupsOf(text) {
  const named = text.split(',').map((name) => oneOf(groupNames, name));
  return groupNames.filter((name) => named.includes(name));
}

/** A pinned run: its name, gains, and what its experiment has different. @param {Pin} pin @param {Experiment} usual */
function pinText({ name, gains, experiment }, usual) {
  const changes = changesOf(experiment, usual).map(([key, value]) => `${key}:${value}`);
  return [name.replaceAll('~', '-'), gains.map(numberText).join(','), ...changes].join('~');
}

/** @param {string} text @param {number} slot @param {Preset} preset @param {Engine} engine @returns {Pin} */
function pinOf(text, slot, preset, engine) {
  const [name, gainsText, ...changes] = text.split('~');
  if (gainsText === undefined || slot >= styles.length) throw new Error(words.expected(words.aPin, text));
  const gains = triple(gainsText);
  /** @param {string} change @returns {[string, string]} */
  const pathAndValue = (change) => {
    const at = Math.max(change.indexOf(':'), 0);
    return [pathOf(change.slice(0, at)), change.slice(at + 1)];
  };
  const changed = [...new Map(changes.map(pathAndValue))].reduce(
    (before, [path, value]) => withField(before, path, value),
    engine.experiment(preset),
  );
  const experiment = engine.experiment(changed);
  engine.drive(experiment, [gains]);
  return { slot, name: wellFormed(name.slice(0, 80)), experiment, gains };
}

/** What an experiment has different, as names and texts. @param {Experiment} experiment @param {Experiment} usual @returns {[string, string][]} */
function changesOf(experiment, usual) {
  const fields = fieldsOf(usual);
  return [...fieldsOf(experiment)]
    .filter(([path, value]) => value !== fields.get(path))
    .map(([path, value]) => [nameOf(path), value]);
}

/** Every number and word of an experiment by its path, as text. @param {Experiment} experiment @returns {Map<string, string>} */
function fieldsOf(experiment) {
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
}

/** The experiment with one field read from text. @param {Experiment} experiment @param {string} path @param {string} text */
function withField(experiment, path, text) {
  if (!fieldsOf({ ...experiment, starts: [] }).has(path)) throw new Error(words.unknownField);
  const copy = structuredClone(experiment);
  const keys = path.split('.');
  const last = /** @type {string} */ (keys.pop());
  /** @type {any} */
  let inner = copy;
  for (const key of keys) inner = inner[key];
  const before = inner[last];
  if (path === 'starts') inner[last] = text.split(';').map(posture);
  else if (Array.isArray(before)) inner[last] = text.split(',').map(number);
  else if (path === 'law' || path === 'disturbance.kind') inner[last] = text;
  else if (text === 'off') inner[last] = null;
  else inner[last] = path.endsWith('theta') ? angle(text) : number(text);
  return copy;
}
