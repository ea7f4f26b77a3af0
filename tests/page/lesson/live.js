// What a question of the lesson is answered from, under Node: the page's own answers on the core itself.
import { tryNow } from '../../../www/core/pending.js';
import { liveOf } from '../../../www/lesson/headless.js';
import { steps } from '../../../www/lesson/steps.js';
import * as en from '../../../www/lesson/words/en.js';
import * as ko from '../../../www/lesson/words/ko.js';

export { liveOf };

/** @typedef {import('../../../www/lesson/path.js').StepName} StepName */

/** @type {Map<string, ReturnType<typeof answer>>} */
const answers = new Map();

/** What comes out of a question, and what is then said of it: the same whenever it is asked. @param {StepName} step @param {string} name */
export function answered(step, name) {
  const key = `${step}.${name}`;
  const known = answers.get(key) ?? answer(step, name);
  answers.set(key, known);
  return known;
}

/** @param {StepName} step @param {string} name */
async function answer(step, name) {
  const block = steps
    .find((one) => one.name === step)
    ?.blocks.find((one) => one.kind === 'quiz' && one.name === name);
  if (block?.kind !== 'quiz') throw new Error(`no question ${step}.${name}`);
  const outcome = await block.quiz.answer(liveOf(block.quiz.shows ?? ''));
  const why = [en, ko].map(({ steps: words }) => /** @type {any} */ (words[step]).quizzes[name].why(outcome));
  return { outcome, why };
}

/** The link of a try. @param {StepName} step @param {string} name */
export function tryOf(step, name) {
  for (const block of steps.find((one) => one.name === step)?.blocks ?? [])
    if (block.kind === 'tries') {
      const found = block.tries.find(([key]) => key === name);
      if (found) return found[1];
    }
  throw new Error(`no try ${step}.${name}`);
}

/** The numbers in the texts of a step, once all of them are there. @param {import('../../../www/lesson/steps.js').Step} step @param {ReturnType<typeof liveOf>} live @returns {Promise<Record<string, string>>} */
export async function toldBy(step, live) {
  for (;;) {
    let again = () => {};
    const arrival = new Promise((resolve) => {
      again = () => resolve(null);
    });
    const known = tryNow(() => step.values?.(live) ?? {}, again);
    if (known) return known;
    await arrival;
  }
}

/** The numbers in the text of the step that is open, once all of them are there. @param {import('../harness/browsers.js').Page} page @param {string} what */
export const numbersOn = (page, what) =>
  page.until(what, () => {
    const values = [
      .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#lesson [data-value]')),
    ].map(({ dataset, textContent }) => `${dataset.value} ${textContent}`);
    return values.some((value) => value.includes('…')) ? '' : values.join();
  });
