// What a link carries of an exercise: its task, what it locks and hides, when it is solved, and who works on it.
/** @import { Aim, Scale, Wanted } from '../run/aim.js' */
/** @import { Experiment, Preset } from '../core/engine.js' */
/** @import { Opened } from '../run/actions/page.js' */
/** @import { Exercise } from '../run/exercise.js' */
/** @import { Prepared } from '../run/prepared.js' */
/** @import { Key, Linked } from './keys.js' */
import { seenText, tidyText } from '../kit/text.js';
import { most } from '../run/aim.js';
import { lastGeneration } from '../run/pace.js';
import { asksSomething, groupNames, isEmpty, isHiddenWithPaper, mostOfTask, wayOf } from '../run/exercise.js';
import { isAllTold, nothingPrepared, preparedIn, unreachable } from '../run/prepared.js';
import { drivers, presets, spentOf } from '../run/state.js';
import { drawnFor, mostOfWho, undrawn, variedNames } from '../run/variant.js';
import { link as words } from '../words/index.js';
import { changesOf, changesText, withChanges } from './experiment.js';
import { PartlyRead } from './together.js';
import { number, numberText, oneOf, triple, wholeNumber } from './values.js';

/** @param {Opened} opened @param {Partial<Exercise>} patch @returns {Opened} */
const asking = (opened, patch) => ({ ...opened, exercise: { ...opened.exercise, ...patch } });

/** A key of some of these names, each once and in their order. What is none of them is refused, the others are read all the same. @param {string} key @param {'locked' | 'hidden' | 'vary'} field @param {readonly string[]} names @returns {Key} */
const severalKey = (key, field, names) => ({
  key,
  text: ({ exercise }) => exercise[field].join(',') || null,
  read(opened, text) {
    const named = text.split(',');
    const known = names.filter((name) => named.includes(name));
    const read = asking(opened, /** @type {Partial<Exercise>} */ ({ [field]: known }));
    const stranger = named.find((one) => !names.includes(one));
    if (stranger === undefined) return read;
    const why = words.expected(words.oneOf(names), stranger);
    throw known.length > 0 ? new PartlyRead(why, read) : new Error(why);
  },
});

