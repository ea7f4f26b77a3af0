// Answers what was predicted, once what shows it has been seen.
import { Pending } from '../../core/pending.js';
import { isLost, messageOf } from '../../words/errors.js';
import { isAskedIn } from './asked-in.js';
import { keyOf, progressSlice } from '../state.js';
import words from '../words/index.js';

/** @import { Run } from '../../core/engine.js' */
/** @import { Live, Tools } from '../page.js' */
/** @import { Answer } from '../state.js' */
/** @import { Step } from '../steps.js' */

/** What moves less than this from here on is at rest, in metres and radians. */
const seen = 2e-3;
/** One sees for so long that it does not move. */
const pause = 0.6;

/** When nothing of a run moves any more. @param {Run} run */
export function restOf({ time, x, y, theta }) {
  const last = time.length - 1;
  const isThere = (/** @type {number} */ i) =>
    Math.abs(x[i] - x[last]) < seen &&
    Math.abs(y[i] - y[last]) < seen &&
    Math.abs(theta[i] - theta[last]) < seen;
  let at = last;
  while (at > 0 && isThere(at - 1)) at -= 1;
  return Math.min(time[last], time[at] + pause);
}

/** Whether the drive has been seen to its end. @param {Live} live */
const isSeen = ({ state: { robot }, scene: { driving } }) => !robot.playing || robot.time >= restOf(driving);

/** What goes wrong at once goes the way of what goes wrong later; what is still under way is asked for again. @param {() => unknown} answer @returns {Promise<any>} */
function begun(answer) {
  try {
    return Promise.resolve(answer());
  } catch (error) {
    if (error instanceof Pending) throw error;
    return Promise.reject(error);
  }
}

/** @type {WeakSet<Answer>} */
const pending = new WeakSet();

/** @param {Live} live @param {Step} step @param {Pick<Tools, 'store' | 'actions'>} tools @param {boolean} [isEnough] Whatever of a drive has been seen. */
export function settle(live, step, { store, actions }, isEnough = false) {
  if (live.state.evolving || live.state.computing) return;
  for (const block of step.blocks) {
    if (block.kind !== 'quiz') continue;
    const { name, quiz } = block;
    const key = keyOf(step, name);
    /** @param {Answer} answer @param {Answer} [told] Without it the question is free again. */
    const replace = (answer, told) => {
      const { [key]: now, ...others } = progressSlice.of(store.get()).answers;
      if (now === answer)
        progressSlice.update(store, { answers: told ? { ...others, [key]: told } : others });
    };
    const answer = progressSlice.of(live.state).answers[key];
    if (!answer || answer.right !== null || pending.has(answer)) continue;
    if (!isAskedIn(answer, live.state, quiz)) {
      replace(answer);
      progressSlice.update(store, { lapsed: key });
      continue;
    }
    if (quiz.ready && !quiz.ready(live)) continue;
    if (quiz.watch && !isEnough && !isSeen(live)) continue;
    const found = begun(() => quiz.answer(live));
    pending.add(answer);
    const { why } = /** @type {any} */ (words.steps[step.name]).quizzes[name];
    found
      .then((outcome) => replace(answer, { ...answer, right: outcome.right, why: why(outcome) }))
      .catch((error) => {
        replace(answer);
        if (isLost(error)) throw error;
        actions.say(messageOf(error));
      });
  }
}
