// An exercise: a task in the words of who made the link, and which controls are locked or hidden for who follows it.
/** @import { Aim, Scale } from './aim.js' */
/** @import { State } from './state.js' */
/** @import { Varied } from './variant.js' */
import { digitsOf } from '../kit/hash.js';
import { remember } from '../kit/memo.js';
import { tidyText } from '../kit/text.js';

/** @typedef {typeof groupNames[number]} Group Controls that are locked or hidden together. */
/** @typedef {typeof ways[number]} Way From the freest on. */
/** Of the groups, what is in both is hidden; `vary`: what is drawn for each student. @typedef {{ task: string, locked: readonly Group[], hidden: readonly Group[], aim: Aim | null, scale: Scale | null, vary: readonly Varied[] }} Exercise */
/** @typedef {{ open: boolean, draft: Exercise }} MakerState An exercise in the making, which the page shows as it will be. */

const ways = /** @type {const} */ (['free', 'locked', 'hidden']);

export const groupNames = /** @type {const} */ ([
  'gains',
  'drives',
  'paper',
  'postures',
  'run',
  'seed',
  'clock',
  'settings',
  'parts',
  'lesson',
  'share',
]);

/** @type {Exercise} */
export const noExercise = Object.freeze({
  task: '',
  locked: [],
  hidden: [],
  aim: null,
  scale: null,
  vary: [],
});
/** @type {MakerState} */
export const firstMaker = { open: false, draft: noExercise };

/** A task is read beside the figure: longer ones belong on a page of their own. In UTF-16 units, as fields count them. */
export const mostOfTask = 300;

/** As the exercise says. @param {Exercise} exercise @param {Group} group @returns {Way} */
const wayGiven = ({ locked, hidden }, group) =>
  hidden.includes(group) ? 'hidden' : locked.includes(group) ? 'locked' : 'free';

/** In words, tables and tries the lesson tells the paper's gains and what they cost: it is hidden with them. @param {Exercise} exercise @param {Group} group */
export const isHiddenWithPaper = ({ hidden }, group) => group === 'lesson' && hidden.includes('paper');

/** @param {Exercise} exercise @param {Group} group @returns {Way} */
export const wayOf = (exercise, group) =>
  isHiddenWithPaper(exercise, group) ? 'hidden' : wayGiven(exercise, group);

/** Nothing of the page may show what the paper's gains are, or what they cost. @param {Pick<State, 'exercise' | 'maker'>} state */
export const hidesPaper = (state) => wayOf(shownExercise(state), 'paper') === 'hidden';

/** @param {Exercise} exercise @param {Group} group @param {Way} way @returns {Exercise} */
export function withWay(exercise, group, way) {
  const inOrder = (/** @type {Way} */ wanted) =>
    groupNames.filter((name) => (name === group ? way : wayGiven(exercise, name)) === wanted);
  return { ...exercise, locked: inOrder('locked'), hidden: inOrder('hidden') };
}

/** What is locked or hidden by either is so by both. */
const both = remember((/** @type {Exercise} */ exercise, /** @type {Exercise} */ draft) =>
  groupNames.reduce(
    (made, group) => withWay(made, group, stricter(wayGiven(exercise, group), wayGiven(draft, group))),
    draft,
  ),
);

/** @param {Way} one @param {Way} other @returns {Way} */
const stricter = (one, other) => ways[Math.max(ways.indexOf(one), ways.indexOf(other))];

/** The exercise that the page shows: the link's, or the one in the making, which frees nothing of the link's. @param {Pick<State, 'exercise' | 'maker'>} state */
export const shownExercise = ({ exercise, maker }) => (maker.open ? both(exercise, maker.draft) : exercise);

/** Digits for whose work on which exercise it is; none where no exercise is worked on. Seeds may be free. @param {Pick<State, 'exercise' | 'student'>} run */
export function workId({ exercise, student: { who, base } }) {
  if (isEmpty(exercise)) return '';
  const own = [exercise, who, base?.experiment];
  return digitsOf(JSON.stringify(own, (key, value) => (key === 'seed' ? 0 : value)));
}

/** There is something to do, and so something to hand in. @param {Exercise} exercise */
export const asksSomething = ({ task, aim, vary }) =>
  tidyText(task) !== '' || aim !== null || vary.length > 0;

/** @param {Exercise} exercise */
export const isEmpty = (exercise) =>
  !asksSomething(exercise) && exercise.locked.length === 0 && exercise.hidden.length === 0;
