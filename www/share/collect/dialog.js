// The sheet on which hand-ins are checked.
/** @import { Sheet } from '../../kit/sheet.js' */
/** @import { SheetTools } from '../load.js' */
/** @import { Given, Row } from './check.js' */
/** @import { Column } from './words/common.js' */
import './style.css';
import { html, nothing } from 'lit-html';
import { download } from '../../kit/download.js';
import { byId, create } from '../../kit/elements.js';
import { addressOf } from '../../kit/host.js';
import { fillTable, mostRows } from '../../kit/table.js';
import { isEmpty, noExercise } from '../../run/exercise.js';
import { isFull, pinOf, styles } from '../../run/pins.js';
import { nobody } from '../../run/variant.js';
import { messageOf } from '../../words/errors.js';
import { createCharts } from './chart.js';
import { createChecker } from './check.js';
import { createReader, mostOfAll } from './entries.js';
import { filesIn, readAll } from './files.js';
import { csvName, csvOf, nameOf, remarksOf, tableOf } from './table.js';
import words from './words/index.js';

const { texts } = words;

/** @typedef {{ status: string, isBad: boolean, share: number | null, rows: Row[], given: Given | null, files: File[], order: import('./table.js').Order, pinned: Set<number>, first: number }} View */
/** @typedef {Omit<SheetTools, 'openChecks' | 'openCode' | 'openCollect'>} Tools */

/** @type {View} */
const noView = {
  status: '',
  isBad: false,
  share: null,
  rows: [],
  given: null,
  files: [],
  order: { column: 'number', isDown: false },
  pinned: new Set(),
  first: 0,
};

/** @param {Tools} tools @param {Sheet} sheet */
export function createCollect(tools, sheet) {
  const { engine, store, links } = tools;
  const rowsElement = create('table', 'collect-table');
  const charts = createCharts();
  /** @type {View} */
  let view = noView;
  const update = (/** @type {Partial<View>} */ patch) => {
    view = { ...view, ...patch };
    draw();
  };
  const { check, stop } = createChecking(tools, () => view, update);
  const on = {
    ...createRowEvents(tools, sheet, () => view, update),
    check,
    cancel() {
      stop();
      update({ share: null, status: words.cancelled });
    },
    /** @param {Event} event */
    choose({ target }) {
      const input = /** @type {HTMLInputElement} */ (target);
      update({ files: [...view.files, ...(input.files ?? [])] });
      input.value = '';
      check();
    },
    /** Another class. */
    empty() {
      stop();
      /** @type {NodeListOf<HTMLInputElement>} */
      const fields = document.querySelectorAll('#collect-text, #collect-exercise');
      for (const field of fields) field.value = '';
      update({ ...noView, order: view.order });
      byId('collect-text').focus();
    },
    /** @param {number} first */
    show: (first) => update({ first }),
  };

  sheet.dialog.addEventListener('dragover', (event) => {
    event.preventDefault();
    event.stopPropagation();
  });
  sheet.dialog.addEventListener('drop', async (event) => {
    event.preventDefault();
    event.stopPropagation();
    const { dataTransfer } = event;
    if (!dataTransfer) return;
    const text = dataTransfer.getData('text/plain');
    if (text) /** @type {HTMLTextAreaElement} */ (byId('collect-text')).value += `\n${text}`;
    update({ files: [...view.files, ...(await filesIn(dataTransfer))] });
    check();
  });
  // The event comes late: the sheet may be open again.
  sheet.dialog.addEventListener('close', () => {
    if (!sheet.dialog.open && view.share !== null) on.cancel();
  });

  const draw = () => {
    sheet.draw(contentOf(view, rowsElement, on));
    const { rows, order, pinned, first, given } = view;
    if (rows.length === 0) return;
    fillTable(rowsElement, tableOf(rows, order, pinned, on), first);
    charts.draw(rows, given, store.get().theme);
  };

  return {
    start() {
      draw();
      const { exercise } = store.get();
      const asked = /** @type {HTMLInputElement} */ (byId('collect-exercise'));
      if (asked.value === '' && !isEmpty(exercise))
        asked.value = links.linkOf(store.get(), engine.experiment);
      byId('collect-text').focus();
    },
  };
}

/** The check that runs, which another one ends. @param {Tools} tools @param {() => View} viewNow @param {(patch: Partial<View>) => void} update */
function createChecking({ engine, links }, viewNow, update) {
  const reader = createReader(links.pages);
  const checker = createChecker(engine, links);
  let control = new AbortController();
  const field = (/** @type {string} */ id) => /** @type {HTMLTextAreaElement} */ (byId(id)).value;

  return {
    stop: () => control.abort(),

    async check() {
      control.abort();
      control = new AbortController();
      const { signal } = control;
      const began = performance.now();
      const asked = field('collect-exercise').trim();
      let exercise = null;
      try {
        if (asked !== '') exercise = checker.exerciseIn(asked);
      } catch (error) {
        return update({ status: words.noExercise(messageOf(error)), isBad: true });
      }
      update({ share: 0, status: '', isBad: false, rows: [], given: null, pinned: new Set(), first: 0 });
      try {
        const typed = field('collect-text').slice(0, mostOfAll);
        const entries = [
          ...(typed.trim() ? await reader.read(typed) : []),
          ...(await readAll(viewNow().files, reader)),
        ];
        if (entries.length === 0) return update({ share: null, status: words.nothing });
        const onProgress = (/** @type {number} */ share) => {
          if (!signal.aborted && share - (viewNow().share ?? 0) >= 0.01) update({ share });
        };
        const { rows, given } = await checker.check(entries, exercise, { signal, onProgress });
        const met = rows.filter(({ checked }) => checked?.judged?.isMet).length;
        const unread = rows.filter(({ checked }) => !checked).length;
        const marked = rows.filter((row) => row.checked && remarksOf(row, rows).length > 0).length;
        const status = words.summary(rows.length, met, unread, marked, performance.now() - began);
        update({ share: null, rows, given, status });
      } catch (error) {
        if (!signal.aborted) update({ share: null, status: words.failed(messageOf(error)), isBad: true });
      }
    },
  };
}

