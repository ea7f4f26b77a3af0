// Tables of texts, and of what is pressed or ticked.
import { html, nothing, render } from 'lit-html';
import { repeat } from 'lit-html/directives/repeat.js';

/** @typedef {Node | string | import('lit-html').TemplateResult} Cell */
/** @typedef {readonly Cell[]} Row It begins with its name. */
/**
 * @typedef {object} Table
 * @property {string} caption
 * @property {readonly Cell[]} columns
 * @property {number} count How many rows there are.
 * @property {(row: number) => Row} rowOf
 * @property {readonly Row[]} [summary] Rows of their own before the others.
 * @property {(row: number) => string} [classOf]
 * @property {(row: number) => unknown} [keyOf] What stays the same row, wherever it stands.
 * @property {(column: number) => 'ascending' | 'descending' | null} [sortingOf]
 * @property {() => void} [save] As a file.
 */

/** @param {Row} row @param {string} [className] */
const rowOfCells = ([name, ...cells], className = '') =>
  html`<tr class=${className || nothing}><th scope="row">${name}</th>${cells.map((cell) => html`<td>${cell}</td>`)}</tr>`;

/** Some of the rows. What is there already stays, and so does the focus in it. @param {HTMLElement} root @param {Table} table @param {number} first @param {number} most Rows at once. */
export function fillTable(root, table, first, most) {
  const { caption, columns, count, rowOf, summary = [], classOf, keyOf, sortingOf } = table;
  const shown = Array.from({ length: Math.min(most, count - first) }, (_, i) => first + i);
  const head = columns.map(
    (name, i) => html`<th scope="col" aria-sort=${sortingOf?.(i) ?? nothing}>${name}</th>`,
  );
  const rows = repeat(
    shown,
    (row) => keyOf?.(row) ?? row,
    (row) => rowOfCells(rowOf(row), classOf?.(row)),
  );
  render(
    html`<caption>${caption}</caption>
      <thead><tr>${head}</tr></thead>
      ${summary.length > 0 ? html`<tbody>${summary.map((row) => rowOfCells(row))}</tbody>` : nothing}
      ${count > 0 ? html`<tbody>${rows}</tbody>` : nothing}`,
    root,
  );
}

/** A map has too many cells to read. */
const mostOfMap = 13;

/** Evenly chosen rows or columns of a map, first and last among them. @param {number} count */
export function someOf(count) {
  const shown = Math.min(mostOfMap, count);
  return Array.from({ length: shown }, (_, i) => Math.round((i * (count - 1)) / (shown - 1)));
}
