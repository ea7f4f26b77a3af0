// What a step holds, made of its words: texts, formulas, things to try, questions, views.
import { html, nothing, render } from 'lit-html';
import { keyed } from 'lit-html/directives/keyed.js';
import { tryNow } from '../core/pending.js';
import { create, write } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { disturbanceSlice } from '../parts/disturbance/state.js';
import { generationSlice } from '../parts/generation/state.js';
import { landscapeSlice } from '../parts/landscape/state.js';
import { robustnessSlice } from '../parts/robustness/state.js';
import { lesson as first } from '../words/index.js';
import { isAskedIn } from './questions/asked-in.js';
import { createFormula } from './formulas/formula.js';
import { hrefOf, linkOfStep, pathLength, stepNames } from './path.js';
import { inline, list, paragraphs } from './prose.js';
import { createQuiz } from './questions/quiz.js';
import { settle } from './questions/settle.js';
import { keyOf, progressSlice } from './state.js';
import words from './words/index.js';

/** @import { TemplateResult } from 'lit-html' */
/** @import { Answer } from './state.js' */
/** @import { Block, Live, Part, Tools } from './page.js' */
/** @import { Content, Step } from './steps.js' */

/** Whether a question of the step has been answered. @param {Live['state']} state @param {Step} step @param {string} name */
const isAnswered = (state, step, name) =>
  (progressSlice.of(state).answers[keyOf(step, name)]?.right ?? null) !== null;

/** Whether somebody has said what they expect. @param {Live['state']} state @param {Step} step @param {string} name */
export const isPredicted = (state, step, name) =>
  progressSlice.of(state).answers[keyOf(step, name)] !== undefined;

/** @param {HTMLElement} article @param {Step} step @param {number} number @param {Tools} tools @returns {Part[]} */
export function createStep(article, step, number, tools) {
  const text = words.steps[step.name];
  const href = (/** @type {string} */ link) => hrefOf(link, number);
  const blocks = step.blocks.map((block) => masked(createBlock(block, step, text, href, tools), block, step));
  render(
    keyed(
      number,
      html`${head(number, tools.go)}
        <h2 id="lesson-title" tabindex="-1">${titleOf(number)}</h2>
        ${blocks.map(({ element }) => element)} ${foot(number)}`,
    ),
    article,
  );
  return [...blocks, createValues(article, step, tools)];
}

/** What would give an answer away is not there before it. @param {Part} part @param {Content} block @param {Step} step @returns {Part} */
function masked(part, { after }, step) {
  if (!after) return part;
  const element = create('div', { class: 'after', hidden: '' });
  render(html`${part.element}`, element);
  return {
    element,
    draw(live) {
      element.hidden = !isAnswered(live.state, step, after);
      part.draw(live);
    },
  };
}

/** The numbers in the texts. @param {HTMLElement} article @param {Step} step @param {Pick<Tools, 'store'>} tools @returns {Block} */
function createValues(article, step, { store }) {
  const changed = watch();
  let isDue = false;
  return {
    element: article,
    draw(live) {
      const { state, scene, sample } = live;
      const parts = [
        generationSlice.of(state),
        landscapeSlice.of(state).result,
        disturbanceSlice.of(state).measured,
        robustnessSlice.of(state).half,
      ];
      const now = [scene.driving, sample, state.history, state.generation, progressSlice.of(state), ...parts];
      if (!changed(...now) && !isDue) return;
      const known = tryNow(() => step.values?.(live) ?? {}, store.redraw);
      isDue = !known;
      for (const element of /** @type {NodeListOf<HTMLElement>} */ (article.querySelectorAll('[data-value]')))
        write(element, known ? (known[element.dataset.value ?? ''] ?? '–') : '…');
    },
  };
}

/** @param {Content} block @param {Step} step @param {any} text @param {(link: string) => string} href @param {Tools} tools @returns {Part} */
function createBlock(block, step, text, href, tools) {
  const still = (/** @type {TemplateResult} */ element) => ({ element, draw() {} });
  switch (block.kind) {
    case 'text':
      return still(html`<div class="prose">${paragraphs(text.texts[block.name], href)}</div>`);
    case 'formula':
      return createFormula(block.formula);
    case 'notice':
      return still(
        html`<section class="notice"><h3>${words.notice}</h3>${list(text.notice, href)}</section>`,
      );
    case 'tries':
      return still(triesOf(block, text, href));
    case 'quiz':
      return createQuestion(block, step, text, href, tools);
    case 'view':
      return block.create(tools, text, href);
  }
}

