// Tables of texts.
import { create } from './elements.js';

/** @typedef {readonly string[]} Row It begins with its name. */
/**
 * @typedef {object} Table
 * @property {string} caption
 * @property {readonly string[]} columns
 * @property {readonly Row[]} rows
 * @property {readonly Row[]} [summary] Rows of their own before the others.
 * @property {(row: number) => string} [classOf]
 * @property {() => void} [save] As a file.
 */

/** @param {'col' | 'row'} scope @param {string} className @param {(Node | string)[]} content */
export function headCell(scope, className, ...content) {
  const cell = create('th', className, ...content);
  cell.setAttribute('scope', scope);
  return cell;
}

/** @param {readonly (Node | string)[]} names */
export const headRow = (names) =>
  create('thead', '', create('tr', '', ...names.map((name) => headCell('col', '', name))));

/** @param {Element} root @param {Table} table */
export function fillTable(root, { caption, columns, rows, summary, classOf }) {
  const bodyOf = (/** @type {readonly Row[]} */ some) =>
    create(
      'tbody',
      '',
      ...some.map(([name, ...texts], i) =>
        create(
          'tr',
          classOf?.(i) ?? '',
          headCell('row', '', name),
          ...texts.map((text) => create('td', '', text)),
        ),
      ),
    );
  root.replaceChildren(
    create('caption', '', caption),
    headRow(columns),
    ...[summary ?? [], rows].filter(({ length }) => length > 0).map(bodyOf),
  );
}

/** A map has too many cells to read. */
const mostOfMap = 13;

/** Evenly chosen rows or columns of a map, first and last among them. @param {number} count */
export function someOf(count) {
  const shown = Math.min(mostOfMap, count);
  return Array.from({ length: shown }, (_, i) => Math.round((i * (count - 1)) / (shown - 1)));
}
