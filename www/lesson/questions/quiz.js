// A question: predict first, then see. The right answer comes from the running program, after the press.
import { html, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { isStill } from '../../kit/host.js';
import { watch } from '../../kit/memo.js';
import words from '../words/index.js';
import { inline } from '../prose.js';

/** @import { Store } from '../../run/store.js' */
/** @import { Live } from '../page.js' */
/** @import { Sight } from '../sights.js' */
/** @import { Answer } from '../state.js' */

/**
 * The number of the right choice, and what the words tell of it.
 * @typedef {{ right: number } & Record<string, any>} Outcome
 */
/**
 * @typedef {object} Quiz
 * @property {string} [shows] The link of a run that shows it; opened when the prediction is made.
 * @property {Sight} [sight] Which sight of it, where only one has room.
 * @property {number} [time] Where the robots' clock then stands, in seconds; without it they drive.
 * @property {(store: Store) => void} [begins] What the prediction sets going there.
 * @property {true} [watch] The answer waits until the drive has been seen to its end.
 * @property {readonly number[]} [order] In which the choices stand; else in that of the words.
 * @property {(live: Live) => boolean} [opens] Whether it can be predicted yet; before that the words say what comes first.
 * @property {(live: Live) => boolean} [ready] Whether what it is answered from is there; without it, at once.
 * @property {(state: Live['state']) => readonly unknown[]} [of] What beside the run it is answered from: once that is another, it is to be asked again.
 * @property {(live: Live) => Outcome | Promise<Outcome>} answer From what runs then.
 */
/** @typedef {{ question: string, choices: readonly string[], first?: string, why: (outcome: any) => string }} QuizWords */

/** What came below the edge comes into sight, as far as the choices that count stay there; a page around this frame stays where it is. @param {HTMLElement} element */
function bringIntoSight(element) {
  const choice = element.querySelector('.chosen, .right');
  const article = element.closest('.lesson');
  if (!choice || !article) return;
  const { overflowY } = getComputedStyle(article);
  const scroller = overflowY === 'visible' ? document.documentElement : article;
  const edge = Math.min(innerHeight, article.getBoundingClientRect().bottom);
  const room =
    choice.getBoundingClientRect().top - Number.parseFloat(getComputedStyle(choice).scrollMarginTop);
  const below = element.getBoundingClientRect().bottom + 8 - edge;
  const isThere = room >= 0 && choice.getBoundingClientRect().bottom <= edge;
  if (isThere && below > 0)
    scroller.scrollBy({ top: Math.min(room, below), behavior: isStill() ? 'instant' : 'smooth' });
}

/**
 * @param {QuizWords} text @param {Quiz} quiz @param {(link: string) => string} hrefOf
 * @param {{ onAnswer: (choice: number) => void, onAgain: () => void }} events
 */
export function createQuiz(text, { order = text.choices.map((_, i) => i), watch: waits }, hrefOf, events) {
  const question = inline(text.question, hrefOf);
  const choices = text.choices.map((choice) => inline(choice, hrefOf));
  const element = create('fieldset', 'quiz');
  const again = () => {
    events.onAgain();
    element.querySelector('button')?.focus();
  };
  const changed = watch();
  let isAsked = false;
  const press = (/** @type {number} */ choice) => {
    isAsked = true;
    events.onAnswer(choice);
  };
  return {
    element,
    /** @param {Answer | undefined} answer @param {boolean} isLapsed @param {boolean} isClosed */
    draw(answer, isLapsed, isClosed) {
      if (!changed(answer, isLapsed, isClosed)) return;
      const right = answer?.right ?? null;
      const button = (/** @type {number} */ i) => {
        const chosen = i === answer?.choice;
        const wrong = chosen && right !== null && i !== right;
        const mark = i === right ? words.right : chosen ? words.yours : '';
        const look = `choice${i === right ? ' right' : ''}${wrong ? ' wrong' : ''}${chosen ? ' chosen' : ''}${isClosed ? ' closed' : ''}`;
        return html`<button type="button" class=${look} aria-pressed=${String(chosen)} aria-disabled=${String(answer !== undefined || isClosed)}
          @click=${() => isClosed || press(i)}><span class="choice-mark muted">${mark}</span><span>${choices[i]}</span></button>`;
      };
      const why =
        answer && right !== null
          ? html`<strong>${answer.choice === right ? words.asPredicted : words.otherwise}</strong> ${answer.said ? words.saidElsewhere : inline(answer.why, hrefOf)}`
          : answer
            ? waits
              ? words.watching
              : words.computing
            : isClosed
              ? text.first
              : isLapsed
                ? words.lapsed
                : '';
      render(
        html`<legend>${question}</legend>
          <div class="choices">${order.map(button)}</div>
          <p class="quiz-why" role="status">${why}</p>
          <button type="button" class="link" ?hidden=${right === null} @click=${again}>${words.askAgain}</button>`,
        element,
      );
      if (isAsked && right !== null) bringIntoSight(element);
      isAsked &&= right === null;
    },
  };
}
