// The lesson: the words of one step beside the lab's own views.
import { html, nothing, render } from 'lit-html';
import { keyed } from 'lit-html/directives/keyed.js';
import { byId, write } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { disturbanceSlice } from '../parts/disturbance/state.js';
import { generationSlice } from '../parts/generation/state.js';
import { landscapeSlice } from '../parts/landscape/state.js';
import { gainsOf } from '../run/drivers.js';
import { lesson as first } from '../words/index.js';
import words from './words/index.js';
import { createErrorPosture } from './error-posture.js';
import { createFormula } from './formula.js';
import { createLit } from './lit.js';
import { inline, list, paragraphs } from './prose.js';
import { createQuiz } from './quiz.js';
import { createSights } from './sights.js';
import { hrefOf, linkOfStep } from './path.js';
import { steps } from './steps.js';
import { progressSlice } from './state.js';
import { createTally } from './tally.js';
import './style.css';

/** @import { TemplateResult } from 'lit-html' */
/** @import { Engine, PaperResult, Sample, Samples, Triple } from '../core/engine.js' */
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Store } from '../run/store.js' */
/** @import { Outcome } from './quiz.js' */
/** @import { Content, Step } from './steps.js' */

/** What runs now: all that a step's values, answers and views are made of. @typedef {{ engine: Engine, state: State, scene: Scene, paper: PaperResult[], gains: Triple, sample: Sample, decided: Sample }} Live At the robots’ clock: what is, and what the law decided last, which at the end of a drive is one sample old. */
/** What a step holds, drawn at every change. @typedef {{ element: HTMLElement, draw: (live: Live) => void }} Block */
/** The same, or what never changes. @typedef {{ element: HTMLElement | TemplateResult, draw: (live: Live) => void }} Part */
/** A prediction, and what came out once it is known. @typedef {{ choice: number, outcome: Outcome | null }} Answer */
/** @typedef {{ go: (link: string) => void, store: Store, actions: Actions, engine: Engine }} Tools */

/** @param {Tools & { paper: PaperResult[] }} parts */
export function createLessonPage({ engine, store, actions, paper, go }) {
  const article = byId('lesson');
  const tools = { engine, store, actions, go };
  const tally = createTally(store);
  const errorPosture = createErrorPosture(byId('error-posture'));
  const samples = createSamples(engine);
  const stepChanged = watch();
  const headChanged = watch();
  const sights = createSights(byId('sights'));
  createLit();
  /** @type {Part[]} */
  let blocks = [];
  new ResizeObserver(([{ target }]) =>
    document.body.style.setProperty('--head', `${target.clientHeight}px`),
  ).observe(/** @type {Element} */ (document.querySelector('.masthead')));

  article.addEventListener('click', (event) => {
    const link = event.target instanceof Element ? event.target.closest('a') : null;
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const href = link.getAttribute('href') ?? '';
    if (!href.startsWith('#')) return;
    event.preventDefault();
    go(href.slice(1));
  });

  return {
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const { lesson } = state;
      const step = steps[lesson - 1];
      if (headChanged(lesson, state.page)) {
        document.body.toggleAttribute('data-lesson', lesson > 0);
        document.body.dataset.figure = !step ? '' : state.page === 'lab' ? step.figure : 'part';
        article.hidden = !step;
        sights.open(step, state.page);
      }
      errorPosture.hide(!step?.overlay);
      if (!step) return;
      if (stepChanged(lesson)) {
        blocks = createStep(article, step, lesson, tools);
        if (!state.dragging) for (const one of [window, article]) one.scrollTo({ top: 0 });
        if (step.time !== undefined) actions.standAt(step.time);
      }
      tally.count(state, scene);
      const live = {
        engine,
        state,
        scene,
        paper,
        gains: gainsOf(state, state.driver, paper),
        ...samples(state, scene),
      };
      settle(live, step, store);
      if (step.overlay) errorPosture.draw(live);
      for (const block of blocks) block.draw(live);
    },
  };
}

/** What the law sees and commands at the robots' clock, from the core. @param {Engine} engine */
function createSamples(engine) {
  /** @type {{ run: Scene['driving'], samples: Samples } | null} */
  let known = null;
  return (/** @type {State} */ state, /** @type {Scene} */ { driving, experiment, chosen }) => {
    if (known?.run !== driving) {
      const gains = chosen?.population[0].gains ?? gainsOf(state, state.driver, engine.paper());
      known = { run: driving, samples: engine.samples(experiment, gains) };
    }
    const { samples } = known;
    const { time } = driving;
    const at = Math.round(Math.min(state.robot.time, driving.finalTime) / (time[1] - time[0] || 1));
    const last = samples.length - 1;
    return {
      sample: samples.at(Math.min(at, last)),
      decided: samples.at(Math.min(at, Math.max(last - 1, 0))),
    };
  };
}