/** What can be done with the rows that are there. @param {Tools} tools @param {Sheet} sheet @param {() => View} viewNow @param {(patch: Partial<View>) => void} update */
const createRowEvents = ({ store, actions, open }, sheet, viewNow, update) => ({
  /** @param {Column} column */
  sort(column) {
    const { order } = viewNow();
    update({ order: { column, isDown: column === order.column && !order.isDown }, first: 0 });
  },
  /** @param {number} row @param {boolean} isPinned */
  pin(row, isPinned) {
    const pinned = new Set(viewNow().pinned);
    if (isPinned) pinned.add(row);
    else pinned.delete(row);
    update({ pinned });
  },
  /** One whole run, in which nothing is locked. @param {number} row */
  open(row) {
    const { checked } = viewNow().rows[row];
    if (!checked) return;
    sheet.dialog.close();
    const { pins } = store.get();
    open({ ...checked.run, pins, exercise: noExercise, student: nobody, parts: {} }, []);
  },
  pinAll() {
    const { rows, pinned } = viewNow();
    for (const row of pinned) {
      const { checked } = rows[row];
      const { pins } = store.get();
      if (!checked || isFull(pins)) continue;
      const driven = { experiment: checked.run.experiment, gains: checked.gains };
      // The same answer stands there once.
      if (!pinOf(pins, driven)) actions.togglePin(driven, nameOf(rows[row]) || words.rowNumber(row));
    }
    update({ status: words.pinnedText(styles.length) });
  },
  save() {
    const address = addressOf(location.href, '', false).replace(/#$/, '');
    download(csvName, 'text/csv', csvOf(viewNow().rows, address));
  },
});

/** @param {View} view @param {HTMLElement} table @param {{ check: () => void, cancel: () => void, choose: (event: Event) => void, empty: () => void, pinAll: () => void, save: () => void, show: (first: number) => void }} on */
const contentOf = ({ status, isBad, share, rows, given, files, pinned, first }, table, on) => html`
  <p class="muted">${texts.help}</p>
  <textarea id="collect-text" rows=${rows.length > 0 ? 2 : 5} spellcheck="false" aria-label=${texts.paste}></textarea>
  <div class="bar collect-bar">
    <button id="collect-check" type="button" class="primary" @click=${on.check}>${texts.check}</button>
    <button id="collect-cancel" type="button" .hidden=${share === null} @click=${on.cancel}>${texts.cancel}</button>
    <progress id="collect-progress" max="1" aria-label=${texts.progress} .hidden=${share === null} .value=${share ?? 0}></progress>
    <button id="collect-files" type="button" @click=${() => byId('collect-file').click()}>${texts.files}</button>
    <button id="collect-folder" type="button" @click=${() => byId('collect-directory').click()}>${texts.folder}</button>
    <input id="collect-file" type="file" multiple hidden @change=${on.choose}>
    <input id="collect-directory" type="file" webkitdirectory hidden @change=${on.choose}>
    <span class="muted">${words.filesText(files.length)}</span>
    <button id="collect-empty" type="button" .hidden=${files.length === 0} @click=${on.empty}>${texts.empty}</button>
    <input id="collect-exercise" type="text" spellcheck="false" autocomplete="off" aria-label=${texts.exercise} placeholder=${texts.exercise}>
  </div>
  <p id="collect-status" class=${isBad ? 'field-error' : ''} role="status">${status} ${given ? html`<span class="muted">${words.judgedBy(given.id, given.run.exercise.task)}</span>` : nothing}</p>
  <div class="collect-charts" .hidden=${rows.length === 0}>
    <div id="collect-histogram" role="img" aria-label=${texts.histogram}></div>
    <div id="collect-gains" role="img" aria-label=${texts.gains}></div>
  </div>
  <div class="bar" .hidden=${rows.length === 0}>
    <button id="collect-csv" type="button" class="primary" @click=${on.save}>${texts.csv}</button>
    <button id="collect-pin" type="button" .disabled=${pinned.size === 0} @click=${on.pinAll}>${texts.pin}</button>
    ${rows.length > mostRows ? pager(rows.length, first, on.show) : nothing}
  </div>
  <div class="table-scroll" tabindex="0" role="group" aria-label=${texts.table} .hidden=${rows.length === 0}>${table}</div>`;

/** @param {number} count @param {number} first @param {(first: number) => void} show */
function pager(count, first, show) {
  const last = Math.min(first + mostRows, count);
  return html`
    <button id="collect-before" type="button" .disabled=${first === 0} @click=${() => show(first - mostRows)}>${texts.before}</button>
    <button id="collect-after" type="button" .disabled=${last === count} @click=${() => show(first + mostRows)}>${texts.after}</button>
    <span class="muted">${words.rowsText(first + 1, last, count)}</span>`;
}
