// The link is the run: everything that defines what is on screen, as short readable text, and back again.
//
// #part&key=value&…: only what differs from the preset. Keys are the core's own names of the experiment's fields.
import { gainNames } from './landscape/request.js';
import { noTrial, pageNames } from './state.js';
import { numberOf } from './words/en/numbers.js';
import * as words from './words/en/link.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./engine.js').Experiment} Experiment */
/** @typedef {import('./engine.js').Posture} Posture */
/** @typedef {import('./engine.js').Preset} Preset */
/** @typedef {import('./landscape/request.js').AxisChoice} AxisChoice */
/** @typedef {import('./state.js').Driver} Driver */
/** @typedef {import('./state.js').State} State */
/** @typedef {import('./state.js').Triple} Triple */
/** What a link can carry. @typedef {Pick<State, 'page' | 'preset' | 'experiment' | 'generation' | 'driver' | 'handGains' | 'trial' | 'landscape'>} Linked */
/** @typedef {Omit<Linked, 'landscape'> & { landscape: Pick<State['landscape'], 'x' | 'y' | 'third'> }} Opened */

const version = 1;
/** @type {readonly Preset[]} */
const presets = ['velocity-limits', 'acceleration-limits'];
/** @type {readonly Driver[]} */
const drivers = ['evolved', 'hand', 'paper-ep', 'paper-arbitrary'];
const plainAxes = { x: 'kx', y: 'ktheta' };

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

/** The text after # for a state. @param {Linked} state @param {(preset: Preset) => Experiment} experimentOf */
export function linkOf(state, experimentOf) {
  const { page, preset, experiment, generation, driver, handGains, trial, landscape } = state;
  const usual = fieldsOf(experimentOf(preset));
  const changed = [...fieldsOf(experiment)].filter(([path, value]) => value !== usual.get(path));
  /** @type {[string, string][]} */
  const pairs = [
    ...(preset === presets[0] ? [] : [/** @type {[string, string]} */ (['preset', preset])]),
    ...changed.map(([path, value]) => /** @type {[string, string]} */ ([nameOf(path), value])),
  ];
  if (generation > 0) pairs.push(['generation', String(generation)]);
  if (driver !== 'evolved') pairs.push(['drives', driver]);
  if (handGains) pairs.push(['gains', handGains.map(numberText).join(',')]);
  if (trial.start) pairs.push(['from', postureText(trial.start)]);
  if (trial.disturbance && page === 'disturbance') pairs.push(['under', disturbanceText(trial.disturbance)]);
  for (const axis of /** @type {const} */ (['x', 'y'])) {
    const text = axisText(landscape[axis]);
    if (text !== plainAxes[axis]) pairs.push([axis, text]);
  }
  if (landscape.third !== null) pairs.push(['third', numberText(landscape.third)]);
  if (pairs.length > 0) pairs.unshift(['v', String(version)]);
  return [page, ...pairs.map(([key, value]) => `${key}=${encoded(value)}`)].join('&');
}

/**
 * What a link asks for. What it has wrong is named, and the rest is used.
 * @param {string} link the text after # @param {Engine} engine
 * @returns {{ opened: Opened, problems: string[] }}
 */
export function openLink(link, engine) {
  const [name, ...rest] = link.split('&');
  const page = pageNames.find((known) => known === (name || 'lab'));
  const problems = page ? [] : [words.unknownPart(decoded(name), pageNames)];
  const pairs = rest.filter((text) => text !== '').map(pairOf);
  const given = new Map(pairs);
  const preset = presets.find((known) => known === given.get('preset')) ?? presets[0];
  /** @type {Opened} */
  const opened = {
    page: page ?? 'lab',
    preset,
    experiment: engine.experiment(preset),
    generation: 0,
    driver: 'evolved',
    handGains: null,
    trial: noTrial,
    landscape: { x: axisOf(plainAxes.x), y: axisOf(plainAxes.y), third: null },
  };
  for (const [key, value] of given) {
    try {
      read(opened, key, value, engine);
    } catch (error) {
      problems.push(words.ignored(key, error instanceof Error ? error.message : String(error)));
    }
  }
  if (opened.driver === 'hand' && opened.handGains === null) {
    problems.push(words.ignored('drives', words.noGains));
    opened.driver = 'evolved';
  }
  if (opened.landscape.x.gain === opened.landscape.y.gain) {
    problems.push(words.ignored('y', words.expected(words.otherGain, opened.landscape.y.gain)));
    opened.landscape.y = axisOf(plainAxes[opened.landscape.x.gain === 'ktheta' ? 'x' : 'y']);
  }
  return { opened, problems };
}

