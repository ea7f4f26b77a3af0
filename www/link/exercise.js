// What a link carries of an exercise: its task, what it locks and hides, when it is solved, and who works on it.
/** @import { Aim, Scale, Wanted } from '../run/aim.js' */
/** @import { Opened } from '../run/actions/page.js' */
/** @import { Key } from './keys.js' */
import { most } from '../run/aim.js';
import { groupNames, isEmpty, isHiddenWithPaper, mostOfTask, tidyTask } from '../run/exercise.js';
import { drawnFor, mostOfWho, variedNames } from '../run/variant.js';
import { link as words } from '../words/index.js';
import { number, numberText, oneOf } from './values.js';

/** @param {Opened} opened @param {Partial<import('../run/exercise.js').Exercise>} patch @returns {Opened} */
const asking = (opened, patch) => ({ ...opened, exercise: { ...opened.exercise, ...patch } });

/** @type {readonly Key[]} */
export const exerciseKeys = [
  {
    key: 'lock',
    text: ({ exercise }) => exercise.locked.join(',') || null,
    read: (opened, text) => asking(opened, { locked: severalOf(groupNames, text) }),
  },
  {
    key: 'hide',
    text: ({ exercise }) => exercise.hidden.join(',') || null,
    read: (opened, text) => asking(opened, { hidden: severalOf(groupNames, text) }),
  },
  {
    key: 'task',
    text: ({ exercise }) => tidyTask(exercise.task) || null,
    read(opened, text) {
      const task = tidyTask(text);
      if (task.length > mostOfTask) throw new Error(words.longTask(mostOfTask, task.length));
      return asking(opened, { task });
    },
  },
  {
    key: 'aim',
    text: ({ exercise }) => exercise.aim && aimText(exercise.aim),
    read: (opened, text) => asking(opened, { aim: aimOf(text) }),
  },
  {
    key: 'points',
    text: ({ exercise }) => exercise.scale && scaleText(exercise.scale),
    read: (opened, text) => asking(opened, { scale: scaleOf(text) }),
  },
  {
    key: 'vary',
    text: ({ exercise }) => exercise.vary.join(',') || null,
    read: (opened, text) => asking(opened, { vary: severalOf(variedNames, text) }),
  },
  {
    key: 'who',
    text: ({ exercise, student }) => (isEmpty(exercise) ? null : student.who || null),
    read(opened, text) {
      const who = tidyTask(text);
      if (who.length > mostOfWho) throw new Error(words.longTask(mostOfWho, who.length));
      return { ...opened, student: { ...opened.student, who } };
    },
  },
];

/** What of an exercise goes wrong or comes about only together. @param {Opened} opened @param {(key: string, why: string) => void} refuse @param {(experiment: Opened['experiment']) => Opened['experiment']} check @returns {Opened} */
export function withVariant(opened, refuse, check) {
  const { exercise, student, driver } = opened;
  if (driver.startsWith('paper-') && exercise.hidden.includes('paper')) {
    refuse('drives', words.hiddenPaper);
    return withVariant({ ...opened, driver: 'evolved' }, refuse, check);
  }
  if (opened.lesson > 0 && isHiddenWithPaper(exercise, 'lesson')) {
    refuse('lesson', words.paperInLesson);
    return withVariant({ ...opened, lesson: 0 }, refuse, check);
  }
  if (exercise.scale && !exercise.aim) {
    refuse('points', words.noAim);
    return withVariant(asking(opened, { scale: null }), refuse, check);
  }
  if (exercise.vary.length === 0 || student.who === '') return opened;
  try {
    const experiment = check(drawnFor(opened.experiment, exercise.vary, student.who));
    return { ...opened, experiment, student: { ...student, base: opened.experiment } };
  } catch (error) {
    refuse('vary', error instanceof Error ? error.message : String(error));
    return asking(opened, { vary: [] });
  }
}

/** Some of these, each once and in their order. @template {string} T @param {readonly T[]} names @param {string} text */
function severalOf(names, text) {
  const named = text.split(',').map((name) => oneOf(names, name));
  return names.filter((name) => named.includes(name));
}

/** @param {Aim} aim */
export function aimText({ wanted, drives }) {
  const budget = drives === null ? '' : `;drives<=${drives}`;
  if (wanted.kind === 'cost') return `J<${numberText(wanted.below)}${budget}`;
  if (wanted.kind === 'parks') return `parks:${wanted.least}/${wanted.of}${budget}`;
  return `unseen:${numberText(wanted.share)}${budget}`;
}

/** @param {string} text @returns {Aim} */
export function aimOf(text) {
  const [what, budget, ...rest] = text.split(';');
  const wanted = wantedOf(what.trim());
  const drives = budget === undefined ? null : Number(/^\s*drives<=(\d{1,10})\s*$/.exec(budget)?.[1]);
  const isWrong = drives !== null && !(drives >= 1 && drives <= most.drives);
  if (!wanted || isWrong || rest.length > 0) throw new Error(words.expected(words.anAim(most), text));
  return { wanted, drives };
}

/** @param {string} text @returns {Wanted | null} */
function wantedOf(text) {
  const [, below] = /^J<(\S+)$/.exec(text) ?? [];
  if (below !== undefined) {
    const value = number(below);
    return value > 0 && value <= most.cost ? { kind: 'cost', below: value } : null;
  }
  const [, least, of] = /^parks:(\d{1,4})\/(\d{1,4})$/.exec(text) ?? [];
  if (of !== undefined) {
    const [k, n] = [Number(least), Number(of)];
    return k >= 1 && k <= n && n <= most.starts ? { kind: 'parks', least: k, of: n } : null;
  }
  const [, share] = /^unseen:(\S+)$/.exec(text) ?? [];
  if (share === undefined) return null;
  const value = number(share);
  return value > 0 && value <= 1 ? { kind: 'unseen', share: value } : null;
}

/** @param {Scale} scale */
export const scaleText = ({ values, points }) =>
  values.map((value, i) => `${numberText(value)}:${numberText(points[i])}`).join(',');

/** @param {string} text @returns {Scale} */
export function scaleOf(text) {
  const pairs = text.split(',').map((pair) => pair.split(':').map(number));
  const [[a, p], [b, q]] = pairs.length === 2 ? pairs : [[], []];
  const isPoints = (/** @type {number} */ value) => value >= 0 && value <= most.points;
  if (pairs.some(({ length }) => length !== 2) || !(a !== b) || !isPoints(p) || !isPoints(q))
    throw new Error(words.expected(words.aScale(most), text));
  return { values: [a, b], points: [p, q] };
}
