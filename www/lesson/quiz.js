// A question: predict first, then see. The right answer comes from the running program, after the press.
import { create } from '../kit/elements.js';
import { lesson as words } from '../words/index.js';
import { inline } from './prose.js';

/** @typedef {import('./page.js').Live} Live */
/** @typedef {import('./page.js').Answer} Answer */
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
  const legend = create('legend', '', ...inline(text.question, hrefOf));
  const choices = text.choices.map((choice, i) => {
    const button = create(
      'button',
      'choice',
      create('span', 'choice-mark'),
      create('span', '', ...inline(choice, hrefOf)),
    );
    button.setAttribute('type', 'button');
    button.addEventListener('click', () => onAnswer(i));
    return button;
  });
  const why = create('p', 'quiz-why');
  why.setAttribute('role', 'status');
  const again = create('button', 'link', words.askAgain);
  again.setAttribute('type', 'button');
  again.addEventListener('click', () => {
    onAgain();
    choices[0].focus();
  });
  const element = create('fieldset', 'quiz', legend, create('div', 'choices', ...choices), why, again);
  /** @type {Answer | null | undefined} */
  let drawn;
  return {
    element,
    /** @param {Answer | undefined} answer */
    draw(answer = undefined) {
      if (answer === drawn && drawn !== undefined) return;
      drawn = answer ?? null;
      const right = answer?.outcome?.right;
      for (const [i, button] of choices.entries()) {
        button.toggleAttribute('aria-disabled', answer !== undefined);
        button.classList.toggle('right', i === right);
        button.classList.toggle('wrong', right !== undefined && i === answer?.choice && i !== right);
        button.classList.toggle('chosen', i === answer?.choice);
        const mark =
          right === undefined ? '' : i === right ? words.right : i === answer?.choice ? words.wrong : '';
        /** @type {Element} */ (button.firstElementChild).textContent = mark;
      }
      again.hidden = right === undefined;
      if (!answer) why.replaceChildren();
      else if (!answer.outcome) why.textContent = words.computing;
      else
        why.replaceChildren(
          create('strong', '', answer.choice === right ? words.asPredicted : words.otherwise),
          ' ',
          ...inline(text.why(answer.outcome), hrefOf),
        );
    },
  };
}