/** Puts one value of a link where it belongs; throws if it cannot. @param {Opened} opened @param {string} key @param {string} value @param {Engine} engine */
function read(opened, key, value, engine) {
  switch (key) {
    case 'v':
      if (value !== String(version)) throw new Error(words.otherVersion(value, version));
      return;
    case 'preset':
      oneOf(presets, value);
      return;
    case 'generation':
      opened.generation = wholeNumber(value, 100_000);
      return;
    case 'drives':
      opened.driver = oneOf(drivers, value);
      return;
    case 'gains':
      opened.handGains = triple(value);
      // The core knows which gains cannot be driven.
      engine.drive(opened.experiment, [opened.handGains]);
      return;
    case 'from': {
      const start = posture(value);
      engine.experiment({ starts: [start] });
      opened.trial = { ...opened.trial, start };
      return;
    }
    case 'under': {
      const disturbance = disturbanceOf(value);
      opened.trial = { ...opened.trial, disturbance: engine.experiment({ disturbance }).disturbance };
      return;
    }
    case 'x':
    case 'y':
      opened.landscape = { ...opened.landscape, [key]: axisOf(value) };
      return;
    case 'third':
      opened.landscape = { ...opened.landscape, third: number(value) };
      return;
    default:
      opened.experiment = engine.experiment(withField(opened.experiment, pathOf(key), value));
  }
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
    else
      fields.set(
        path,
        value === null ? 'off' : typeof value === 'number' ? fieldText(path, value) : String(value),
      );
  };
  walk(experiment, '');
  return fields;
}

/** The experiment with one field read from text. @param {Experiment} experiment @param {string} path @param {string} text */
function withField(experiment, path, text) {
  if (!fieldsOf(experiment).has(path)) throw new Error(words.unknownField);
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

/** @param {number} value The shortest text that gives back the same bits. */
const numberText = (value) => (Object.is(value, -0) ? '-0' : String(value));

/** @param {string} path @param {number} value */
const fieldText = (path, value) => (path.endsWith('theta') ? angleText(value) : numberText(value));

/** An angle in degrees where that gives back the same bits, else in radians. @param {number} radians */
function angleText(radians) {
  const degrees = numberText(Number(((radians * 180) / Math.PI).toFixed(9)));
  return angle(`${degrees}deg`) === radians ? `${degrees}deg` : numberText(radians);
}

/** @param {string} text */
const angle = (text) => (text.endsWith('deg') ? (number(text.slice(0, -3)) * Math.PI) / 180 : number(text));

/** @param {Posture} posture */
const postureText = ({ x, y, theta }) => [numberText(x), numberText(y), angleText(theta)].join(',');

/** @param {string} text @returns {Posture} */
function posture(text) {
  const parts = text.split(',');
  if (parts.length !== 3) throw new Error(words.expected(words.aPosture, text));
  return { x: number(parts[0]), y: number(parts[1]), theta: angle(parts[2]) };
}

/** @param {Experiment['disturbance']} disturbance */
const disturbanceText = ({ kind, linear, angular, seed }) =>
  [kind, numberText(linear), numberText(angular), String(seed)].join(',');

/** @param {string} text @returns {Experiment['disturbance']} */
function disturbanceOf(text) {
  const [kind, ...numbers] = text.split(',');
  const [linear, angular, seed] = numbers.map(number);
  return { kind: /** @type {Experiment['disturbance']['kind']} */ (kind), linear, angular, seed };
}

/** @param {AxisChoice} axis */
const axisText = ({ gain, log }) => (log ? `${gain}-log` : gain);

/** @param {string} text @returns {AxisChoice} */
const axisOf = (text) => ({ gain: oneOf(gainNames, text.replace(/-log$/, '')), log: text.endsWith('-log') });

/** @param {string} text @returns {Triple} */
function triple(text) {
  const gains = text.split(',').map(number);
  if (gains.length !== 3) throw new Error(words.expected(words.threeNumbers, text));
  return /** @type {[number, number, number]} */ (gains);
}

/** @param {string} text */
function number(text) {
  const value = numberOf(text);
  if (!Number.isFinite(value)) throw new Error(words.expected(words.aNumber, text));
  return value;
}

/** @param {string} text @param {number} most */
function wholeNumber(text, most) {
  const value = numberOf(text);
  if (!Number.isInteger(value) || value < 0 || value > most)
    throw new Error(words.expected(words.wholeNumber(most), text));
  return value;
}

/** @template {string} T @param {readonly T[]} choices @param {string} text */
function oneOf(choices, text) {
  const found = choices.find((choice) => choice === text);
  if (found === undefined) throw new Error(words.expected(words.oneOf(choices), text));
  return found;
}

/** @param {string} text @returns {[string, string]} */
function pairOf(text) {
  const at = text.indexOf('=');
  return at < 0 ? [decoded(text), ''] : [decoded(text.slice(0, at)), decoded(text.slice(at + 1))];
}

/** Only what would end a value, or what browsers change, is written as %. @param {string} text */
const encoded = (text) => encodeURIComponent(text).replaceAll('%2C', ',').replaceAll('%3B', ';');

/** @param {string} text */
function decoded(text) {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
