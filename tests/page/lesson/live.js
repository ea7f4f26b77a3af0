// What a question of the lesson is answered from, under Node: the page's own answers on the core itself.
import { liveOf } from '../../../www/lesson/headless.js';
import { steps } from '../../../www/lesson/steps.js';
import * as en from '../../../www/lesson/words/en.js';
import * as ko from '../../../www/lesson/words/ko.js';

export { liveOf };

/** What comes out of a question, and what is then said of it. @param {import('../../../www/lesson/path.js').StepName} step @param {string} name */
export async function answered(step, name) {
  const block = steps
    .find((one) => one.name === step)
    ?.blocks.find((one) => one.kind === 'quiz' && one.name === name);
  if (block?.kind !== 'quiz') throw new Error(`no question ${step}.${name}`);
  const outcome = await block.quiz.answer(liveOf(block.quiz.shows ?? ''));
  const why = [en, ko].map(({ steps: words }) => /** @type {any} */ (words[step]).quizzes[name].why(outcome));
  return { outcome, why };
}

/** The link of a try. @param {import('../../../www/lesson/path.js').StepName} step @param {string} name */
export function tryOf(step, name) {
  for (const block of steps.find((one) => one.name === step)?.blocks ?? [])
    if (block.kind === 'tries') {
      const found = block.tries.find(([key]) => key === name);
      if (found) return found[1];
    }
  throw new Error(`no try ${step}.${name}`);
}
