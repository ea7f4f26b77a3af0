// Tables of texts, and of elements where something is pressed.
import { create } from './elements.js';

/** @typedef {readonly (Node | string)[]} Row It begins with its name. */
/**
 * @typedef {object} Table
 * @property {string} caption
 * @property {readonly (Node | string)[]} columns
 * @property {number} count How many rows there are.
 * @property {(row: number) => Row} rowOf
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
const headRow = (names) =>
  create('thead', '', create('tr', '', ...names.map((name) => headCell('col', '', name))));

/** More rows than these at once would take long to lay out. */
export const mostRows = 100;

/** Some of the rows. @param {Element} root @param {Table} table @param {number} [first] */
export function fillTable(root, { caption, columns, count, rowOf, summary = [], classOf }, first = 0) {
  /** @param {readonly Row[]} rows @param {(row: number) => string} [nameOf] */
  const bodyOf = (rows, nameOf) =>
    create(
      'tbody',
      '',
      ...rows.map(([name, ...texts], i) =>
        create(
          'tr',
          nameOf?.(first + i) ?? '',
          headCell('row', '', name),
          ...texts.map((text) => create('td', '', text)),
        ),
      ),
    );
  const shown = Array.from({ length: Math.min(mostRows, count - first) }, (_, i) => rowOf(first + i));
  root.replaceChildren(
    create('caption', '', caption),
    headRow(columns),
    ...(summary.length > 0 ? [bodyOf(summary)] : []),
    ...(count > 0 ? [bodyOf(shown, classOf)] : []),
  );
}

/** A map has too many cells to read. */
const mostOfMap = 13;

/** Evenly chosen rows or columns of a map, first and last among them. @param {number} count */
export function someOf(count) {
  const shown = Math.min(mostOfMap, count);
  return Array.from({ length: shown }, (_, i) => Math.round((i * (count - 1)) / (shown - 1)));
}
