// An exercise as who follows the link sees it: the task at the top, and the controls that are locked or hidden.
/** @import { Exercise, Group } from '../../run/exercise.js' */
/** @import { Scene } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
import { byId } from '../../kit/elements.js';
import { isEmbedded } from '../../kit/host.js';
import { once, watch } from '../../kit/memo.js';
import { exercise as words } from '../../words/index.js';
import {
  asksSomething,
  groupNames,
  isEmpty,
  noExercise,
  shownExercise,
  tidyTask,
  wayOf,
} from '../../run/exercise.js';

/** @typedef {Partial<Record<Group, { lock?: string, hide?: string }>>} Places Where the controls of a group stand, as selectors: what is locked, and what is gone when they are hidden. */

/** Those of the lab and the lesson. @type {Places} */
const own = {
  gains: { lock: '#gains', hide: '#gains, #gains-note' },
  drives: { lock: '#drives, .standing-name', hide: '#drives' },
  paper: {
    lock: '#drives-paper-ep, #drives-paper-arbitrary',
    hide: 'label:has(> #drives-paper-ep), label:has(> #drives-paper-arbitrary)',
  },
  postures: { lock: '#handles, #restore-postures', hide: '#handles, #postures .hint' },
  run: { lock: '#evolution-clock, #evolution-pace', hide: '.evolving' },
  seed: { lock: '#new-seed', hide: '#new-seed' },
  clock: { lock: '#robot-clock', hide: '#robot-clock' },
  settings: {
    lock: '#preset, #settings-button, #weights',
    hide: '#preset, #settings-button, #weights',
  },
  parts: { lock: '#pages a:not(#page-lesson)', hide: '#pages a:not(#page-lesson)' },
  lesson: {
    lock: '#page-lesson, #lesson-step, #lesson a',
    hide: '#page-lesson, .lesson-head, .lesson-foot, .tries, .sheet-link',
  },
  share: { lock: '#keep-button', hide: '#keep-button' },
};

/** What there is to do is loaded with the first exercise that asks for something. @param {import('../handin/work.js').WorkTools} tools */
function createWorkOnDemand(tools) {
  /** @type {ReturnType<typeof import('../handin/work.js').createWork> | null} */
  let work = null;
  const load = once(async () => {
    try {
      const { createWork } = await import('../handin/work.js');
      work = createWork(tools, byId('exercise-work'));
      tools.store.redraw();
    } catch (error) {
      console.warn(error);
    }
  });
  return (/** @type {State} */ state, /** @type {Scene} */ scene) => {
    if (asksSomething(shownExercise(state)) || state.student.handin) load();
    work?.draw(state, scene);
  };
}

/** @param {import('../handin/work.js').WorkTools & { places: readonly Places[] }} tools `places` of the parts of the page. */
export function createExercise({ places, ...tools }) {
  const { store, engine, links } = tools;
  const work = createWorkOnDemand(tools);
  const all = [own, ...places];
  const section = byId('exercise');
  const [label, task, locks] = ['task-label', 'task', 'exercise-locks'].map((id) => byId(id));
  const leave = byId('exercise-leave');
  // In a small frame a long task scrolls.
  if (isEmbedded) section.tabIndex = 0;
  // What moves is written into no address: only who is about to press takes it along as it is now.
  for (const type of ['pointerdown', 'focus', 'click'])
    leave.addEventListener(type, () =>
      leave.setAttribute(
        'href',
        `#${links.linkOf({ ...store.get(), exercise: noExercise }, engine.experiment)}`,
      ),
    );
  for (const type of ['click', 'auxclick']) document.addEventListener(type, keepFromLinks, true);

  const changed = watch();
  const placesChanged = watch();
  return {
    /** @param {State} state @param {number} made How many parts of the page have been opened. @param {Scene} scene */
    draw(state, made, scene) {
      const exercise = shownExercise(state);
      work(state, scene);
      // Each step of the lesson has controls of its own, and so has each part.
      if (placesChanged(exercise, state.lesson, made))
        for (const group of groupNames) lay(all, exercise, group);
      if (!changed(exercise, state.student.handin)) return;
      document.body.toggleAttribute('data-exercise', asksSomething(exercise));
      section.hidden = isEmpty(exercise) && state.student.handin === '';
      task.textContent = tidyTask(exercise.task);
      label.hidden = task.textContent === '';
      task.hidden = label.hidden;
      const named = (/** @type {import('../../run/exercise.js').Way} */ way) =>
        groupNames.filter((group) => wayOf(exercise, group) === way).map((group) => words.groups[group]);
      locks.textContent = words.locksText(named('locked'), named('hidden'));
    },
  };
}

/** @param {readonly Places[]} places @param {Exercise} exercise @param {Group} group */
function lay(places, exercise, group) {
  const way = wayOf(exercise, group);
  const found = (/** @type {'lock' | 'hide'} */ kind) =>
    places.flatMap((one) => {
      const selector = one[group]?.[kind];
      return selector ? [...document.querySelectorAll(selector)] : [];
    });
  for (const element of found('lock')) lock(element, way === 'locked');
  for (const element of found('hide')) element.toggleAttribute('data-away', way === 'hidden');
}

/** A control, or a fieldset of them, by the browser's own means; what is no form says so itself. @param {Element} element @param {boolean} locked */
function lock(element, locked) {
  if (element.hasAttribute('data-locked') === locked) return;
  element.toggleAttribute('data-locked', locked);
  if ('disabled' in element) element.disabled = locked;
  else if (locked) element.setAttribute('aria-disabled', 'true');
  else element.removeAttribute('aria-disabled');
  const others = (element.getAttribute('aria-describedby') ?? '').replace(/ ?exercise-locks$/, '');
  const described = locked ? `${others} exercise-locks`.trim() : others;
  if (described) element.setAttribute('aria-describedby', described);
  else element.removeAttribute('aria-describedby');
}

/** A link cannot be disabled. @param {Event} event */
function keepFromLinks(event) {
  if (!(event.target instanceof Element) || !event.target.closest('a[data-locked]')) return;
  event.preventDefault();
  event.stopPropagation();
}
