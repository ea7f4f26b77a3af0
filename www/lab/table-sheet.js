// The sheet that shows what a picture shows, as a table.
/** @import { Table } from '../kit/table.js' */
import { html, nothing } from 'lit-html';
import { create } from '../kit/elements.js';
import { once } from '../kit/memo.js';
import { createSheet } from '../kit/sheet.js';
import { fillTable } from '../kit/table.js';
import { unless } from '../kit/templates.js';
import { opening, tables as words } from '../words/index.js';

const { texts } = words;

/** More at once would take long to lay out: the rows of a generation are long. */
const mostRows = 50;

const sheet = once(() => createSheet('table', 'table-sheet', '', opening.texts.close));

/** @param {Table | null} table If there is one. */
export function showTable(table) {
  if (!table) return;
  const rows = /** @type {HTMLTableElement} */ (create('table', { id: 'table-rows' }));
  draw(table, rows, 0);
  sheet().open();
}

/** What opens it, once there is something to show. @template T @param {string} id @param {T | null} shown @param {(shown: T) => Table} tableOf */
export const tableButton = (id, shown, tableOf) =>
  html`<button id="${id}-table" type="button" class="link" aria-disabled=${String(shown === null)}
    @click=${() => shown !== null && showTable(tableOf(shown))}>${texts.tableButton}</button>`;

/** @param {Table} table @param {HTMLTableElement} rows @param {number} first The row that is shown first. */
function draw(table, rows, first) {
  fillTable(rows, table, first, mostRows);
  // What it is called heads the sheet.
  rows.caption?.classList.add('visually-hidden');
  sheet().draw(
    html`<div class="table-scroll" tabindex="0" role="group" aria-label=${texts.tableButton}>${rows}</div>
      ${
        table.save || table.count > mostRows
          ? html`<div class="bar">
              <button id="table-csv" type="button" class="primary" .hidden=${!table.save} @click=${() => table.save?.()}>${texts.tableCsv}</button>
              ${table.count > mostRows ? pager(table, rows, first) : nothing}
            </div>`
          : nothing
      }`,
    table.caption,
  );
}

/** The way to the other rows. @param {Table} table @param {HTMLTableElement} rows @param {number} first */
function pager(table, rows, first) {
  const last = Math.min(first + mostRows, table.count);
  const show = (/** @type {number} */ next) => () => {
    draw(table, rows, next);
    rows.parentElement?.scrollTo(0, 0);
  };
  return html`
    <button id="table-before" type="button" aria-disabled=${String(first === 0)} @click=${unless(first === 0, show(first - mostRows))}>${texts.tableBefore}</button>
    <button id="table-after" type="button" aria-disabled=${String(last === table.count)} @click=${unless(last === table.count, show(first + mostRows))}>${texts.tableAfter}</button>
    <p class="muted" role="status">${words.rowsText(first + 1, last, table.count)}</p>`;
}
