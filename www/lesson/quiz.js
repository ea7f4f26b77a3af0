// A question: predict first, then see. The right answer comes from the running program, after the press.
import { html, render } from 'lit-html';
import { create } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import words from './words/index.js';
import { inline } from './prose.js';

/** @import { Answer, Live } from './page.js' */

/**
 * The number of the right choice, and what the words tell of it.
 * @typedef {{ right: number } & Record<string, any>} Outcome
 */
/**
 * @typedef {object} Quiz
 * @property {string} [shows] The link of a run that shows it; opened when the prediction is made.
 * @property {(live: Live) => boolean} [ready] Whether what it is answered from is there; without it, at once.
 * @property {(live: Live) => Outcome | Promise<Outcome>} answer From what runs then.
 */
/** @typedef {{ question: string, choices: readonly string[], why: (outcome: any) => string }} QuizWords */

/**
 * @param {QuizWords} text @param {(link: string) => string} hrefOf
 * @param {{ onAnswer: (choice: number) => void, onAgain: () => void }} events
 */
export function createQuiz(text, hrefOf, { onAnswer, onAgain }) {
  const question = inline(text.question, hrefOf);
  const choices = text.choices.map((choice) => inline(choice, hrefOf));
  const element = create('fieldset', 'quiz');
  const again = () => {
    onAgain();
    element.querySelector('button')?.focus();
  };
  const changed = watch();
  return {
    element,
    /** @param {Answer | undefined} answer */
    draw(answer) {
      if (!changed(answer)) return;
      const right = answer?.outcome?.right;
      const button = (/** @type {(Node | string)[]} */ choice, /** @type {number} */ i) => {
        const chosen = i === answer?.choice;
        const wrong = chosen && right !== undefined && i !== right;
        const mark = wrong ? words.wrong : i === right ? words.right : '';
        const look = `choice${i === right ? ' right' : ''}${wrong ? ' wrong' : ''}${chosen ? ' chosen' : ''}`;
        return html`<button type="button" class=${look} ?aria-disabled=${answer !== undefined}
          @click=${() => onAnswer(i)}><span class="choice-mark">${mark}</span><span>${choice}</span></button>`;
      };
      const why = answer?.outcome
        ? html`<strong>${answer.choice === right ? words.asPredicted : words.otherwise}</strong> ${inline(text.why(answer.outcome), hrefOf)}`
        : answer && words.computing;
      render(
        html`<legend>${question}</legend>
          <div class="choices">${choices.map(button)}</div>
          <p class="quiz-why" role="status">${why}</p>
          <button type="button" class="link" ?hidden=${right === undefined} @click=${again}>${words.askAgain}</button>`,
        element,
      );
    },
  };
}
