// Every word about the page's checks of its own numbers.
/** @import { Group, Outcome, Sentences, Task } from '../../../core/checks/check.js' */
/** @import { Preset } from '../../../core/engine.js' */
import { valuesText } from './common.js';

export * from './common.js';

export const texts = {
  checksHelp:
    'Known values and laws, worked out anew by this browser. The program’s own tests compare with the same known values, natively and in Node.',
  checksCopy: 'Copy as text',
  checksProgress: 'Checks that are done',
  checksList: 'The checks',
  checksText: 'The checks as text',
};

/** @type {Readonly<Record<Group, string>>} */
export const groups = {
  motion: 'The robot',
  cost: 'The cost J',
  evolution: 'Evolution',
  bits: 'The same bits on every machine',
};

/** @type {Readonly<Record<Preset, string>>} */
const limits = {
  'velocity-limits': 'velocities limited',
  'acceleration-limits': 'velocities and accelerations limited',
};

/** @type {Readonly<Record<Exclude<Task, 'parking'>, string>>} */
const tasks = {
  noise: 'In random disturbance',
  tracking: 'Behind a moving reference',
  unlimited: 'Without limits',
};

/** @type {Sentences} */
export const sentences = {
  command: (number) => [
    `At posture ${number} the control law (5) commands what an independent program computed.`,
    'v, ω',
  ],
  errorPosture: (count) => [
    `The error posture is that of equation (3), for ${count} pairs of robot and goal.`,
    'largest difference',
  ],
  lyapunovRate: (count) => [
    `Without limits V falls as our proof of Theorem 1 says, V̇ = −kx xₑ² cos² θₑ − ky yₑ⁴ − kθ sin² θₑ, at ${count} postures.`,
    'largest relative difference',
  ],
  halfArcs: (count) => [`Two half arcs lead where the whole arc leads, ${count} times.`, 'largest distance'],
  circle: (count) => [
    `Each of ${count} arcs ends on the circle that the kinematics (2) describe.`,
    'largest distance',
  ],
  speeds: (count) => [`No velocity exceeds its limit, in ${count} drives.`, 'largest |v|, |ω|'],
  accelerations: (count) => [
    `No acceleration exceeds its limit, in ${count} drives.`,
    'largest |dv/dt|, |dω/dt|',
  ],
  limitsTwice: (count) => [
    `To limit a command twice is to limit it once, at every sample of ${count} drives.`,
    'velocities that differ',
  ],
  mirror: (count) => [
    `Left and right are alike: a mirrored task costs ${count} robots the same.`,
    'J that differ',
  ],
  parked: (count) => [`Kanayama’s rule never turns while the goal rests, in ${count} drives.`, 'largest |ω|'],
  run: (preset, gains, withPosture) => [
    `The gains ${gains.join(', ')} cost what an independent program computed, with ${limits[preset]}.`,
    withPosture ? 'J, t_f, x, y, θ' : 'J, t_f',
  ],
  paperOrder: () => [
    'In both experiments the gains that the paper evolved cost less than its arbitrary ones, as in the paper.',
    'both J',
  ],
  parts: (count) => [
    `J is equation (9), added up again from the paths of ${count} drives.`,
    'largest relative difference',
  ],
  lanes: (count, preset) => [
    `${count} robots driven at once cost what each costs alone, with ${limits[preset]}.`,
    'J that differ in any bit',
  ],
  lanesFromStarts: (count) => [
    `So they do from ${count} starts in random disturbance.`,
    'J that differ in any bit',
  ],
  mapRows: (rows) => [
    `A map of J in ${rows} separate rows is the map in one piece.`,
    'cells that differ in any bit',
  ],
  learningRates: () => ['τ = 1/√(2√n) and τ′ = 1/√(2n), with n = 3 gains.', 'τ, τ′'],
  offspringGains: (generations) => [
    `In ${generations} generations every offspring has the gains k′ = k + σ N(0, 1), with its parent’s σ.`,
    'gains that differ in any bit',
  ],
  offspringSigmas: () => [
    'Every offspring has the step sizes σ′ = σ exp(τ′ N(0, 1) + τ N(0, 1)).',
    'largest relative difference',
  ],
  drawMean: () => ['The random draws of these generations have a mean near 0.', 'mean'],
  drawVariance: () => ['They have a variance near 1.', 'variance'],
  drawCorrelation: () => ['The draws for k and for σ are uncorrelated.', 'correlation'],
  offspringCosts: () => [
    'Every offspring has the J that its gains cost when they drive again.',
    'J that differ in any bit',
  ],
  strangers: () => ['Nobody meets itself in a tournament.', 'such bouts'],
  wins: () => ['Every number of wins is right, counted again bout by bout.', 'wrong numbers'],
  survivors: () => [
    'The survivors are those with the most wins; among equals, those with the lower J.',
    'places that differ',
  ],
  parents: () => [
    'The survivors of a generation are the parents of the next, with their σ.',
    'numbers that differ in any bit',
  ],
  neverWorse: (generations) => [
    `From generation to generation the best J never rises, in ${generations} generations.`,
    'times that it rises',
  ],
  optimum: (generations) => [
    `After ${generations} generations the best J is near 7.70, the lowest that an independent program found.`,
    'J',
  ],
  hash: (task, preset, seed, generations) => [
    `${task === 'parking' ? `With ${limits[preset]}` : tasks[task]}, ${generations} generations with seed ${seed} come to the known fingerprint.`,
    'fingerprint',
  ],
  watched: (generations) => [
    `An evolution takes the same course if it is looked into, for ${generations} generations.`,
    'fingerprint',
  ],
  draws: (seed) => [`The first random draws with seed ${seed} are the known ones.`, 'numbers that differ'],
  worker: (generations) => [
    `A worker evolves ${generations} generations to the same bits as the page itself.`,
    'fingerprint',
  ],
};

/** What must come out. @param {Outcome} outcome */
export function expectedText(outcome) {
  const values = valuesText(outcome.expected, outcome);
  switch (outcome.bound) {
    case 'atMost':
      return `at most ${values}`;
    case 'below':
      return `less than ${values}`;
    case 'between':
      return `from ${values.replace(', ', ' to ')}`;
    default:
      return values;
  }
}

export const expectedWord = 'expected';
export const foundWord = 'found';

/** @param {boolean} passed */
export const verdict = (passed) => (passed ? 'passed' : 'failed');

export const checking = 'Checking …';

/** @param {number} failed @param {number} count @param {number} milliseconds */
export function summary(failed, count, milliseconds) {
  const time = `in ${(milliseconds / 1000).toFixed(2)} s`;
  return failed === 0
    ? `All ${count} checks passed, ${time}.`
    : `${failed} of ${count} checks failed, ${time}. These numbers cannot be trusted here.`;
}

/** @param {string} reason */
export const unfinished = (reason) => `The checks could not be finished: ${reason}`;

export const copied = 'The text is copied.';
export const notCopied = 'This browser lets no page copy: the text is selected, copy it with the keyboard.';
