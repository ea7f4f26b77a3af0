// The panel beside any part of the page in which every setting of the experiment can be changed.
/** @import { Engine } from '../core/engine.js' */
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { State } from '../run/state.js' */
/** @import { Store } from '../run/store.js' */
/** @import { RowView } from './rows.js' */
/** @import { GroupName, Row } from './table.js' */
import { html, render } from 'lit-html';
import { guard } from 'lit-html/directives/guard.js';
import { byId, create } from '../kit/elements.js';
import { letterOf } from '../kit/keyboard.js';
import { once, remember, watch } from '../kit/memo.js';
import { closeButton } from '../kit/templates.js';
import { fieldPath, valueAt } from '../run/paths.js';
import { asked, presets } from '../run/state.js';
import { settings as words } from '../words/index.js';
import { createChoice, createNumber, typingMark } from './rows.js';
import { rows, table } from './table.js';

const { texts } = words;

const groups = /** @type {[GroupName, readonly Row[]][]} */ (Object.entries(table));
/** Open from the beginning; the others show how much in them is changed. @type {readonly GroupName[]} */
const openGroups = ['limits', 'weights'];

/** Beside the instrument, closed. Its title is still to come. @param {string} id @param {string} className */
export function createPanel(id, className) {
  const panel = create('aside', { id, class: className, hidden: '', 'aria-labelledby': `${id}-title` });
  byId('instrument').prepend(panel);
  return panel;
}

