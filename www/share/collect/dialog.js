// The sheet on which hand-ins are checked.
/** @import { Sheet } from '../../kit/sheet.js' */
/** @import { State } from '../../run/state.js' */
/** @import { SheetTools } from '../load.js' */
/** @import { Given, Row } from './check.js' */
import './style.css';
import { html, nothing } from 'lit-html';
import { byId, create } from '../../kit/elements.js';
import { fillTable } from '../../kit/table.js';
import { unless } from '../../kit/templates.js';
import { isEmpty } from '../../run/exercise.js';
import { messageOf } from '../../words/errors.js';
import { createCharts, labelsOf, legendOf } from './chart.js';
import { createChecking, unchecked } from './checking.js';
import { filesIn, joined } from './files.js';
import { createRowEvents, isPinned } from './rows.js';
import { createStrip } from './strip.js';
import { mostRows, tableOf } from './table.js';
import words from './words/index.js';

const { texts } = words;

/** What the sheet shows. `note`: what came of a press in the table; `opened`: the hand-in that is on the page, and since when it is. @typedef {{ status: string, isBad: boolean, note: string, share: number | null, rows: Row[], given: Given | null, files: File[], order: import('./table.js').Order, first: number, opened: { index: number, row: Row, since: number } | null }} View */
/** @type {View} */
const noView = { ...unchecked, files: [], order: { column: 'number', isDown: false }, opened: null };

/** @param {SheetTools} tools @param {Sheet} sheet */
export function createCollect(tools, sheet) {
  const { store } = tools;
  const rowsElement = /** @type {HTMLTableElement} */ (create('table', 'collect-table'));
  const charts = createCharts();
  /** @type {View} */
  let view = noView;
  const update = (/** @type {Partial<View>} */ patch) => {
    view = { ...view, ...patch };
    draw();
  };
  const { check, stop } = createChecking(tools, () => view, update);
  const fillExercise = createFilling(tools);
  const adding = createAdding(() => view, update, check);
  const rowEvents = createRowEvents(tools, sheet, () => view, update);
  const on = {
    ...rowEvents,
    check,
    cancel() {
      stop();
      update({ share: null, status: words.cancelled });
    },
    /** @param {Event} event */
    choose({ target }) {
      const input = /** @type {HTMLInputElement} */ (target);
      const chosen = [...(input.files ?? [])];
      input.value = '';
      adding.add(chosen);
    },
    /** Another class. */
    empty() {
      stop();
      adding.forget();
      /** @type {NodeListOf<HTMLInputElement>} */
      const fields = document.querySelectorAll('#collect-text, #collect-exercise');
      for (const field of fields) field.value = '';
      fillExercise();
      update({ ...noView, order: view.order });
      byId('collect-text').focus();
    },
    /** @param {number} first */
    show: (first) => update({ first }),
    typed: () => draw(),
  };
  const strip = createStrip({ open: on.open, back: tools.openCollect });
  followDrops(sheet.dialog, adding.add);
  // The event comes late: the sheet may be open again.
  sheet.dialog.addEventListener('close', () => {
    if (!sheet.dialog.open && view.share !== null) on.cancel();
  });

  const draw = () => {
    sheet.draw(contentOf(view, rowsElement, on));
    const { rows, order, first, given } = view;
    strip.draw(view, store.get().work.since);
    if (rows.length === 0) return;
    const table = tableOf(rows, order, (row) => isPinned(tools, row), on);
    fillTable(rowsElement, table, first, mostRows);
    // The sheet has its name already.
    rowsElement.caption?.classList.add('visually-hidden');
    charts.draw(rows, given, store.get().theme);
  };

  return {
    start() {
      draw();
      fillExercise();
      /** @type {HTMLElement | null} */
      const lastOpened = rowsElement.querySelector(`[data-open="${view.opened?.index}"]`);
      (lastOpened ?? byId('collect-text')).focus();
    },
    /** @param {State} state */
    drawOpened: ({ work }) => strip.draw(view, work.since),
  };
}

/** The exercise that is open is the one that is asked for, as long as nobody typed another. @param {SheetTools} tools */
function createFilling({ engine, store, links }) {
  let filled = '';
  return () => {
    const asked = /** @type {HTMLInputElement} */ (byId('collect-exercise'));
    const { exercise, student } = store.get();
    // What a student handed in may say another.
    if (isEmpty(exercise) || student.handin || !['', filled].includes(asked.value)) return;
    filled = links.linkOf(store.get(), engine.experiment);
    asked.value = filled;
  };
}

