// The first screen: park them all by hand, then let evolution try.
/** @import { State } from '../../run/state.js' */
/** @import { Page, Tools } from '../part.js' */
import './style.css';
import { render } from 'lit-html';
import { create, followSize } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { isFree } from '../../run/guard.js';
import { createSection } from '../section.js';
import { isOver, parkedBy } from './film.js';
import { createParkPicture } from './picture.js';
import { createPlay } from './play.js';
import { heading, sight } from './sight.js';
import { parkSlice } from './state.js';
import { createTask, inLab, mostGain } from './task.js';
import words from './words/index.js';

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
  const play = createPlay(engine, store, paper, task);
  const size = followSize(plane, play.request);

  const changed = watch();
  return {
    element,
    draw(state) {
      play.follow();
      const film = play.film();
      picture({ film, theme: state.theme, size: size() });
      const { gains, evolving, bred } = parkSlice.of(store.get());
      // While generations rush by, what each comes to.
      const parked = evolving ? (bred.at(-1)?.parked ?? 0) : parkedBy(film);
      const model = {
        ...parkSlice.of(state),
        gains: play.gains(),
        moved: gains !== null,
        isFree: isFree(state, 'gains'),
        isOwn: play.isOwn(),
        parked,
        over: isOver(film),
        count: task.starts.length,
        tolerance: task.tolerance,
        most: mostGain,
        population: task.population,
      };
      if (!changed(state.slices.park, parked, model.over, model.isFree, model.isOwn)) return;
      plane.setAttribute('aria-label', words.picture(parked, model.count));
      const found = inLab(state, task.experiment);
      const lab = found && links.linkOf(found, engine.experiment);
      render(heading(model), head);
      render(sight(model, { ...play.on, lesson: links.linkOfStep(1), lab }), side);
    },
  };
}
