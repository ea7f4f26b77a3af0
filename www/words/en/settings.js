// Every word of the settings.
/** @import { SettingWords } from '../common/settings.js' */
import { namer } from '../common/settings.js';
import { wasText } from './numbers.js';
export * from '../common/settings.js';

/** @typedef {keyof typeof groups} GroupName */

export const texts = {
  settingsTitle: 'Settings',
  closeSettings: 'Close the settings',
  backToPreset: 'Back to the preset',
  undo: 'Undo',
  redo: 'Redo',
};

/** @param {number} changed */
export const buttonText = (changed) => (changed === 0 ? 'Settings' : `Settings · ${changed}`);

/** @param {number} changed */
export const changedText = (changed) => (changed === 0 ? 'As in the preset' : `${changed} changed`);

export const hint = 'Point at a setting, or touch it, to read what it does.';

export const groups = {
  limits: 'Limits',
  weights: 'Cost J',
  task: 'Start and goal',
  arrival: 'Arrival and time',
  law: 'Control law',
  disturbance: 'Disturbance',
  evolution: 'Evolution',
  method: 'Method and ingredients',
};

/** Names and help, by the path in the experiment. @type {Readonly<Record<string, SettingWords>>} */
export const settings = {
  'limits.speed': { name: 'Speed', help: 'The robot can drive no faster than this, forwards or backwards.' },
  'limits.turnRate': { name: 'Turn rate', help: 'The robot can turn no faster than this.' },
  'limits.acceleration': { name: 'Acceleration', help: 'The speed can change no faster than this.' },
  'limits.turnAcceleration': {
    name: 'Turn acceleration',
    help: 'The turn rate can change no faster than this.',
  },
  'weights.final[0]': { name: 'Final x', help: 'How much it costs to end beside the goal in x.' },
  'weights.final[1]': { name: 'Final y', help: 'How much it costs to end beside the goal in y.' },
  'weights.final[2]': { name: 'Final heading', help: 'How much it costs to end with a wrong heading.' },
  'weights.velocity[0]': {
    name: 'Driving fast',
    help: 'How much speed costs: the more, the slower the robots that evolution prefers.',
  },
  'weights.velocity[1]': {
    name: 'Turning fast',
    help: 'How much turning costs: the more, the gentler the curves that evolution prefers.',
  },
  'weights.penalty': { name: 'Negative gains', help: 'What one unit of a gain below zero costs.' },
  'starts[0].x': { name: 'Start x', help: 'Where the robot starts; you can also drag it on the plane.' },
  'starts[0].y': { name: 'Start y', help: 'Where the robot starts; you can also drag it on the plane.' },
  'starts[0].theta': {
    name: 'Start heading',
    help: 'Which way the robot points when it starts; 90° is straight up the plane.',
  },
  'goal.x': { name: 'Goal x', help: 'Where the robot should stop; you can also drag it on the plane.' },
  'goal.y': { name: 'Goal y', help: 'Where the robot should stop; you can also drag it on the plane.' },
  'goal.theta': { name: 'Goal heading', help: 'Which way the robot should point in the end.' },
  'referenceVelocity.linear': {
    name: 'Reference speed',
    help: '0 means parking. With a speed, the reference leaves the goal and the robot follows it until the horizon.',
  },
  'referenceVelocity.angular': {
    name: 'Reference turn rate',
    help: 'How fast the moving reference turns.',
  },
  'tolerance.position': {
    name: 'Position tolerance',
    help: 'Within this distance of the goal the robot has arrived, if its heading is right too.',
  },
  'tolerance.heading': {
    name: 'Heading tolerance',
    help: 'Within this angle of the goal’s heading the robot has arrived, if its position is right too.',
  },
  'tolerance.speed': {
    name: 'Speed tolerance',
    help: 'A robot that drives faster than this has not arrived yet. Without it, speed is not looked at.',
  },
  'tolerance.turnRate': {
    name: 'Turn rate tolerance',
    help: 'A robot that turns faster than this has not arrived yet. Without it, turning is not looked at.',
  },
  horizon: { name: 'Horizon', help: 'A robot that has not arrived by then is stopped.' },
  sampleTime: { name: 'Sample time', help: 'The time from one command of the controller to the next.' },
  law: {
    name: 'Law',
    help: 'What turns the error into a command. Kanayama’s rule cannot turn a robot that has to park.',
    choices: { 'shim-kim': 'Shim and Kim 1994', kanayama: 'Kanayama et al. 1990' },
  },
  'disturbance.kind': {
    name: 'Kind',
    help: 'Added to the velocity of every robot, also of those that evolution drives.',
    choices: { none: 'none', random: 'random', slip: 'constant slip' },
  },
  'disturbance.linear': {
    name: 'On the speed',
    help: 'The bound of a random disturbance, or the slip itself.',
  },
  'disturbance.angular': {
    name: 'On the turn rate',
    help: 'The bound of a random disturbance, or the slip itself.',
  },
  'disturbance.seed': { name: 'Seed of the noise', help: 'The same seed gives the same noise.' },
  'evolution.population': { name: 'Population', help: 'How many robots survive each generation.' },
  'evolution.opponents': {
    name: 'Opponents',
    help: 'How many others each robot meets in the tournament: more of them make it stricter.',
  },
  'evolution.seed': { name: 'Seed', help: 'The same seed gives the same evolution, on every machine.' },
  'evolution.initialRange[0]': {
    name: 'First gains from',
    help: 'The first gains are drawn at random from here …',
  },
  'evolution.initialRange[1]': { name: 'First gains to', help: '… to here.' },
  'evolution.initialSigma': {
    name: 'First σ',
    help: 'How far the first offspring jump from their parents; evolution adapts it.',
  },
  'evolution.method': {
    name: 'Method',
    help: 'How gains are looked for: by the paper’s evolutionary programming, or by a rival.',
    choices: {
      ep: 'evolutionary programming',
      random: 'random search',
      de: 'differential evolution',
      'cma-es': 'CMA-ES',
      'one-plus-one-es': '(1+1)-ES, 1/5 rule',
      'nelder-mead': 'Nelder–Mead',
      'one-at-a-time': 'one gain at a time',
      'finite-differences': 'down the slope',
    },
  },
  'evolution.belowZero': {
    name: 'Gains below 0',
    help: 'Tried, which costs a penalty; or mirrored at 0, or held at 0, before they are tried.',
    choices: { penalty: 'penalty', mirror: 'mirrored', clamp: 'held at 0' },
  },
  'evolution.step': {
    name: 'Steps',
    help: 'How mutations are distributed: Cauchy steps are small less often, and at times much larger.',
    choices: { gaussian: 'Gaussian', cauchy: 'Cauchy' },
  },
  'evolution.adaptation': {
    name: 'Self-adaptation',
    help: 'A factor on τ and τ′, with which every σ changes; with 0 every σ stays as it is.',
  },
  'evolution.sigmaFloor': { name: 'Least σ', help: 'No σ falls below this.' },
  'evolution.selection': {
    name: 'Survival',
    help: 'Who survives: who wins the most bouts, who costs least, or the better of parent and offspring.',
    choices: { tournament: 'tournament', truncation: 'lowest J', parent: 'offspring against parent' },
  },
  'evolution.crossover': {
    name: 'Crossover',
    help: 'How often a parent is mixed with another one, gain by gain, before it is mutated.',
  },
};

/** What the core says, with the names on screen; some of its paths have no row. */
export const named = namer({ ...settings, 'evolution.initialRange': { name: 'First gains from … to' } });

export const noLimit = 'no limit';

/** @param {string} name */
export const limitLabel = (name) => `Limit: ${name.toLowerCase()}`;
/** @param {string} name @param {string} value */
export const backLabel = (name, value) => `${name}: back to ${value}`;

/** @param {{ integer: boolean, from: string, to: string }} range */
export const rangeText = ({ integer, from, to }) =>
  `${integer ? 'a whole number' : 'a number'} from ${from} to ${to}`;
/** @param {string} name @param {string} expected @param {string} was */
export const refused = (name, expected, was) => `${name} must be ${expected}; ${wasText(was)}`;
/** @param {string} name @param {string} help @param {string} range */
export const helpText = (name, help, range) => `${name}: ${help}${range ? ` Allowed: ${range}.` : ''}`;