/** @param {{ engine: Engine, store: Store, actions: Actions }} parts @param {(state: State) => boolean} hasLab Whether what is set, undone and redone is in sight. */
export function createSettingsPanel({ engine, store, actions }, hasLab) {
  const button = byId('settings-button');
  const panel = createPanel('settings', 'settings column');
  button.hidden = false;
  const originals = createOriginals(engine);
  const rowsMade = once(() => createRows(engine, actions, originals.somewhere));
  const open = (/** @type {boolean} */ isOpen) => {
    actions.openSettings(isOpen);
    button.focus();
  };
  const on = {
    close: () => open(false),
    undo: () => actions.undo(),
    redo: () => actions.redo(),
    backToPreset() {
      actions.backToPreset();
      // The button that was pressed is about to go.
      byId('settings-undo').focus();
    },
  };
  button.addEventListener('click', () => actions.openSettings(!store.get().settings.open));
  followHelp(panel, () => [...rowsMade().values()]);
  followKeys(panel, button, store, actions, hasLab);

  const changed = watch();
  return {
    /** @param {State} state */
    draw(state) {
      const { settings, maker } = state;
      const { experiment, preset, versions } = asked(state);
      const isOpen = settings.open && hasLab(state);
      if (!changed(settings, isOpen, maker.open, experiment, preset, versions)) return;
      panel.hidden = !isOpen;
      button.setAttribute('aria-expanded', String(isOpen));
      byId('instrument').classList.toggle('with-settings', isOpen || maker.open);
      const original = originals.of(preset);
      const differing = rows.flatMap(({ path }) =>
        valueAt(experiment, path) === valueAt(original, path) ? [] : path,
      );
      button.textContent = words.buttonText(differing.length);
      button.dataset.other = words.buttonText(1);
      button.title = words.changedText(differing.length);
      if (!isOpen) return;
      const views = rowsMade();
      render(panelOf({ settings, versions }, new Set(differing), views, on), panel);
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

/**
 * @param {Pick<State, 'settings' | 'versions'>} state @param {Set<string>} differing @param {Map<string, RowView>} views
 * @param {Record<'close' | 'undo' | 'redo' | 'backToPreset', () => void>} on
 */
const panelOf = ({ settings, versions }, differing, views, on) => html`
  <div class="settings-head">
    <h2 id="settings-title">${texts.settingsTitle}</h2>
    <button id="settings-undo" type="button" aria-disabled=${String(versions.past.length === 0)} @click=${on.undo}>${texts.undo}</button>
    <button id="settings-redo" type="button" aria-disabled=${String(versions.future.length === 0)} @click=${on.redo}>${texts.redo}</button>
    ${closeButton('settings-close', texts.closeSettings, on.close)}
    <p class="muted"><span id="settings-changed">${words.changedText(differing.size)}</span>
      <button id="settings-preset" type="button" class="link" .hidden=${differing.size === 0} @click=${on.backToPreset}>${texts.backToPreset}</button></p>
  </div>
  <div id="settings-groups" class="settings-groups">${groups.map(([name, members]) => {
    const count = members.filter(({ path }) => differing.has(path)).length;
    const isRefused = members.some(({ path }) => path === settings.error?.path);
    // What somebody has opened or closed since stays so.
    return html`<details id="settings-${name}" .open=${guard([isRefused], () => isRefused || isOpen(name))}>
      <summary>${words.groups[name]} <span class="muted">${count === 0 ? '' : words.changedText(count)}</span></summary>
      ${members.map(({ path }) => views.get(path)?.element)}
    </details>`;
  })}</div>
  <p id="settings-help" class="settings-help muted" aria-hidden="true" .textContent=${words.hint}></p>`;

/** @param {GroupName} name */
const isOpen = (name) =>
  /** @type {HTMLDetailsElement | null} */ (document.getElementById(`settings-${name}`))?.open ??
  openGroups.includes(name);

/** @param {Engine} engine */
function createOriginals(engine) {
  const of = remember((/** @type {State['preset']} */ preset) => engine.experiment(preset));
  const all = presets.map((name) => engine.experiment(name));
  return {
    of,
    /** A limit that a preset has, for who switches one on that the chosen preset has not. @param {string} path */
    somewhere: (path) => all.map((experiment) => valueAt(experiment, path)).find((value) => value !== null),
  };
}

/** @param {Engine} engine @param {Actions} actions @param {(path: string) => import('../run/paths.js').Value | undefined} somewhere @returns {Map<string, RowView>} */
function createRows(engine, actions, somewhere) {
  const fields = new Map(engine.fields().map((field) => [field.path, field]));
  const wordsOf = new Map(engine.wordFields().map((field) => [field.path, field.words]));
  return new Map(
    rows.map((row) => {
      const field = fields.get(fieldPath(row.path));
      return [
        row.path,
        field
          ? createNumber(row, field, actions, Number(somewhere(row.path) ?? row.first ?? 0))
          : createChoice(row, wordsOf.get(row.path) ?? [], actions),
      ];
    }),
  );
}

/** What the setting under the pointer or in the focus does, in one place that does not move. @param {HTMLElement} panel @param {() => readonly RowView[]} viewsOf */
function followHelp(panel, viewsOf) {
  const show = (/** @type {Event} */ event) => {
    const row = event.target instanceof Element ? event.target.closest('.setting') : null;
    const view = row && viewsOf().find(({ element }) => element === row);
    if (view) byId('settings-help').textContent = view.help;
  };
  panel.addEventListener('pointerover', show);
  panel.addEventListener('focusin', show);
}

/** Escape closes; Ctrl+Z and Ctrl+Y undo and redo, wherever nobody types. @param {HTMLElement} panel @param {HTMLElement} button @param {Store} store @param {Actions} actions @param {(state: State) => boolean} hasLab */
function followKeys(panel, button, store, actions, hasLab) {
  document.addEventListener('keydown', (event) => {
    if (event.defaultPrevented || document.querySelector('dialog[open]')) return;
    const target = /** @type {Node} */ (event.target);
    const isOurs = panel.contains(target) || target === button || target === document.body;
    if (event.key === 'Escape' && isOurs && hasLab(store.get()) && store.get().settings.open) {
      event.preventDefault();
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
    const key = letterOf(event);
    if ((key !== 'z' && key !== 'y') || !hasLab(store.get())) return;
    event.preventDefault();
    if (key === 'y' || event.shiftKey) actions.redo();
    else actions.undo();
  });
}