/** More files, each time to those that are there then, and only if they still are of the same class. @param {() => View} viewNow @param {(patch: Partial<View>) => void} update @param {() => void} check */
function createAdding(viewNow, update, check) {
  let forgotten = 0;
  /** @type {Promise<void>} */
  let last = Promise.resolve();
  return {
    /** @param {readonly File[] | Promise<readonly File[]>} more */
    add(more) {
      const before = forgotten;
      const read = Promise.all([more, last]).then(([some]) => joined(viewNow().files, some));
      last = read.then(
        (files) => {
          if (before !== forgotten) return;
          update({ files });
          check();
        },
        (error) => {
          if (before === forgotten) update({ status: words.failed(messageOf(error)), isBad: true });
        },
      );
    },

    /** Nothing that is still being read belongs to it. */
    forget() {
      forgotten += 1;
    },
  };
}

/** @param {HTMLDialogElement} dialog @param {(files: Promise<readonly File[]>) => void} add */
function followDrops(dialog, add) {
  dialog.addEventListener('dragover', (event) => {
    event.preventDefault();
    event.stopPropagation();
  });
  dialog.addEventListener('drop', (event) => {
    event.preventDefault();
    event.stopPropagation();
    const { dataTransfer } = event;
    if (!dataTransfer) return;
    const text = dataTransfer.getData('text/plain');
    if (text) /** @type {HTMLTextAreaElement} */ (byId('collect-text')).value += `\n${text}`;
    add(filesIn(dataTransfer));
  });
}

/** @typedef {{ check: () => void, cancel: () => void, choose: (event: Event) => void, empty: () => void, typed: () => void, save: () => void, show: (first: number) => void }} Events */

/** There is something of a class. @param {View} view */
const isUsed = ({ status, rows, files }) => {
  const field = /** @type {HTMLTextAreaElement | null} */ (document.getElementById('collect-text'));
  return rows.length > 0 || files.length > 0 || status !== '' || (field?.value ?? '') !== '';
};

/** @param {View} view @param {HTMLElement} table @param {Events} on */
function contentOf(view, table, on) {
  const { status, isBad, note, share, rows, given, files, first } = view;
  const isThere = rows.length > 0;
  const labels = labelsOf(rows, given);
  return html`
    <p class="muted" .hidden=${isThere}>${texts.help}</p>
    <textarea id="collect-text" rows=${isThere ? 1 : 5} spellcheck="false" aria-label=${texts.paste} @input=${on.typed}></textarea>
    <div class="bar collect-bar">
      <button id="collect-check" type="button" class="primary" @click=${on.check}>${texts.check}</button>
      <button id="collect-cancel" type="button" .hidden=${share === null} @click=${on.cancel}>${texts.cancel}</button>
      <progress id="collect-progress" max="1" aria-label=${texts.progress} .hidden=${share === null} .value=${share ?? 0}></progress>
      <button id="collect-files" type="button" @click=${() => byId('collect-file').click()}>${texts.files}</button>
      <button id="collect-folder" type="button" @click=${() => byId('collect-directory').click()}>${texts.folder}</button>
      <input id="collect-file" type="file" multiple hidden @change=${on.choose}>
      <input id="collect-directory" type="file" webkitdirectory hidden @change=${on.choose}>
      <span class="muted" .hidden=${files.length === 0}>${words.filesText(files.length)}</span>
      <button id="collect-empty" type="button" .hidden=${!isUsed(view)} @click=${on.empty}>${texts.empty}</button>
      <input id="collect-exercise" type="text" spellcheck="false" autocomplete="off" aria-label=${texts.exercise} placeholder=${texts.exercise}>
    </div>
    <p id="collect-status" class=${isBad ? 'field-error' : ''} role="status">${status} ${given ? html`<span class="muted">${words.judgedBy(given.id, given.run.exercise.task)}</span>` : nothing}</p>
    <div class="collect-found" .hidden=${!isThere}>
      <div class="collect-charts">
        <div id="collect-histogram" role="img" aria-label=${labels.histogram}></div>
        <div id="collect-gains" role="img" aria-label=${labels.gains}></div>
      </div>
      <ul class="collect-legend row muted">${legendOf(rows, given)}</ul>
      <div class="bar">
        <button id="collect-csv" type="button" class="primary" @click=${on.save}>${texts.csv}</button>
        ${rows.length > mostRows ? pager(rows.length, first, on.show) : nothing}
        <p id="collect-note" class="muted" role="status">${note}</p>
      </div>
      <div class="table-scroll" tabindex="0" role="group" aria-label=${texts.table}>${table}</div>
    </div>`;
}

/** @param {number} count @param {number} first @param {(first: number) => void} show */
function pager(count, first, show) {
  const last = Math.min(first + mostRows, count);
  return html`
    <button id="collect-before" type="button" aria-disabled=${String(first === 0)} @click=${unless(first === 0, () => show(first - mostRows))}>${texts.before}</button>
    <button id="collect-after" type="button" aria-disabled=${String(last === count)} @click=${unless(last === count, () => show(first + mostRows))}>${texts.after}</button>
    <span class="muted">${words.rowsText(first + 1, last, count)}</span>`;
}
