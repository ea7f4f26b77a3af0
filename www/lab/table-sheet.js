// The sheet that shows what a picture shows, as a table.
/** @import { Table } from '../kit/table.js' */
import { html, render } from 'lit-html';
import { create } from '../kit/elements.js';
import { once } from '../kit/memo.js';
import { fillTable } from '../kit/table.js';
import { opening, tables as words } from '../words/index.js';

const dialog = once(() => {
  const made = /** @type {HTMLDialogElement} */ (create('dialog', 'sheet table-sheet'));
  made.id = 'table';
  made.setAttribute('aria-labelledby', 'table-rows');
  document.querySelector('main')?.append(made);
  return made;
});

/** @param {Table | null} table If there is one. */
export function showTable(table) {
  if (!table) return;
  const rows = create('table', '');
  rows.id = 'table-rows';
  fillTable(rows, table);
  render(
    html`<div class="bar">
        <button id="table-csv" type="button" class="primary" .hidden=${!table.save} @click=${() => table.save?.()}>${words.texts.tableCsv}</button>
        <button id="table-close" type="button" @click=${() => dialog().close()}>${opening.texts.close}</button>
      </div>
      <div class="table-scroll" tabindex="0" role="group" aria-label=${words.texts.tableButton}>${rows}</div>`,
    dialog(),
  );
  dialog().showModal();
}
