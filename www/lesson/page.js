// The lesson: the words of one step beside the lab's own views.
import { byId } from '../kit/elements.js';
import { followSize } from '../kit/size.js';
import { isEmbedded } from '../kit/host.js';
import { watch } from '../kit/memo.js';
import { gainsOf } from '../run/drivers.js';
import { createStep, nameOf } from './blocks.js';
import { createErrorPosture } from './views/error-posture.js';
import { createLit } from './terms.js';
import { createPlace } from './keepsake.js';
import { settle } from './questions/settle.js';
import { createSights, figureOf } from './sights.js';
import { steps } from './steps.js';
import { titleOf } from '../lab/navigation.js';
import { createStage, stageOf } from './stage.js';
import { createTally } from './duel/tally.js';
import { keepPlaceInTurning } from './turning.js';
import './beside.css';
import './views/error-posture.css';
import './style.css';
import './formulas/formula.css';
import './questions/quiz.css';
import './views/near.css';
import './views/pushes.css';
import './views/standings.css';
import './sheets.css';
import './duel/duel.css';
import './stage.css';
import './views/lineage.css';
import './views/energy.css';
import './build.css';
import './low.css';

/** @import { TemplateResult } from 'lit-html' */
/** @import { Engine, PaperResult, Sample, Samples, Triple } from '../core/engine.js' */
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Store } from '../run/store.js' */

/** What runs now: all that a step's values, answers and views are made of. @typedef {{ engine: Engine, state: State, scene: Scene, paper: PaperResult[], gains: Triple, samples: Samples, at: number, sample: Sample, decided: Sample }} Live Every sample of the drive, and which it is at the robots’ clock: what is, and what the law decided last, which at the end of a drive is one sample old. */
/** What a step holds, drawn at every change; it may have to end something when it is left. @typedef {{ element: HTMLElement, draw: (live: Live) => void, leave?: () => void }} Block */
/** The same, or what never changes. @typedef {{ element: HTMLElement | TemplateResult, draw: (live: Live) => void }} Part */
/** @import { Sight } from './sights.js' */
/** @typedef {{ go: (link: string) => void, look: (sight?: Sight) => void, store: Store, actions: Actions, engine: Engine }} Tools */

/** @param {Omit<Tools, 'look'> & { paper: PaperResult[] }} parts */
export function createLessonPage({ engine, store, actions, paper, go }) {
  const article = byId('lesson');
  const sights = createSights(byId('sights'));
  const tools = { engine, store, actions, go, look: sights.look };
  const goToPlace = createPlace(article, () => store.get().lesson);
  const tally = createTally(store);
  const stage = createStage(tools);
  const errorPosture = createErrorPosture(byId('error-posture'));
  const samples = createSamples(engine);
  const openChanged = watch();
  const stepChanged = watch();
  const headChanged = watch();
  createLit();
  keepPlaceInTurning(article);
  /** @type {Part[]} */
  let blocks = [];
  followHead(/** @type {HTMLElement} */ (document.querySelector('.masthead')));
  followLinks(article, tools);

  return {
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const { lesson } = state;
      const step = steps[lesson - 1];
      const place = stageOf(step, state)?.place;
      const figure = figureOf(step, state);
      if (headChanged(lesson, state.page, figure, place)) {
        document.body.toggleAttribute('data-lesson', lesson > 0);
        if (step) document.title = titleOf(nameOf(lesson));
        document.body.dataset.figure = figure;
        article.hidden = !step;
        sights.open(step, state.page, figure, place);
      }
      errorPosture.hide(!step?.overlay);
      stage.open(step, state);
      const isOpened = openChanged(lesson);
      if (!step) return;
      const isNew = stepChanged(lesson);
      if (isNew) {
        followFocus(article, () => {
          blocks = createStep(article, step, lesson, tools);
        });
      }
      const live = {
        engine,
        state,
        scene,
        paper,
        gains: gainsOf(state, state.driver, paper),
        ...samples(state, scene),
      };
      if (isOpened && step.time) actions.standAt(step.time(live));
      tally.count(live, step);
      if (step.overlay) errorPosture.draw(live);
      stage.draw(live);
      for (const block of blocks) block.draw(live);
      // What it holds gives it its height.
      if (isNew && !state.dragging) goToPlace(lesson);
      // In a low window it is below the figure; a page around this frame stays where it is.
      if (isNew && !isEmbedded && document.activeElement?.id === 'lesson-title')
        byId('lesson-title').scrollIntoView({ block: 'nearest' });
      settle(live, step, tools);
    },
  };
}

/** Who led from one step to another is at the title of the new one, or goes on in the list. @param {HTMLElement} article @param {() => void} make Takes the place of the step before. */
function followFocus(article, make) {
  const before = document.activeElement;
  const isWithin = document.hasFocus() && article.contains(before);
  make();
  if (isWithin)
    byId(before?.id === 'lesson-step' ? 'lesson-step' : 'lesson-title').focus({ preventScroll: true });
}

/** What is pressed in the text opens within the page, and what it is about comes into sight. @param {HTMLElement} article @param {Tools} tools */
function followLinks(article, { go, look, store, actions, engine }) {
  article.addEventListener('click', (event) => {
    const link = event.target instanceof Element ? event.target.closest('a') : null;
    if (!link || event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    const href = link.getAttribute('href') ?? '';
    if (!href.startsWith('#')) return;
    event.preventDefault();
    go(href.slice(1));
    // What a word of the text opens is seen there.
    if (link.closest('.prose, .notice') && !/^#(lab|lesson)\b/.test(href)) look('part');
    for (const block of steps[store.get().lesson - 1]?.blocks ?? []) {
      const pressed = block.kind === 'tries' && block.tries.find(([name]) => name === link.dataset.try);
      if (!pressed) continue;
      const [, , sight, time] = pressed;
      look(sight);
      if (time) actions.standAt(time(engine, store.get()));
      block.begins?.(store);
    }
  });
}

/** Figure and words begin below the head. @param {HTMLElement} head */
function followHead(head) {
  const write = () => document.body.style.setProperty('--head', `${head.clientHeight}px`);
  write();
  // What lies below gets another height by it, and with a scroll bar the head another width: that is for the next frame.
  followSize(head, () => requestAnimationFrame(write));
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
      samples,
      at: Math.min(at, last),
      sample: samples.at(Math.min(at, last)),
      decided: samples.at(Math.min(at, Math.max(last - 1, 0))),
    };
  };
}
