// The lesson: the words of one step beside the lab's own views.
import { disturbanceSlice } from '../parts/disturbance/state.js';
import { generationSlice } from '../parts/generation/state.js';
import { landscapeSlice } from '../parts/landscape/state.js';
import { byId, create, write } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { gainsOf } from '../run/drivers.js';
import { lesson as words } from '../words/index.js';
import { createErrorPosture } from './error-posture.js';
import { createFormula } from './formula.js';
import { createLit } from './lit.js';
import { inline, list, paragraphs } from './prose.js';
import { createQuiz } from './quiz.js';
import { createSights } from './sights.js';
import { hrefOf, steps } from './steps.js';
import { progressSlice } from './state.js';
import { createTally } from './tally.js';

/** @typedef {import('../core/engine.js').Engine} Engine */
/** @typedef {import('../core/engine.js').PaperResult} PaperResult */
/** @typedef {import('../core/engine.js').Sample} Sample */
/** @typedef {import('../run/scene.js').Scene} Scene */
/** @typedef {import('../run/state.js').State} State */
/** @typedef {import('../run/store.js').Store} Store */
/** @typedef {import('../core/engine.js').Triple} Triple */
/** @typedef {import('./quiz.js').Quiz} Quiz */
/** @typedef {import('./quiz.js').Outcome} Outcome */
/** @typedef {import('./steps.js').Step} Step */

/** What runs now: all that a step's values, answers and views are made of. @typedef {{ engine: Engine, state: State, scene: Scene, paper: PaperResult[], gains: Triple, sample: Sample, decided: Sample }} Live At the robots’ clock: what is, and what the law decided last, which at the end of a drive is one sample old. */
/** What a step holds, drawn at every change. @typedef {{ element: HTMLElement, draw: (live: Live) => void }} Block */
/** A prediction, and what came out once it is known. @typedef {{ choice: number, outcome: Outcome | null }} Answer */
/** @typedef {{ go: (link: string) => void, store: Store, actions: import('../run/actions/actions.js').Actions, engine: Engine }} Tools */

/** @param {Tools & { paper: PaperResult[] }} parts */
export function createLesson({ engine, store, actions, paper, go }) {
  const article = byId('lesson');
  const tools = { engine, store, actions, go };
  const tally = createTally(store);
  const errorPosture = createErrorPosture(byId('error-posture'));
  const samples = createSamples(engine);
  const stepChanged = watch();
  const headChanged = watch();
  const sights = createSights(byId('sights'));
  createLit();
  /** @type {Block[]} */
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
  /** @type {{ run: Scene['driving'], samples: Sample[] } | null} */
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
    return { sample: samples[Math.min(at, last)], decided: samples[Math.min(at, Math.max(last - 1, 0))] };
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
    pending.add(answer);
    Promise.resolve(block.quiz.answer(live)).then((outcome) => {
      const { answers } = progressSlice.of(store.get());
      if (answers[key] === answer)
        progressSlice.update(store, { answers: { ...answers, [key]: { ...answer, outcome } } });
    });
  }
}
/** @type {WeakSet<Answer>} */
const pending = new WeakSet();

/** @param {HTMLElement} article @param {Step} step @param {number} number @param {Tools} tools @returns {Block[]} */
function createStep(article, step, number, tools) {
  const text = words.steps[step.name];
  const href = (/** @type {string} */ link) => hrefOf(link, number);
  const blocks = step.blocks.map((block) => createBlock(block, step, text, href, tools));
  const heading = create('h2', '', text.title);
  heading.id = 'lesson-title';
  article.replaceChildren(
    createHead(number),
    heading,
    ...blocks.map(({ element }) => element),
    createFoot(number),
  );
  const values = [.../** @type {NodeListOf<HTMLElement>} */ (article.querySelectorAll('[data-value]'))];
  const changed = watch();
  return [
    ...blocks,
    {
      element: article,
      draw(live) {
        if (
          !changed(
            live.scene.driving,
            live.sample,
            live.state.history,
            live.state.generation,
            generationSlice.of(live.state),
            progressSlice.of(live.state),
            landscapeSlice.of(live.state).result,
            disturbanceSlice.of(live.state).measured,
          )
        )
          return;
        const known = step.values?.(live) ?? {};
        for (const element of values) {
          write(element, known[element.dataset.value ?? ''] ?? '–');
        }
      },
    },
  ];
}

/** @param {import('./steps.js').Content} block @param {Step} step @param {any} text @param {(link: string) => string} href @param {Tools} tools @returns {Block} */
function createBlock(block, step, text, href, tools) {
  const still = (/** @type {HTMLElement} */ element) => ({ element, draw() {} });
  switch (block.kind) {
    case 'text':
      return still(create('div', 'prose', ...paragraphs(text.texts[block.name], href)));
    case 'formula':
      return createFormula(block.formula);
    case 'notice':
      return still(create('section', 'notice', create('h3', '', words.notice), list(text.notice, href)));
    case 'tries':
      return still(
        create(
          'section',
          'tries',
          create('h3', '', words.tries),
          create(
            'ul',
            '',
            ...block.tries.map(([name, link]) => {
              const anchor = Object.assign(create('a', 'try'), { href: href(link) });
              anchor.dataset.try = name;
              anchor.append(create('span', '', ...inline(text.tries[name], href)));
              return create('li', '', anchor);
            }),
          ),
        ),
      );
    case 'quiz':
      return createQuestion(block, step, text, href, tools);
    case 'view':
      return block.create(tools, text, href);
  }
}

/** @param {Extract<import('./steps.js').Content, { kind: 'quiz' }>} block @param {Step} step @param {any} text @param {(link: string) => string} href @param {Tools} tools */
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

/** Where one is, and a way to every step. @param {number} number */
function createHead(number) {
  const select = document.createElement('select');
  select.id = 'lesson-step';
  select.setAttribute('aria-label', words.stepLabel);
  select.replaceChildren(
    ...steps.map(({ name }, i) => new Option(`${i + 1}  ${words.steps[name].title}`, String(i + 1))),
  );
  select.value = String(number);
  select.addEventListener('change', () => {
    const link = create('a', '');
    link.setAttribute('href', hrefOf(steps[Number(select.value) - 1].link, Number(select.value)));
    select.after(link);
    link.click();
  });
  return create('div', 'lesson-head', create('p', 'muted', words.stepOf(number, steps.length)), select);
}

/** @param {number} number */
function createFoot(number) {
  const to = (
    /** @type {number} */ other,
    /** @type {string} */ className,
    /** @type {(title: string) => string} */ text,
  ) => {
    const link = create('a', className, text(words.steps[steps[other - 1].name].title));
    link.setAttribute('href', hrefOf(steps[other - 1].link, other));
    return link;
  };
  const links = [];
  if (number > 1) links.push(to(number - 1, 'step-back', words.previousStep));
  if (number < steps.length) links.push(to(number + 1, 'step-on', words.nextStep));
  return create('nav', 'lesson-foot', ...links);
}
