// The pinned drives: their names, and a table of what differs between them and the run on screen.
/** @import { Experiment, Field, Run, Triple } from '../../core/engine.js' */
/** @import { Pin } from '../../run/pins.js' */
/** @import { Tools } from '../part.js' */
/** @import { View } from './page.js' */
import { html, noChange, nothing, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { byId } from '../../kit/elements.js';
import { takesBack } from '../../kit/keyboard.js';
import { watch } from '../../kit/memo.js';
import { createSwatch } from '../../kit/swatch.js';
import { tidyText } from '../../kit/text.js';
import { gainsOf } from '../../run/drivers.js';
import { fieldPath, valueAt } from '../../run/paths.js';
import { styles } from '../../run/pins.js';
import { createQuantity } from '../../settings/quantity.js';
import { rows as settingRows } from '../../settings/table.js';
import { lab, settings as settingWords } from '../../words/index.js';
import words from './words/index.js';
import { curvesSlice } from './state.js';

/** @typedef {{ name: string, gains: Triple, experiment: Experiment, run: Run, slot: number | null }} Column */
/** @typedef {{ head: string, className?: string, texts: readonly string[] }} Row */
/** @typedef {{ onTyping: (slot: number | null) => void, onName: (slot: number, text: string) => void, onUnpin: (slot: number) => void }} PinEvents */

/** @param {HTMLElement} root @param {Tools} tools @returns {View} */
export function createComparison(root, { engine, store, actions, paper }) {
  const settingTexts = createSettingTexts(engine.fields());
  const say = (/** @type {string} */ message) => curvesSlice.update(store, { message });
  /** The slot of the pin whose name is being typed. @type {number | null} */
  let typing = null;
  /** @type {PinEvents} */
  const on = {
    onTyping(slot) {
      typing = slot;
    },
    onName(slot, text) {
      typing = null;
      const name = tidyText(text);
      if (name === '') return say(words.nameNeeded);
      actions.renamePin(slot, name);
      say('');
    },
    onUnpin(slot) {
      actions.unpin(slot);
      say('');
      // The button that was pressed is gone.
      const isLast = store.get().pins.length === 0;
      (isLast ? byId('pin') : /** @type {HTMLElement} */ (root.querySelector('input'))).focus();
    },
  };
  const changed = watch();

  return {
    draw(state, { driving, experiment, pins: pinned }, { name }) {
      const { pins } = state;
      const { message } = curvesSlice.of(state);
      if (!changed(pins, message, driving, name)) return;
      const gains = gainsOf(state, state.driver, paper);
      const columns = [
        { name, gains, experiment, run: driving, slot: null },
        ...pins.map((pin, i) => ({ ...pin, run: pinned[i] })),
      ];
      render(
        html`
          <p id="pins-text" class="muted">${pins.length === 0 ? words.noPinsText : words.pinsText(pins.length)}</p>
          <ul id="pins-list" class="pins-list">${pins.map((pin) => itemOf(pin, on, pin.slot === typing))}</ul>
          <p id="pins-message" class="field-error" role="alert" .hidden=${message === ''}>${message}</p>
          <div class="curves-scroll" tabindex="0" role="group" aria-label=${words.texts.comparisonTable}>
            ${tableOf(columns, settingTexts)}
          </div>`,
        root,
      );
    },
  };
}

/** @param {string} name @param {PinEvents['onTyping']} onTyping @returns {(event: KeyboardEvent) => void} */
const takingBack = (name, onTyping) => (event) => {
  const field = /** @type {HTMLInputElement} */ (event.target);
  if (!takesBack(event, field.value !== name)) return;
  field.value = name;
  onTyping(null);
};

/** @param {Pin} pin @param {PinEvents} on @param {boolean} isTyping What is typed stays, also while evolution runs. */
const itemOf = ({ slot, name }, { onTyping, onName, onUnpin }, isTyping) => html`
  <li class="row">
    ${createSwatch(styles[slot])}
    <input id="pin-name-${slot + 1}" type="text" maxlength="60" autocomplete="off" spellcheck="false"
      aria-label=${words.nameLabel(slot)} .value=${isTyping ? noChange : live(name)}
      @input=${() => onTyping(slot)} @blur=${() => onTyping(null)} @keydown=${takingBack(name, onTyping)}
      @change=${(/** @type {Event} */ { target }) => onName(slot, /** @type {HTMLInputElement} */ (target).value)}>
    <button id="unpin-${slot + 1}" type="button" aria-label=${words.unpin(name)} @click=${() => onUnpin(slot)}>${words.unpinShort}</button>
  </li>`;

/** @param {readonly Column[]} columns @param {(experiments: readonly Experiment[]) => Row[]} settingTexts */
function tableOf(columns, settingTexts) {
  const differing = settingTexts(columns.map(({ experiment }) => experiment));
  return html`
    <table id="pins-table" class="curves-table ruled" aria-label=${words.texts.comparisonTable}>
      <thead><tr><td></td>${columns.map(headOf)}</tr></thead>
      <tbody>
        ${resultRows(columns).map(rowOf)}
        ${columns.length > 1 ? html`<tr><th class="group" colspan=${columns.length + 1} scope="rowgroup">${differing.length > 0 ? words.settingsThatDiffer : words.sameSettings}</th></tr>` : nothing}
        ${differing.map(rowOf)}
      </tbody>
    </table>`;
}

/** @param {Column} column */
const headOf = ({ name, slot }) =>
  html`<th class=${slot === null ? 'driving' : ''} scope="col">${slot === null ? nothing : html`${createSwatch(styles[slot])}<br>`}${words.breakable(slot === null ? words.drivingColumn(name) : name)}</th>`;

/** @param {Row} row */
const rowOf = ({ head, className = '', texts }) =>
  html`<tr><th class=${className} scope="row">${head}</th>${texts.map((text) => html`<td>${text}</td>`)}</tr>`;

/** @param {readonly Column[]} columns @returns {Row[]} */
function resultRows(columns) {
  /** @param {string} head @param {(column: Column) => string} text @param {string} [className] */
  const row = (head, text, className) => ({ head, className, texts: columns.map(text) });
  return [
    row(lab.costSymbol, ({ run }) => lab.costText(run.cost.total), 'strong'),
    ...lab.costParts
      .filter(([part]) => part !== 'penalty' || columns.some(({ run }) => run.cost.penalty > 0))
      .map(([part, head]) => row(head, ({ run }) => lab.partText(run.cost[part]), 'part')),
    row(words.outcomeHead, ({ run }) => words.outcomeShort(run)),
    row(words.finalTimeHead, ({ run }) => words.finalTimeText(run)),
    ...lab.gains.map(({ id, name }, i) => row(name, ({ gains }) => words.gainText(gains[i]), id)),
  ];
}

/** What differs between experiments, as it is shown in the settings. @param {Field[]} fields */
function createSettingTexts(fields) {
  const known = new Map(fields.map((field) => [field.path, field]));
  /** @param {string} path @param {Experiment} experiment */
  const text = (path, experiment) => {
    const value = valueAt(experiment, path);
    const field = known.get(fieldPath(path));
    if (!field) return settingWords.settings[path].choices?.[String(value)] ?? String(value);
    if (typeof value !== 'number') return settingWords.noLimit;
    const quantity = createQuantity(field);
    return settingWords.quantity(String(quantity.shown(value)), quantity.unit);
  };
  /** @param {readonly Experiment[]} experiments @returns {Row[]} */
  return (experiments) => {
    const differs = (/** @type {(experiment: Experiment) => unknown} */ value) =>
      experiments.some((experiment) => value(experiment) !== value(experiments[0]));
    const rows = settingRows
      .filter(({ path }) => differs((experiment) => valueAt(experiment, path)))
      .map(({ path }) => ({
        head: settingWords.settings[path].name,
        texts: experiments.map((experiment) => text(path, experiment)),
      }));
    // Those that evolution drives from beside the first.
    if (!differs(({ starts }) => JSON.stringify(starts.slice(1)))) return rows;
    const texts = experiments.map(({ starts }) => words.startsText(starts.length));
    return [...rows, { head: words.startsHead, texts }];
  };
}