/** Answers what was predicted, once what shows it runs. @param {Live} live @param {Step} step @param {Store} store */
function settle(live, step, store) {
  if (live.state.evolving) return;
  for (const block of step.blocks) {
    if (block.kind !== 'quiz') continue;
    const key = `${step.name}.${block.name}`;
    const answer = progressSlice.of(live.state).answers[key];
    if (!answer || answer.outcome || pending.has(answer)) continue;
    if (block.quiz.ready && !block.quiz.ready(live)) continue;
    // What it needs may still be under way: then it is asked again.
    const found = block.quiz.answer(live);
    pending.add(answer);
    Promise.resolve(found).then((outcome) => {
      const { answers } = progressSlice.of(store.get());
      if (answers[key] === answer)
        progressSlice.update(store, { answers: { ...answers, [key]: { ...answer, outcome } } });
    });
  }
}
/** @type {WeakSet<Answer>} */
const pending = new WeakSet();

/** @param {HTMLElement} article @param {Step} step @param {number} number @param {Tools} tools @returns {Part[]} */
function createStep(article, step, number, tools) {
  const text = words.steps[step.name];
  const href = (/** @type {string} */ link) => hrefOf(link, number);
  const blocks = step.blocks.map((block) => createBlock(block, step, text, href, tools));
  render(
    keyed(
      number,
      html`${head(number, tools.go)}
        <h2 id="lesson-title">${titleOf(number)}</h2>
        ${blocks.map(({ element }) => element)} ${foot(number)}`,
    ),
    article,
  );
  return [...blocks, createValues(article, step)];
}

/** The numbers in the texts. @param {HTMLElement} article @param {Step} step @returns {Block} */
function createValues(article, step) {
  const changed = watch();
  return {
    element: article,
    draw(live) {
      const { state, scene, sample } = live;
      const parts = [
        generationSlice.of(state),
        landscapeSlice.of(state).result,
        disturbanceSlice.of(state).measured,
      ];
      if (!changed(scene.driving, sample, state.history, state.generation, progressSlice.of(state), ...parts))
        return;
      const known = step.values?.(live) ?? {};
      for (const element of /** @type {NodeListOf<HTMLElement>} */ (article.querySelectorAll('[data-value]')))
        write(element, known[element.dataset.value ?? ''] ?? '–');
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
    case 'tries': {
      const tries = block.tries.map(
        ([name, link]) =>
          html`<li><a class="try" href=${href(link)} data-try=${name}><span>${inline(text.tries[name], href)}</span></a></li>`,
      );
      return still(html`<section class="tries"><h3>${words.tries}</h3><ul>${tries}</ul></section>`);
    }
    case 'quiz':
      return createQuestion(block, step, text, href, tools);
    case 'view':
      return block.create(tools, text, href);
  }
}

/** @param {Extract<Content, { kind: 'quiz' }>} block @param {Step} step @param {any} text @param {(link: string) => string} href @param {Tools} tools */
function createQuestion({ name, quiz }, step, text, href, { store, go }) {
  const key = `${step.name}.${name}`;
  const keep = (/** @type {Answer | undefined} */ answer) => {
    const { [key]: _, ...others } = progressSlice.of(store.get()).answers;
    progressSlice.update(store, { answers: answer ? { ...others, [key]: answer } : others });
  };
  const view = createQuiz(text.quizzes[name], href, {
    onAnswer(choice) {
      if (progressSlice.of(store.get()).answers[key]) return;
      if (quiz.shows) go(href(quiz.shows).slice(1));
      keep({ choice, outcome: null });
    },
    onAgain: () => keep(undefined),
  });
  view.element.id = `quiz-${name}`;
  return {
    element: view.element,
    draw: (/** @type {Live} */ { state }) => view.draw(progressSlice.of(state).answers[key]),
  };
}

/** @param {number} number */
const titleOf = (number) => first.titles[steps[number - 1].name];

/** Where one is, and a way to every step. @param {number} number @param {Tools['go']} go */
const head = (number, go) => html`<div class="lesson-head">
  <p class="muted">${words.stepOf(number, steps.length)}</p>
  <select id="lesson-step" aria-label=${words.stepLabel}
    @change=${(/** @type {{ target: HTMLSelectElement }} */ { target }) => go(linkOfStep(Number(target.value)))}>${steps.map(
      (_, i) =>
        html`<option value=${i + 1} ?selected=${i + 1 === number}>${i + 1}  ${titleOf(i + 1)}</option>`,
    )}</select>
</div>`;

/** @param {number} number */
function foot(number) {
  const to = (
    /** @type {number} */ other,
    /** @type {string} */ look,
    /** @type {(title: string) => string} */ text,
  ) =>
    other < 1 || other > steps.length
      ? nothing
      : html`<a class=${look} href=${`#${linkOfStep(other)}`}>${text(titleOf(other))}</a>`;
  return html`<nav class="lesson-foot">${to(number - 1, 'step-back', words.previousStep)}${to(number + 1, 'step-on', words.nextStep)}</nav>`;
}
