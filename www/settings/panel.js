// The panel beside any part of the page in which every setting of the experiment can be changed.
import { byId } from '../kit/elements.js';
import { remember, watch } from '../kit/memo.js';
import { settings as words } from '../words/index.js';
import { fieldPath, valueAt } from '../run/paths.js';
import { createChoice, createNumber, typingMark } from './rows.js';
import { rows, table } from './table.js';

/** @typedef {import('../run/actions/actions.js').Actions} Actions */
/** @typedef {import('../core/engine.js').Engine} Engine */
/** @typedef {import('../core/engine.js').Experiment} Experiment */
/** @typedef {import('../run/state.js').State} State */
/** @typedef {import('../run/store.js').Store} Store */
/** @typedef {import('./rows.js').RowView} RowView */
/** @typedef {import('./table.js').Row} Row */
/** @typedef {{ open: boolean, error: { path: string, text: string } | null }} SettingsState */

/** @type {SettingsState} */
export const firstSettings = { open: false, error: null };

/** Open from the beginning; the others show how much in them is changed. @type {readonly import('../words/en/settings.js').GroupName[]} */
const openGroups = ['limits', 'weights'];

/** @param {{ engine: Engine, store: Store, actions: Actions }} parts */
export function createSettingsPanel({ engine, store, actions }) {
  const panel = byId('settings');
  const button = byId('settings-button');
  const presets = createPresets(engine);
  const views = createRows(engine, actions, presets.somewhere);
  const groups = createGroups(views);
  byId('settings-groups').replaceChildren(...groups.map(({ details }) => details));
  button.hidden = false;
  followHelp(panel, views);
  followButtons(actions, () => store.get().settings.open);
  followKeys(panel, button, store, actions);

  const openChanged = watch();
  const changed = watch();
  return {
    /** @param {State} state */
    draw({ settings, maker, experiment, preset, versions }) {
      if (openChanged(settings.open, maker.open)) {
        panel.hidden = !settings.open;
        button.setAttribute('aria-expanded', String(settings.open));
        byId('instrument').classList.toggle('with-settings', settings.open || maker.open);
      }
      if (!changed(settings.open, settings.error, experiment, preset, versions)) return;
      const original = presets.of(preset);
      const differing = new Set(
        rows.map(({ path }) => path).filter((path) => valueAt(experiment, path) !== valueAt(original, path)),
      );
      button.textContent = words.buttonText(differing.size);
      button.title = words.changedText(differing.size);
      if (!settings.open) return;
      byId('settings-changed').textContent = words.changedText(differing.size);
      byId('settings-preset').hidden = differing.size === 0;
      byId('settings-undo').setAttribute('aria-disabled', String(versions.past.length === 0));
      byId('settings-redo').setAttribute('aria-disabled', String(versions.future.length === 0));
      for (const group of groups) group.draw(differing, settings.error?.path ?? null);
      for (const [path, { draw }] of views)
        draw({
          experiment,
          value: valueAt(experiment, path),
          original: valueAt(original, path),
          error: settings.error?.path === path ? settings.error.text : '',
        });
    },
  };
}

/** @param {Engine} engine */
function createPresets(engine) {
  const of = remember((/** @type {State['preset']} */ preset) => engine.experiment(preset));
  const all = /** @type {const} */ (['velocity-limits', 'acceleration-limits']).map((name) =>
    engine.experiment(name),
  );
  return {
    of,
    /** A limit that a preset has, for who switches one on that the chosen preset has not. @param {string} path */
    somewhere: (path) =>
      all.map((experiment) => valueAt(experiment, path)).find((value) => value !== null) ?? 0,
  };
}

/** @param {Engine} engine @param {Actions} actions @param {(path: string) => import('../run/paths.js').Value} somewhere @returns {Map<string, RowView>} */
function createRows(engine, actions, somewhere) {
  const fields = new Map(engine.fields().map((field) => [field.path, field]));
  const wordsOf = new Map(engine.wordFields().map((field) => [field.path, field.words]));
  return new Map(
    rows.map((row) => {
      const field = fields.get(fieldPath(row.path));
      return [
        row.path,
        field
          ? createNumber(row, field, actions, Number(somewhere(row.path)))
          : createChoice(row, wordsOf.get(row.path) ?? [], actions),
      ];
    }),
  );
}

/** @param {Map<string, RowView>} views */
function createGroups(views) {
  return /** @type {[import('../words/en/settings.js').GroupName, readonly Row[]][]} */ (
    Object.entries(table)
  ).map(([name, members]) => {
    const details = document.createElement('details');
    const summary = document.createElement('summary');
    const count = document.createElement('span');
    details.id = `settings-${name}`;
    details.open = openGroups.includes(name);
    summary.append(`${words.groups[name]} `, count);
    count.className = 'muted';
    details.append(summary, ...members.map(({ path }) => /** @type {RowView} */ (views.get(path)).element));
    return {
      details,
      /** @param {Set<string>} differing @param {string | null} refused */
      draw(differing, refused) {
        const changed = members.filter(({ path }) => differing.has(path)).length;
        count.textContent = changed === 0 ? '' : words.changedText(changed);
        if (members.some(({ path }) => path === refused)) details.open = true;
      },
    };
  });
}

/** What the setting under the pointer or in the focus does, in one place that does not move. @param {HTMLElement} panel @param {Map<string, RowView>} views */
function followHelp(panel, views) {
  const help = byId('settings-help');
  help.textContent = words.hint;
  const show = (/** @type {Event} */ event) => {
    const row = event.target instanceof Element ? event.target.closest('.setting') : null;
    const view = [...views.values()].find(({ element }) => element === row);
    if (view) help.textContent = view.help;
  };
  panel.addEventListener('pointerover', show);
  panel.addEventListener('focusin', show);
}

/** @param {Actions} actions @param {() => boolean} isOpen */
function followButtons(actions, isOpen) {
  byId('settings-button').addEventListener('click', () => actions.openSettings(!isOpen()));
  byId('settings-close').addEventListener('click', () => {
    actions.openSettings(false);
    byId('settings-button').focus();
  });
  byId('settings-undo').addEventListener('click', actions.undo);
  byId('settings-redo').addEventListener('click', actions.redo);
  byId('settings-preset').addEventListener('click', () => {
    actions.backToPreset();
    // The button that was pressed is about to go.
    byId('settings-undo').focus();
  });
}

/** Escape closes; Ctrl+Z and Ctrl+Y undo and redo, wherever nobody types. @param {HTMLElement} panel @param {HTMLElement} button @param {Store} store @param {Actions} actions */
function followKeys(panel, button, store, actions) {
  document.addEventListener('keydown', (event) => {
    const target = /** @type {Node} */ (event.target);
    const isOurs = panel.contains(target) || target === button || target === document.body;
    if (event.key === 'Escape' && isOurs && store.get().settings.open) {
      actions.openSettings(false);
      button.focus();
      return;
    }
    const isTyping =
      target instanceof HTMLTextAreaElement ||
      (target instanceof HTMLInputElement &&
        target.type === 'text' &&
        (!panel.contains(target) || target.hasAttribute(typingMark)));
    if (!(event.ctrlKey || event.metaKey) || event.altKey || isTyping) return;
    const key = event.key.toLowerCase();
    if (key !== 'z' && key !== 'y') return;
    event.preventDefault();
    if (key === 'y' || event.shiftKey) actions.redo();
    else actions.undo();
  });
}
