// The panel in which a lecturer makes an exercise; the page beside it shows at once what students will see.
import { byId, create } from '../../kit/elements.js';
import { frameOf } from '../frame-text.js';
import { addressOf } from '../../kit/host.js';
import { copy } from '../../kit/copy.js';
import { createSegmented } from '../../kit/segmented.js';
import { watch } from '../../kit/memo.js';
import { embed as embedWords, exercise as words, keep as keepWords } from '../../words/index.js';
import { groupNames, isEmpty, mostOfTask, wayOf, withWay } from '../../run/exercise.js';

/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../run/exercise.js').Exercise} Exercise */

/** @param {{ engine: import('../../core/engine.js').Engine, store: import('../../run/store.js').Store, actions: import('../../run/actions/actions.js').Actions, links: import('../../link/link.js').Links }} parts */
export function createMaker({ engine, store, actions, links }) {
  const panel = byId('maker');
  /** @type {HTMLTextAreaElement} */
  const task = byId('maker-task');
  /** @type {HTMLInputElement} */
  const link = byId('maker-link');
  /** @type {HTMLInputElement} */
  const frame = byId('maker-frame');
  const status = byId('maker-status');
  const change = (/** @type {Exercise} */ draft) => actions.makeExercise({ draft });
  const draftNow = () => store.get().maker.draft;

  const rows = groupNames.map((group) => {
    const name = create('span', 'maker-name', words.groups[group]);
    name.setAttribute('aria-hidden', 'true');
    const fieldset = /** @type {HTMLFieldSetElement} */ (create('fieldset', 'segmented'));
    fieldset.id = `maker-${group}`;
    const { draw } = createSegmented(fieldset, words.groups[group], words.ways, (way) =>
      change(withWay(draftNow(), group, way)),
    );
    return { group, draw, element: create('div', 'maker-row', name, fieldset) };
  });
  byId('maker-groups').replaceChildren(...rows.map(({ element }) => element));
  task.maxLength = mostOfTask;
  task.addEventListener('input', () => change({ ...draftNow(), task: task.value }));

  byId('keep-exercise').addEventListener('click', () => {
    /** @type {HTMLDialogElement} */ (byId('keep')).close();
    const { exercise, maker } = store.get();
    status.textContent = '';
    actions.makeExercise({ open: true, draft: isEmpty(exercise) ? maker.draft : exercise });
  });
  const close = () => {
    actions.makeExercise({ open: false });
    byId('keep-button').focus();
  };
  byId('maker-close').addEventListener('click', close);
  panel.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') close();
  });
  for (const field of [link, frame]) field.addEventListener('focus', () => field.select());
  byId('maker-copy-link').addEventListener('click', () => copy(link, status, keepWords));
  byId('maker-copy-frame').addEventListener('click', () => copy(frame, status, embedWords));

  const openChanged = watch();
  const draftChanged = watch();
  return {
    /** @param {State} state */
    draw(state) {
      const { open, draft } = state.maker;
      if (openChanged(open)) {
        panel.hidden = !open;
        if (open) task.focus();
      }
      if (!open) return;
      const text = links.linkOf({ ...state, exercise: draft }, engine.experiment);
      if (!draftChanged(draft, text)) return;
      if (task.value !== draft.task) task.value = draft.task;
      byId('maker-count').textContent = words.countText(draft.task.length, mostOfTask);
      for (const { group, draw } of rows) draw(wayOf(draft, group));
      link.value = addressOf(location.href, text, false);
      frame.value = frameOf(state, text);
    },
  };
}
