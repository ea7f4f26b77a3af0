// What Park has for whoever has tried something: what is seen beside the robots then, and what is said of one of them.
/** @import { State } from '../../../run/state.js' */
/** @import { Tools } from '../../part.js' */
/** @import { Model } from '../sight.js' */
import { nothing, render } from 'lit-html';
import { isEmbedded, isStill } from '../../../kit/host.js';
import { planOf } from '../picture.js';
import { parkSlice } from '../state.js';
import { driveInLab, linkInLab } from '../task.js';
import { createLook } from './look.js';
import * as sight from './sight.js';
import { createWalk } from './walk.js';
import { lab } from '../../../words/index.js';
import words from './words/index.js';

/** @typedef {ReturnType<typeof createAfter>} After */

/** @param {Tools} tools @param {ReturnType<typeof import('../task.js').createTask>} task @param {ReturnType<typeof import('../play.js').createPlay>} play @param {{ note: HTMLElement, side: HTMLElement, size: () => { width: number, height: number } }} places */
export function createAfter(tools, task, play, { note, side, size }) {
  const { engine, store } = tools;
  const look = createLook(engine, task);
  const { now: slice, update } = parkSlice.at(store);
  const show = (/** @type {number | null} */ looked) => update({ looked });
  let wasEvolving = slice().evolving;

  /** The link to the drive of one robot alone. @param {State} state @param {number} index */
  const linkTo = (state, index) =>
    linkInLab(state, driveInLab(state, task.alone(index), play.driven()), tools);

  return {
    ...sight,
    walk: createWalk(store, task, play),

    /** What is to be said, once all have driven: of the robot that is looked at, with where it comes from, or of what evolution has found. @param {Model} model */
    told(model) {
      const { looked, driven, best, bred, isOwn, between } = model;
      const newest = bred.at(-1);
      if (looked !== null)
        return `${look.textOf(looked, driven)} ${lab.startName}: ${lab.postureText(task.starts[looked])}`;
      // What the slider of the way says itself.
      if (between) return '';
      if (!newest || isOwn) return null;
      const ending = `${sight.ending(model, newest)}${sight.beyond(model, newest)}`;
      return best && best.parked < newest.parked ? `${ending} ${words.youParked(best.parked)}` : ending;
    },

    /** @param {MouseEvent} event On the picture. */
    press({ offsetX, offsetY }) {
      if (slice().evolving) return;
      show(look.nearest(play.film(), planOf(size(), task), [offsetX, offsetY]));
    },

    /** @param {1 | -1} step */
    step(step) {
      if (!slice().evolving) show(look.stepped(slice().looked, step));
    },

    /** @param {State} state @param {Model} model */
    draw(state, model) {
      const { looked, evolving, over, driven, isOwn } = model;
      const isTold = looked !== null && over && !evolving;
      // Not upon the robot itself.
      note.classList.toggle('is-above', isTold && task.starts[looked].y < task.goal.y);
      render(isTold ? look.note(looked, driven, linkTo(state, looked), show) : nothing, note);
      // In a frame it would move the page around.
      if (wasEvolving && !evolving && !isOwn && !isEmbedded)
        side
          .querySelector('.park-on')
          ?.scrollIntoView({ block: 'nearest', behavior: isStill() ? 'auto' : 'smooth' });
      wasEvolving = evolving;
    },
  };
}