/** @param {Extract<Content, { kind: 'tries' }>} block @param {any} text @param {(link: string) => string} href */
function triesOf({ tries }, text, href) {
  const one = (/** @type {string} */ name, /** @type {string} */ link) =>
    html`<li><a class="try" href=${link} data-try=${name}><span>${inline(text.tries[name], href)}</span></a></li>`;
  return html`<section class="tries"><h3>${words.tries}</h3><ul>${tries.map(([name, link]) => one(name, href(link)))}</ul></section>`;
}

/** @param {Extract<Content, { kind: 'quiz' }>} block @param {Step} step @param {any} text @param {(link: string) => string} href @param {Tools} tools */
function createQuestion({ name, quiz }, step, text, href, { store, actions, go, look }) {
  const key = keyOf(step, name);
  const keep = (/** @type {Answer | undefined} */ answer) => {
    const { [key]: _, ...others } = progressSlice.of(store.get()).answers;
    progressSlice.update(store, { answers: answer ? { ...others, [key]: answer } : others, lapsed: null });
  };
  /** As it was drawn last. @type {Live | null} */
  let drawn = null;
  const view = createQuiz(text.quizzes[name], quiz, href, {
    onAnswer(choice) {
      if (progressSlice.of(store.get()).answers[key]) return;
      // Whoever goes on to another question has seen enough of the drive that answers the one before.
      const last = drawn;
      if (last) tryNow(() => settle(last, step, { store, actions }, true), store.redraw);
      if (quiz.shows) go(href(quiz.shows).slice(1));
      look(quiz.sight);
      quiz.begins?.(store);
      if (quiz.time !== undefined) actions.standAt(quiz.time);
      const answer = { choice, right: null, why: '' };
      keep(answer);
      if (!store.get().computing) isAskedIn(answer, store.get(), quiz);
    },
    onAgain: () => keep(undefined),
  });
  view.element.id = `quiz-${name}`;
  return {
    element: view.element,
    draw(/** @type {Live} */ live) {
      drawn = live;
      const { answers, lapsed } = progressSlice.of(live.state);
      view.draw(answers[key], lapsed === key, quiz.opens?.(live) === false);
    },
  };
}

/** @param {number} number */
const titleOf = (number) => first.titles[stepNames[number - 1]];

/** @param {number} number */
const isOnPath = (number) => number >= 1 && number <= pathLength;

/** @param {number} number */
export const nameOf = (number) => (number > pathLength ? titleOf(number) : `${number}  ${titleOf(number)}`);

/** Where one is, and a way to every step, to those beside it by one press. @param {number} number @param {Tools['go']} go */
function head(number, go) {
  const way = (
    /** @type {number} */ other,
    /** @type {string} */ sign,
    /** @type {(title: string) => string} */ text,
  ) =>
    html`<a class="lesson-way" href=${isOnPath(other) ? `#${linkOfStep(other)}` : nothing}
      aria-label=${isOnPath(other) ? text(titleOf(other)) : nothing} aria-hidden=${isOnPath(other) ? nothing : 'true'}>${sign}</a>`;
  const options = (/** @type {number} */ from, /** @type {number} */ to) =>
    stepNames.slice(from, to).map((_, i) => {
      const one = from + i + 1;
      return html`<option value=${one} ?selected=${one === number}>${nameOf(one)}</option>`;
    });
  return html`<div class="lesson-head">
    <p class="muted">${number > pathLength ? words.besidePath : words.stepOf(number, pathLength)}</p>
    <select id="lesson-step" aria-label=${words.stepLabel}
      @change=${(/** @type {{ target: HTMLSelectElement }} */ { target }) => go(linkOfStep(Number(target.value)))}>
      ${options(0, pathLength)}<optgroup label=${words.besidePath}>${options(pathLength, stepNames.length)}</optgroup>
    </select>
    ${number > pathLength ? nothing : html`${way(number - 1, '‹', words.previousStep)}${way(number + 1, '›', words.nextStep)}`}
  </div>`;
}

/** @param {number} number */
function foot(number) {
  const to = (
    /** @type {number} */ other,
    /** @type {string} */ look,
    /** @type {(title: string) => string} */ text,
  ) =>
    !isOnPath(other)
      ? nothing
      : html`<a class=${look} href=${`#${linkOfStep(other)}`}>${text(titleOf(other))}</a>`;
  if (number > pathLength)
    return html`<nav class="lesson-foot row">${to(1, 'step-back', words.toPath)}</nav>`;
  const end =
    number === pathLength
      ? html`<p class="lesson-end">${inline(words.pathEnds, (link) => hrefOf(link, 0))}</p>`
      : nothing;
  return html`${end}<nav class="lesson-foot row">${to(number - 1, 'step-back', words.previousStep)}${to(number + 1, 'step-on primary', words.nextStep)}</nav>`;
}
