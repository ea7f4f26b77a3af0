// The run that a question was asked about: an answer from another run would be about something else.
/** @import { State } from '../../run/state.js' */
/** @import { Quiz } from './quiz.js' */
/** @import { Answer } from '../state.js' */

/** @type {WeakMap<Answer, string>} */
const runs = new WeakMap();

/** Where a prediction sets something going, that is what answers, whoever drives then. @param {State} state @param {Quiz} quiz */
const runOf = (state, { begins, of }) =>
  JSON.stringify([
    ...[state.experiment, state.work.opened],
    ...(begins ? [] : [state.driver, state.handGains, state.trial]),
    ...(of?.(state) ?? []),
  ]);

/** Whether what is on screen is what it was asked about; what was computed when it was asked says so only now. @param {Answer} answer @param {State} state @param {Quiz} quiz */
export function isAskedIn(answer, state, quiz) {
  const run = runOf(state, quiz);
  const asked = runs.get(answer) ?? run;
  runs.set(answer, asked);
  return asked === run;
}
