// A receipt: what is handed in. It names the exercise and the answer, and says what the answer came to; whoever opens it lets the
// core come to it again. So it needs no secret, and proves the result, never whose it is.
//
// Its link is the run, with one key more: handin=version~J~parked/starts~drives~minutes~program~exercise~answers~digits.
/** @import { Engine, PaperResult, Triple } from '../../core/engine.js' */
/** @import { Links } from '../../link/link.js' */
/** @import { Judged, Wanted } from '../../run/aim.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Measured } from './measure.js' */
import { digitsOf } from '../../kit/hash.js';
import { amongWords } from '../../kit/host.js';
import { withoutFreeSeed } from '../../link/exercise.js';
import { isSealed, sealOf } from '../../link/seal.js';
import { encoded, numberText } from '../../link/values.js';
import { judged } from '../../run/aim.js';
import { gainsOf } from '../../run/drivers.js';
import { noPins } from '../../run/pins.js';
import { drivesOf, nothingDone, noTrial } from '../../run/state.js';
import { nobody } from '../../run/variant.js';
import { measure } from './measure.js';
import { ownOf } from './own.js';

/** Answers to the lesson's questions: the number of the choice, and whether the page found it right. @typedef {Readonly<Record<string, { choice: number, right: number | null }>>} Answers */
/** @typedef {{ cost: number, parked: number, starts: number, drives: number, minutes: number, program: string, exercise: string, answers: string }} Told What a receipt says; the result of it is what whoever opens it computes again. */
/** @typedef {Told & { who: string, link: string, gains: Triple, how: { driver: State['driver'], method: string, seed: number, generation: number }, apart: readonly import('./own.js').Thing[], there: Measured, wanted: Wanted | null, judged: Judged | null }} Receipt `there`: in the exercise as it was given, where it is judged; `apart`: what of the run is not as it has it. */
/** What of a state says what is done. @typedef {import('../../link/keys.js').Linked & Pick<State, 'population' | 'history' | 'work'>} Done */

const version = '1';

/** The exercise alone, as a link: its task and all that it gives, without who works on it and what they did. What they may choose, a seed that is not locked, is no part of it. @param {import('../../link/keys.js').Linked} state @param {Engine} engine @param {Links} links */
export function exerciseLink(state, engine, links) {
  const { exercise, student } = state;
  const { preset, experiment } = student.base ?? state;
  return links.linkOf(
    {
      ...state,
      ...nothingDone,
      page: 'lab',
      preset,
      experiment: withoutFreeSeed(experiment, exercise, engine.experiment(preset)),
      pins: noPins,
      slices: {},
      student: nobody,
      work: null,
    },
    engine.experiment,
    'en',
  );
}

/** @param {string} link Of the exercise alone. */
export const exerciseId = (link) => digitsOf(link);

/** The run that was handed in, as short as it can be said. @param {Done} state @param {Engine} engine @param {Links} links */
function answerLink(state, engine, links) {
  const evolves = state.driver === 'evolved';
  return links.linkOf(
    {
      ...state,
      generation: evolves ? state.generation : 0,
      handGains: state.driver === 'hand' ? state.handGains : null,
      found: state.driver === 'hand' ? state.found : 'hand',
      trial: noTrial,
      pins: noPins,
      student: { ...state.student, handin: '' },
    },
    engine.experiment,
  );
}

/** @param {Answers} answers */
const answersText = (answers) =>
  Object.entries(answers)
    .map(
      ([name, { choice, right }]) => `${name}:${choice}${right === null ? '' : right === choice ? '+' : '-'}`,
    )
    .join(',');

/**
 * The receipt for what a state holds.
 * @param {{ engine: Engine, links: Links, paper: PaperResult[] }} tools @param {Done} state @param {Answers} [answers]
 * @returns {Promise<Receipt>}
 */
export async function receiptOf({ engine, links, paper }, state, answers = {}) {
  const { exercise, experiment, student, work, driver, generation } = state;
  const gains = gainsOf(state, driver, paper);
  const { own, apart } = ownOf(engine, exercise, student, experiment, state);
  const measured = await measure(engine, apart.length > 0 ? null : exercise.aim, experiment, gains);
  const there = apart.length > 0 ? await measure(engine, exercise.aim, own, gains) : measured;
  const { cost, parked, starts } = measured;
  const told = {
    cost,
    parked,
    starts,
    drives: drivesOf(state),
    minutes: Math.round((performance.now() - work.begun) / 60_000),
    program: engine.version(),
    exercise: exerciseId(exerciseLink(state, engine, links)),
    answers: answersText(answers),
  };
  const link = answerLink(state, engine, links);
  const body = bodyOf(told);
  const { method, seed } = experiment.evolution;
  return {
    ...told,
    who: student.who,
    link: amongWords(`${link}&handin=${encoded(`${body}~${sealOf(link, body)}`)}`),
    gains,
    how: { driver, method, seed, generation },
    apart,
    there,
    wanted: exercise.aim?.wanted ?? null,
    judged: exercise.aim && judged(exercise.aim, exercise.scale, { value: there.value, drives: told.drives }),
  };
}

/** @param {Told} told */
const bodyOf = ({ cost, parked, starts, drives, minutes, program, exercise, answers }) =>
  [version, numberText(cost), `${parked}/${starts}`, drives, minutes, program, exercise, answers].join('~');

/** What the key of a receipt says; null if it says nothing that can be read. @param {string} text @returns {Told | null} */
export function toldIn(text) {
  const [of, cost, park, drives, minutes, program, exercise, answers, ...rest] = text.split('~');
  const [, parked, starts] = /^(\d+)\/(\d+)$/.exec(park ?? '') ?? [];
  const numbers = [parked, starts, drives, minutes].map((one) =>
    /^\d{1,12}$/.test(one ?? '') ? Number(one) : Number.NaN,
  );
  const J = cost === '' ? Number.NaN : Number(cost);
  const isUnreadable = [J, ...numbers].some(Number.isNaN);
  if (of !== version || isUnreadable || answers === undefined || rest.length > 1) return null;
  return {
    cost: J,
    parked: numbers[0],
    starts: numbers[1],
    drives: numbers[2],
    minutes: numbers[3],
    program: program.slice(0, 20),
    exercise: exercise.slice(0, 8),
    answers: answers.slice(0, 2000),
  };
}

/** Whether a receipt came whole: with what it was written for. @param {import('../../link/keys.js').Linked} opened @param {Engine} engine @param {Links} links */
export const isWhole = (opened, engine, links) =>
  isSealed(
    links.linkOf({ ...opened, student: { ...opened.student, handin: '' } }, engine.experiment),
    opened.student.handin,
  );

/** Whether what it says is what the core comes to. @param {Told} told @param {Measured} measured */
export const holds = (told, measured) =>
  Object.is(told.cost, measured.cost) && told.parked === measured.parked && told.starts === measured.starts;
