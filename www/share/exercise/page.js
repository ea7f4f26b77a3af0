// An exercise as who follows the link sees it: the task at the top, and the controls that are locked or hidden.
import { byId } from '../../kit/elements.js';
import { isEmbedded } from '../../kit/host.js';
import { linkOf } from '../../link/link.js';
import { watch } from '../../kit/memo.js';
import { exercise as words } from '../../words/index.js';
import { groupNames, isEmpty, noExercise, shownExercise, tidyTask, wayOf } from '../../run/exercise.js';

/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../run/exercise.js').Exercise} Exercise */
/** @typedef {import('../../run/exercise.js').Group} Group */

/** Where the controls of a group stand: what is locked, and what is gone when they are hidden. @type {Record<Group, { lock: string, hide: string }>} */
const places = {
  gains: { lock: '#gains, #landscape-map, #luck-rank', hide: '#gains, #gains-note' },
  drives: { lock: '#drives, .standing-name', hide: '#drives' },
  paper: {
    lock: '#drives-paper-ep, #drives-paper-arbitrary',
    hide: 'label:has(> #drives-paper-ep), label:has(> #drives-paper-arbitrary)',
  },
  postures: {
    lock: '#handles, #restore-postures, #robustness-map, #training-seen, #training-unseen',
    hide: '#handles, #postures .hint',
  },
  run: {
    lock: '#evolution-clock, #evolution-pace, #generation-step, #training-evolve, #luck-run',
    hide: '.evolving, #generation-step button, .training-controls, .luck-bar',
  },
  seed: { lock: '#new-seed, #luck-open', hide: '#new-seed, #luck-open' },
  clock: { lock: '#robot-clock', hide: '#robot-clock' },
  settings: {
    lock: '#preset, #settings-button, #disturbance-controls, #weights',
    hide: '#preset, #settings-button, #disturbance-controls, #weights',
  },
  parts: { lock: '#pages a:not(#page-lesson)', hide: '#pages a:not(#page-lesson)' },
  lesson: {
    lock: '#page-lesson, #lesson-step, #lesson a',
    hide: '#page-lesson, .lesson-head, .lesson-foot, .tries, .sheet-link',
  },
  share: { lock: '#keep-button', hide: '#keep-button' },
};

/** @param {{ store: import('../../run/state.js').Store, engine: import('../../core/engine.js').Engine }} parts */
export function createExercise({ store, engine }) {
  const section = byId('exercise');
  const [label, task, locks] = ['task-label', 'task', 'exercise-locks'].map((id) => byId(id));
  const leave = byId('exercise-leave');
  // In a small frame a long task scrolls.
  if (isEmbedded) section.tabIndex = 0;
  // What moves is written into no address: only who is about to press takes it along as it is now.
  for (const type of ['pointerdown', 'focus', 'click'])
    leave.addEventListener(type, () =>
      leave.setAttribute('href', `#${linkOf({ ...store.get(), exercise: noExercise }, engine.experiment)}`),
    );
  for (const type of ['click', 'auxclick']) document.addEventListener(type, keepFromLinks, true);

  const changed = watch();
  const placesChanged = watch();
  return {
    /** @param {State} state */
    draw(state) {
      const exercise = shownExercise(state);
      // Each step of the lesson has controls of its own.
      if (placesChanged(exercise, state.lesson)) for (const group of groupNames) lay(exercise, group);
      if (!changed(exercise)) return;
      section.hidden = isEmpty(exercise);
      task.textContent = tidyTask(exercise.task);
      label.hidden = task.textContent === '';
      task.hidden = label.hidden;
      const named = (/** @type {import('../../run/exercise.js').Way} */ way) =>
        groupNames.filter((group) => wayOf(exercise, group) === way).map((group) => words.groups[group]);
      locks.textContent = words.locksText(named('locked'), named('hidden'));
    },
  };
}

/** @param {Exercise} exercise @param {Group} group */
function lay(exercise, group) {
  const way = wayOf(exercise, group);
  for (const element of document.querySelectorAll(places[group].lock)) lock(element, way === 'locked');
  for (const element of document.querySelectorAll(places[group].hide))
    element.toggleAttribute('data-away', way === 'hidden');
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
