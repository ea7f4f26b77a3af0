// The first screen: park them all by hand, then let evolution try.
/** @import { Triple } from '../../core/engine.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Page, Tools } from '../part.js' */
import './style.css';
import { render } from 'lit-html';
import { isLost, messageOf } from '../../words/errors.js';
import { create, followSize } from '../../kit/elements.js';
import { isStill } from '../../kit/host.js';
import { createFrameLoop } from '../../kit/loop.js';
import { remember, watch } from '../../kit/memo.js';
import { hidesPaper } from '../../run/exercise.js';
import { isFree } from '../../run/guard.js';
import { createSection } from '../section.js';
import { createBreeding } from './breeding.js';
import { filmOf, isOver, later, parkedBy } from './film.js';
import { createParkPicture } from './picture.js';
import { heading, linkToLab, sight } from './sight.js';
import { parkSlice } from './state.js';
import { anyGains, createTask, firstGains, mostGain, parkedOf } from './task.js';
import words from './words/index.js';

/** @typedef {import('./film.js').Film} Film */

/** @param {Tools} tools @returns {Page} */
export function createPage({ engine, store, paper, links }) {
  const task = createTask(engine);
  const element = createSection('park');
  const plane = create('div', 'park-plane layers');
  plane.dataset.picture = 'park';
  plane.dataset.name = words.pictureName;
  const canvases = Array.from({ length: 3 }, () => document.createElement('canvas'));
  for (const canvas of canvases) canvas.setAttribute('aria-hidden', 'true');
  plane.append(...canvases);
  plane.setAttribute('role', 'img');
  const [head, side] = [create('div', 'park-head'), create('div', 'park-side')];
  element.append(head, plane, side);
  const picture = createParkPicture(canvases, task);
  const slice = () => parkSlice.of(store.get());
  const update = (/** @type {Parameters<typeof parkSlice.update>[1]} */ patch) =>
    parkSlice.update(store, patch);

  const breeding = createBreeding(engine, task);
  const byHand = remember(
    (/** @type {number} */ kx, /** @type {number} */ ky, /** @type {number} */ ktheta) =>
      filmOf(task.drive([[kx, ky, ktheta]])[0], [], 'hand'),
  );
  const handFilm = (/** @type {Triple} */ [kx, ky, ktheta]) => byHand(kx, ky, ktheta);
  const gainsNow = () => slice().gains ?? (hidesPaper(store.get()) ? anyGains : firstGains(paper));
  /** @type {Film} */
  let film = handFilm(gainsNow());
  if (isStill()) film = later(film, Number.POSITIVE_INFINITY);

  const show = (/** @type {Film} */ next) => {
    film = isStill() ? later(next, Number.POSITIVE_INFINITY) : next;
    loop.request();
  };

  const on = {
    /** @param {number} index @param {number} value */
    slide(index, value) {
      const gains = /** @type {[number, number, number]} */ ([...gainsNow()]);
      gains[index] = value;
      show({ ...handFilm(gains), time: 0 });
      update({ gains, evolving: false });
      if (isStill()) ended();
    },
    again: () => show({ ...film, time: 0 }),
    evolve() {
      try {
        const { seed, bred } = slice();
        const next = bred.length > 0 ? seed + 1 : seed;
        breeding.begin(next);
        update({ seed: next, bred: [], evolving: true, message: '' });
        breed();
      } catch (error) {
        if (isLost(error)) throw error;
        update({ evolving: false, message: messageOf(error) });
      }
    },
    stop: () => update({ evolving: false }),
  };

  /** One generation more, as a film. */
  function breed() {
    const { bred } = slice();
    const { drives, others, robot } = breeding.next(bred.at(-1) ?? null);
    const length = bred.length < 3 ? 'first' : robot.gains === bred.at(-1)?.gains ? 'same' : 'next';
    update({ bred: [...bred, robot] });
    show(filmOf(drives, others, length));
  }

  /** The film has come to its end. */
  function ended() {
    const { gains, best, evolving, bred } = slice();
    if (evolving) {
      if (breeding.isDone(bred)) {
        update({ evolving: false });
        show({ ...filmOf(film.drives, [], 'hand') });
      } else breed();
      return;
    }
    const parked = parkedOf(film.drives);
    if (gains && film.drives === handFilm(gains).drives && (!best || parked > best.parked))
      update({ best: { gains, parked } });
  }

  const loop = createFrameLoop((seconds) => {
    if (store.get().page !== 'park') return false;
    const wasOver = isOver(film);
    film = later(film, seconds);
    store.redraw();
    if (isOver(film) && (!wasOver || slice().evolving)) ended();
    return !isOver(film) || slice().evolving;
  });
  loop.request();
  const size = followSize(plane, loop.request);

  const changed = watch();
  const linkOf = remember((/** @type {State} */ state) => links.linkOf(state, engine.experiment));
  return {
    element,
    draw(state) {
      const { theme } = state;
      // Other gains, where an exercise hides the paper's.
      const isUntouched = slice().gains === null && slice().bred.length === 0;
      if (isUntouched && film.drives !== handFilm(gainsNow()).drives)
        show({ ...handFilm(gainsNow()), time: 0 });
      picture({ film, theme, size: size() });
      const { evolving, bred } = slice();
      // While generations rush by, what each comes to.
      const parked = evolving ? (bred.at(-1)?.parked ?? 0) : parkedBy(film);
      const model = {
        ...parkSlice.of(state),
        gains: gainsNow(),
        moved: slice().gains !== null,
        isFree: isFree(state, 'gains'),
        isOwn: film.drives === handFilm(gainsNow()).drives,
        parked,
        over: isOver(film),
        count: task.starts.length,
        tolerance: task.tolerance,
        most: mostGain,
        population: task.population,
      };
      if (!changed(state.slices.park, parked, model.over, model.isFree, model.isOwn)) return;
      plane.setAttribute('aria-label', words.picture(parked, model.count));
      const lab = linkToLab(state, task.experiment(model.seed), model.bred, linkOf);
      render(heading(model), head);
      render(sight(model, { ...on, lesson: links.linkOfStep(1), lab }), side);
    },
  };
}