/** @type {readonly Key[]} */
export const exerciseKeys = [
  severalKey('lock', 'locked', groupNames),
  severalKey('hide', 'hidden', groupNames),
  {
    key: 'task',
    text: ({ exercise }) => tidyText(exercise.task) || null,
    read(opened, text) {
      const task = tidyText(text);
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
  severalKey('vary', 'vary', variedNames),
  {
    key: 'who',
    text: ({ exercise, student }) => (isEmpty(exercise) ? null : student.who || null),
    read(opened, text) {
      const who = seenText(text) && tidyText(text);
      if (who.length > mostOfWho) throw new Error(words.longTask(mostOfWho, who.length));
      return { ...opened, student: { ...opened.student, who } };
    },
  },
  {
    // What was driven before, where so many drives are allowed.
    key: 'spent',
    text(state) {
      const { exercise, student, work, history } = state;
      if (!exercise.aim?.drives) return null;
      const made = work && history ? spentOf({ ...state, work, history }) : student.spent;
      return made > 0 ? String(made) : null;
    },
    read: (opened, text) => ({
      ...opened,
      student: { ...opened.student, spent: wholeNumber(text, most.drives) },
    }),
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
  const { preset, experiment } = student.base ?? opened;
  const given = withoutFreeSeed(experiment, exercise, opened.experiment);
  const base = asksSomething(exercise) ? { preset, experiment: given, prepared: preparedIn(opened) } : null;
  const spent = exercise.aim?.drives ? student.spent : 0;
  const within = { ...opened, student: { ...student, base, spent } };
  if (!base || exercise.vary.length === 0 || student.who === '') return within;
  try {
    const own = check(drawnFor(base.experiment, exercise.vary, student.who));
    return { ...within, experiment: student.base ? opened.experiment : own };
  } catch (error) {
    refuse('vary', error instanceof Error ? error.message : String(error));
    return asking(within, { vary: [] });
  }
}

/** A seed that is not locked, nor drawn, is the student's to choose. @param {Exercise} exercise */
const isSeedFree = (exercise) => wayOf(exercise, 'seed') === 'free' && !exercise.vary.includes('seed');

/** @param {Experiment} experiment @param {Exercise} exercise @param {Experiment} usual @returns {Experiment} */
export const withoutFreeSeed = (experiment, exercise, usual) =>
  isSeedFree(exercise)
    ? { ...experiment, evolution: { ...experiment.evolution, seed: usual.evolution.seed } }
    : experiment;

/** What of an experiment is not as the exercise has it, by the names of links. Where settings are free, how evolution searches is the student's to choose. @param {Experiment} experiment @param {Experiment} own The exercise's, as it was drawn. @param {Exercise} exercise */
export const apartFrom = (experiment, own, exercise) =>
  changesOf(experiment, own)
    .map(([name]) => name)
    .filter((name) =>
      name === 'seed'
        ? !isSeedFree(exercise)
        : !(/^(evolution\.|population|opponents)/.test(name) && wayOf(exercise, 'settings') === 'free'),
    );

/** What a link tells of a state: the exercise as it was given, and who works on it, and so what was drawn; or, if that was left, the run as it is, and what the exercise has. @param {Linked} state @returns {Linked} */
export function asGiven(state) {
  const { exercise, experiment, preset, handGains, student } = state;
  const { base } = student;
  if (!base) return state;
  const { prepared } = base;
  const plain = undrawn(experiment, exercise.vary, student);
  const isLeft =
    !plain ||
    preset !== base.preset ||
    !isAllTold(state, exercise, prepared) ||
    unreachable(state, exercise, prepared).length > 0 ||
    (prepared.gains !== null && String(handGains) !== String(prepared.gains)) ||
    changesOf(plain, withoutFreeSeed(base.experiment, exercise, plain)).length > 0;
  return isLeft ? state : { ...state, experiment: plain, student: { ...student, base: null } };
}

/** What nobody can choose of what drives. @param {Prepared} prepared */
const preparedText = ({ driver, gains, generation }) => [
  ...(driver === null ? [] : [`drives:${driver}`]),
  ...(gains === null ? [] : [`gains:${gains.map(numberText).join(',')}`]),
  ...(generation === null ? [] : [`generation:${generation}`]),
];

/** How it is read. @type {Readonly<Record<string, (text: string) => Partial<Prepared>>>} */
const preparedReads = {
  drives: (text) => ({ driver: oneOf(drivers, text) }),
  gains: (text) => ({ gains: triple(text) }),
  generation: (text) => ({ generation: wholeNumber(text, lastGeneration) }),
};

/** What leads back to an exercise that was left: a preset, what drives in it, and what is different from the preset. @param {Pick<Linked, 'exercise' | 'student'>} state @param {(preset: Preset) => Experiment} experimentOf @returns {[string, string][]} */
export function givenPairs({ exercise, student: { base } }, experimentOf) {
  if (!base || !asksSomething(exercise)) return [];
  const changes = changesText(base.experiment, experimentOf(base.preset));
  return [['given', [base.preset, ...preparedText(base.prepared), ...changes].join('~')]];
}

/** It is written beside the others, and read as they are. @type {Key} */
export const givenKey = {
  key: 'given',
  text: () => null,
  read(opened, text, engine) {
    const [name, ...all] = text.split('~');
    const preset = oneOf(presets, name);
    let prepared = nothingPrepared;
    const changes = all.filter((change) => {
      const [, key, value] = /^(\w+):(.*)$/.exec(change) ?? [];
      if (!Object.hasOwn(preparedReads, key)) return true;
      prepared = { ...prepared, ...preparedReads[key](value) };
      return false;
    });
    const experiment = engine.experiment(withChanges(engine.experiment(preset), changes));
    // The core knows which gains cannot be driven.
    if (prepared.gains) engine.check(experiment, prepared.gains);
    return { ...opened, student: { ...opened.student, base: { preset, experiment, prepared } } };
  },
};

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
