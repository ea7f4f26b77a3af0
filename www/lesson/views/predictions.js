// What became of the predictions, told where the path ends.
import { html, nothing, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { nameOf } from '../blocks.js';
import { linkOfStep, pathLength, stepNames } from '../path.js';
import { inline } from '../prose.js';
import { keyOf, progressSlice } from '../state.js';
import words from '../words/index.js';

/** @import { Block, Tools } from '../page.js' */
/** @import { Answer } from '../state.js' */
/** @typedef {{ predictions: { title: string, counts: (counts: { all: number, answered: number, right: number }) => string, otherwise: string } }} PredictionWords */

/** Every question of the path, and how it was answered. @param {Readonly<Record<string, Answer>>} answers */
export const questionsOf = (answers) =>
  stepNames.slice(0, pathLength).flatMap((name, i) => {
    /** @type {{ texts: object, quizzes?: Record<string, { question: string }> }} */
    const { quizzes = {} } = words.steps[name];
    return Object.entries(quizzes).map(([quiz, { question }]) => ({
      number: i + 1,
      question,
      answer: answers[keyOf({ name }, quiz)],
    }));
  });

/** @typedef {ReturnType<typeof questionsOf>[number]} Question */

/** @param {Question} question */
const isAnswered = ({ answer }) => (answer?.right ?? null) !== null;

/** A question with numbers of its own step is called by that alone. @param {Question} question @param {(link: string) => string} href */
const lineOf = ({ number, question }, href) =>
  html`<li><a href=${`#${linkOfStep(number)}`}>${nameOf(number)}</a>${question.includes('{=') ? nothing : html`<p class="muted">${inline(question, href)}</p>`}</li>`;

/** @param {Tools} _ @param {PredictionWords} words @param {(link: string) => string} href @returns {Block} */
export function createPredictions(_, { predictions: text }, href) {
  const element = create('section', 'predictions');
  const changed = watch();
  return {
    element,
    draw({ state }) {
      const { answers } = progressSlice.of(state);
      if (!changed(answers)) return;
      const all = questionsOf(answers);
      const answered = all.filter(isAnswered);
      const missed = answered.filter(({ answer }) => answer?.choice !== answer?.right);
      const counts = { all: all.length, answered: answered.length, right: answered.length - missed.length };
      element.hidden = answered.length === 0;
      render(
        html`<h3>${text.title}</h3>
          <p>${text.counts(counts)} ${missed.length > 0 ? text.otherwise : ''}</p>
          <ul class="prose-list" .hidden=${missed.length === 0}>${missed.map((one) => lineOf(one, href))}</ul>`,
        element,
      );
    },
  };
}
