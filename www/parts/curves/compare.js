// The pinned runs: their names, and a table of what differs between them and the run on screen.
import { curvesSlice } from './state.js';
import { byId, create } from '../../kit/elements.js';
import { headCell } from '../../kit/table.js';
import { styles } from '../../run/pins.js';
import { createSwatch } from '../../kit/swatch.js';
import { createQuantity } from '../../settings/quantity.js';
import { fieldPath, valueAt } from '../../run/paths.js';
import { rows as settingRows } from '../../settings/table.js';
import { watch } from '../../kit/memo.js';
import { curves as words, lab, settings as settingWords } from '../../words/index.js';

/** @typedef {import('../../core/engine.js').Experiment} Experiment */
/** @typedef {import('../../core/engine.js').Field} Field */
/** @typedef {import('../../core/engine.js').Run} Run */
/** @typedef {import('../part.js').Tools} PageParts */
/** @typedef {import('../../run/pins.js').Pin} Pin */
/** @typedef {import('../../run/scene.js').Scene} Scene */
/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../core/engine.js').Triple} Triple */
/** @typedef {{ name: string, gains: Triple, experiment: Experiment, run: Run, slot: number | null }} Column */
/** @typedef {{ id: string, head: string, className?: string, texts: readonly string[] }} Row */

/** @param {PageParts} parts */
export function createComparison({ engine, store, actions }) {
  const list = byId('pins-list');
  const message = byId('pins-message');
  const table = byId('pins-table');
  const settingTexts = createSettingTexts(engine.fields());
  const say = (/** @type {string} */ text) => curvesSlice.update(store, { message: text });
  const on = {
    /** @param {number} slot @param {string} text */
    onName(slot, text) {
      const name = text.trim();
      if (name === '') return say(words.nameNeeded);
      actions.renamePin(slot, name);
      say('');
    },
    /** @param {number} slot */
    onUnpin(slot) {
      actions.unpin(slot);
      say('');
      // The button that was pressed is gone.
      (list.querySelector('input') ?? byId('pin')).focus();
    },
  };

  const pinsChanged = watch();
  const tableChanged = watch();
  return {
    /** @param {State} state @param {{ name: string, gains: Triple, scene: Scene }} driving */
    draw(state, { name, gains, scene }) {
      const { pins } = state;
      const said = curvesSlice.of(state).message;
      if (pinsChanged(pins, said)) {
        byId('pins-text').textContent = pins.length === 0 ? words.noPinsText : words.pinsText(pins.length);
        list.replaceChildren(...pins.map((pin) => createItem(pin, on)));
        message.textContent = said;
        message.hidden = said === '';
      }
      if (!tableChanged(pins, scene.driving, name)) return;
      const columns = [
        { name, gains, experiment: scene.experiment, run: scene.driving, slot: null },
        ...pins.map((pin, i) => ({ ...pin, run: scene.pins[i] })),
      ];
      table.replaceChildren(createHead(columns), createBody(columns, settingTexts));
    },
  };
}

/** @param {Pin} pin @param {{ onName: (slot: number, text: string) => void, onUnpin: (slot: number) => void }} on */
function createItem({ slot, name }, { onName, onUnpin }) {
  const item = document.createElement('li');
  const input = document.createElement('input');
  const button = document.createElement('button');
  Object.assign(input, { type: 'text', id: `pin-name-${slot + 1}`, value: name, maxLength: 60 });
  Object.assign(input, { autocomplete: 'off', spellcheck: false });
  input.setAttribute('aria-label', words.nameLabel(slot));
  input.addEventListener('change', () => onName(slot, input.value));
  Object.assign(button, { type: 'button', id: `unpin-${slot + 1}`, textContent: words.unpinShort });
  button.setAttribute('aria-label', words.unpin(name));
  button.addEventListener('click', () => onUnpin(slot));
  item.append(createSwatch(styles[slot]), input, button);
  return item;
}

/** @param {readonly Column[]} columns */
function createHead(columns) {
  const head = document.createElement('thead');
  const row = head.insertRow();
  row.append(document.createElement('td'));
  for (const { name, slot } of columns) {
    const swatch = slot === null ? [] : [createSwatch(styles[slot]), create('br', '')];
    const text = words.breakable(slot === null ? words.drivingColumn(name) : name);
    row.append(headCell('col', slot === null ? 'driving' : '', ...swatch, text));
  }
  return head;
}

/** @param {readonly Column[]} columns @param {(experiments: readonly Experiment[]) => Row[]} settingTexts */
function createBody(columns, settingTexts) {
  const differing = settingTexts(columns.map(({ experiment }) => experiment));
  const body = document.createElement('tbody');
  for (const row of resultRows(columns)) body.append(createRow(row));
  const title = document.createElement('th');
  Object.assign(title, { colSpan: columns.length + 1, scope: 'rowgroup', className: 'group' });
  title.textContent = differing.length > 0 ? words.settingsThatDiffer : words.sameSettings;
  body.insertRow().append(title);
  for (const row of differing) body.append(createRow(row));
  return body;
}

/** @param {Row} row */
function createRow({ id, head, className = '', texts }) {
  const cells = texts.map((text) => create('td', '', text));
  const row = create('tr', '', headCell('row', className, head), ...cells);
  row.dataset.row = id;
  return row;
}

/** @param {readonly Column[]} columns @returns {Row[]} */
function resultRows(columns) {
  /** @param {string} id @param {string} head @param {(column: Column) => string} text @param {string} [className] */
  const row = (id, head, text, className) => ({ id, head, className, texts: columns.map(text) });
  return [
    row('total', lab.costSymbol, ({ run }) => lab.costText(run.cost.total), 'strong'),
    ...lab.costParts
      .filter(([part]) => part !== 'penalty' || columns.some(({ run }) => run.cost.penalty > 0))
      .map(([part, head]) => row(part, head, ({ run }) => lab.partText(run.cost[part]), 'part')),
    row('outcome', words.outcomeHead, ({ run }) => words.outcomeShort(run)),
    row('finalTime', words.finalTimeHead, ({ run }) => words.finalTimeText(run)),
    ...lab.gains.map(({ id, name }, i) => row(id, name, ({ gains }) => words.gainText(gains[i]), id)),
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
        id: path,
        head: settingWords.settings[path].name,
        texts: experiments.map((experiment) => text(path, experiment)),
      }));
    // Those that evolution drives from beside the first.
    if (!differs(({ starts }) => JSON.stringify(starts.slice(1)))) return rows;
    const texts = experiments.map(({ starts }) => words.startsText(starts.length));
    return [...rows, { id: 'starts', head: words.startsHead, texts }];
  };
}
