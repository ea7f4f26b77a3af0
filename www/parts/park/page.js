// The first screen: park them all by hand, then let evolution try.
/** @import { Page, Tools } from '../part.js' */
import './style.css';
import { render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { followSize } from '../../kit/size.js';
import { pause } from '../../kit/loop.js';
import { followKeys } from '../../kit/map.js';
import { once, watch } from '../../kit/memo.js';
import { createWaiting } from '../../lab/waiting.js';
import { withExercise } from '../../link/link.js';
import { shownExercise } from '../../run/exercise.js';
import { isFree } from '../../run/guard.js';
import { afterWords } from '../../words/pick.js';
import { createSection } from '../section.js';
import { load as loadAfter } from './after/words/load.js';
import { isOver, parkedBy } from './film.js';
import { createParkPicture } from './picture.js';
import { createPlay } from './play.js';
import { heading, sight } from './sight.js';
import { parkSlice } from './state.js';
import { createTask, inLab, linkInLab, parkedOf } from './task.js';
import words from './words/index.js';

/** The step of the lesson that makes one generation by hand. */
const howStep = 7;

/** @param {Tools} tools @returns {Promise<Page>} */
export async function createPage(tools) {
  const { engine, store, paper, links } = tools;
  const task = createTask(engine);
  const element = createSection('park');
  const { plane, canvases, note } = createPlane();
  const [head, side] = [create('div', 'park-head column'), create('div', 'park-side column')];
  element.append(head, plane, side);
  const picture = createParkPicture(canvases, task);
  // All of them drive.
  await pause();
  const play = createPlay(engine, store, paper, task);
  const size = followSize(plane, play.request);
  const later = createLater(store.redraw, async () => {
    const { createAfter } = await afterWords([loadAfter], () => import('./after/page.js'));
    return createAfter(tools, task, play, { note, side, size });
  });
  plane.addEventListener('click', async (event) => {
    if (event.target instanceof HTMLCanvasElement) (await later.bring())?.press(event);
  });
  followKeys(plane, {
    onStep: async ([right, up]) => (await later.bring())?.step(right - up > 0 ? 1 : -1),
    onEscape() {
      if (parkSlice.of(store.get()).looked === null) return false;
      parkSlice.update(store, { looked: null });
      return true;
    },
  });

  const changed = watch();
  return {
    element,
    draw(state) {
      play.follow();
      const film = play.film();
      const { gains, evolving, bred, looked } = parkSlice.of(store.get());
      picture({ film, theme: state.theme, size: size(), looked });
      // Whoever has begun may go on to all the rest.
      if (gains || bred.length > 0) later.bring();
      const after = later.there();
      // While generations rush by, what each comes to.
      const parked = evolving ? (bred.at(-1)?.parked ?? 0) : parkedBy(film);
      const model = {
        ...parkSlice.of(state),
        gains: play.gains(),
        driven: play.driven(),
        driving: parkedOf(film.drives),
        film,
        moved: gains !== null,
        isFree: isFree(state, 'gains'),
        isOwn: play.isOwn(),
        parked,
        over: isOver(film),
        count: task.starts.length,
        tolerance: task.tolerance,
        population: task.population,
      };
      const said = [parked, model.over && film, model.isOwn, after, later.failed(), shownExercise(state)];
      // Its links carry what stands beside Park as well.
      if (!changed(state.slices.park, ...said, ...links.carried(state))) return;
      plane.setAttribute('aria-label', words.planeLabel(parked, model.count));
      const found = inLab(state, task.experiment);
      const lab = found && linkInLab(state, found, tools);
      const lesson = isFree(state, 'lesson')
        ? withExercise(links.linkOfStep(howStep), state, engine.experiment)
        : null;
      const on = { ...play.on, lesson, lab };
      render(heading(model, after), head);
      render(sight(model, on, after, later.failed()), side);
      after?.draw(state, model);
    },
  };
}

/** The picture, which keys and presses ask of its robots, and what is said of one. */
function createPlane() {
  const canvases = Array.from({ length: 3 }, () => document.createElement('canvas'));
  for (const canvas of canvases) canvas.setAttribute('aria-hidden', 'true');
  const note = create('div', 'park-look');
  const picture = { 'data-picture': 'park', 'data-name': words.pictureName };
  const attributes = { class: 'park-plane layers', ...picture, role: 'application', tabindex: 0 };
  const plane = create('div', attributes, ...canvases, note);
  return { plane, canvases, note };
}

/**
 * What is loaded when it is asked for; where it cannot be, an element says so, and the rest goes on.
 * @template T
 * @param {() => void} onEnd @param {() => Promise<T>} load
 */
function createLater(onEnd, load) {
  /** @type {T | null} */
  let there = null;
  /** @type {HTMLElement | null} */
  let failed = null;
  return {
    there: () => there,
    failed: () => failed,
    bring: once(async () => {
      try {
        there = await load();
      } catch (error) {
        const waiting = createWaiting();
        waiting.fail(error);
        failed = waiting.element;
      }
      onEnd();
      return there;
    }),
  };
}
