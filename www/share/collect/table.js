// The checked hand-ins as a table: sorted by a press, each with what is to be remarked, and as rows for the gradebook.
/** @import { Table } from '../../kit/table.js' */
/** @import { Row } from './check.js' */
/** @import { Column } from './words/common.js' */
import Papa from 'papaparse';
import { create } from '../../kit/elements.js';
import { numberText as digits } from '../../link/values.js';
import words from './words/index.js';

/** @typedef {{ column: Column, isDown: boolean }} Order */

const columns = /** @type {const} */ ([
  'number',
  'pin',
  'name',
  'who',
  'cost',
  'met',
  'points',
  'drives',
  'remark',
  'open',
]);
/** By these nothing is sorted. @type {readonly Column[]} */
const unsorted = ['pin', 'who', 'open'];

/** @param {Row} row */
export const nameOf = ({ entry, checked }) => entry.name || checked?.who || '';

/** What a lecturer has to look at. @param {Row} row @param {readonly Row[]} rows In the order in which they came. */
export function remarksOf({ entry, checked, problem, same }, rows) {
  if (!checked) return [words.problemText(entry.text, problem)];
  const { worth, told, lacksDrives, differs, cost, own } = checked;
  return [
    ...(worth === 'holds'
      ? []
      : [worth === 'otherResult' ? words.otherResult(told ?? Number.NaN) : words.worths[worth]]),
    ...(lacksDrives ? [words.lacksDrives] : []),
    ...(differs.length > 0 ? [words.differs(differs)] : []),
    ...(own === cost || Number.isNaN(own) ? [] : [words.ownCost(words.numberText(own))]),
    ...(same.length > 0
      ? [
          words.same(
            same.map((i) => i + 1),
            same.map((i) => nameOf(rows[i])),
          ),
        ]
      : []),
  ];
}

/** By what a column sorts. @param {Column} column @param {Row} row @param {number} index @param {readonly Row[]} rows @returns {number | string} */
function keyOf(column, row, index, rows) {
  const { checked } = row;
  const last = Number.POSITIVE_INFINITY;
  if (column === 'name') return nameOf(row).toLowerCase() || '\uffff';
  if (column === 'cost') return checked?.cost ?? last;
  if (column === 'met') return checked ? Number(checked.judged?.isMet ?? -0.5) : -1;
  if (column === 'points') return checked?.judged?.points ?? -1;
  if (column === 'drives') return checked?.drives ?? last;
  if (column === 'remark') return -remarksOf(row, rows).length - (checked ? 0 : 10);
  return index;
}

/** The numbers of the rows, in order. @param {readonly Row[]} rows @param {Order} order */
export function ordered(rows, { column, isDown }) {
  const keys = rows.map((row, i) => keyOf(column, row, i, rows));
  const sign = isDown ? -1 : 1;
  return rows
    .map((_, i) => i)
    .sort((a, b) => sign * (keys[a] < keys[b] ? -1 : keys[a] > keys[b] ? 1 : 0) || a - b);
}

/**
 * @param {readonly Row[]} rows @param {Order} order @param {ReadonlySet<number>} pinned
 * @param {{ sort: (column: Column) => void, open: (row: number) => void, pin: (row: number, isPinned: boolean) => void }} on
 * @returns {Table}
 */
export function tableOf(rows, order, pinned, on) {
  const indices = ordered(rows, order);
  return {
    caption: words.texts.table,
    columns: columns.map((column) => headOf(column, order, on.sort)),
    count: rows.length,
    classOf: (row) => (rows[indices[row]].checked ? '' : 'unread'),
    rowOf(row) {
      const index = indices[row];
      return cellsOf(rows[index], index, rows, pinned.has(index), on);
    },
  };
}

/** @param {Column} column @param {Order} order @param {(column: Column) => void} sort */
function headOf(column, order, sort) {
  const text = words.columns[column];
  if (unsorted.includes(column)) return text;
  const mark = column === order.column ? (order.isDown ? ' ↓' : ' ↑') : '';
  const button = create('button', 'link', `${text}${mark}`);
  button.setAttribute('type', 'button');
  button.setAttribute('aria-label', words.sortBy(text));
  button.dataset.sort = column;
  button.addEventListener('click', () => sort(column));
  return button;
}

/** @param {import('./check.js').Checked} checked */
function metText({ judged, worth }) {
  if (worth === 'broken') return words.cut;
  return judged ? (judged.isMet ? words.met : words.notMet) : '';
}

/** @param {Row} row @param {number} index @param {readonly Row[]} rows @param {boolean} isPinned @param {{ open: (row: number) => void, pin: (row: number, isPinned: boolean) => void }} on */
function cellsOf(row, index, rows, isPinned, { open, pin }) {
  const { checked } = row;
  const remarks = create('span', 'collect-remarks', remarksOf(row, rows).join('; '));
  const number = words.rowNumber(index);
  if (!checked) return [number, '', nameOf(row), '', '', '', '', '', remarks, ''];
  const { judged, who, cost, drives, isTold } = checked;
  const box = /** @type {HTMLInputElement} */ (create('input', ''));
  Object.assign(box, { type: 'checkbox', checked: isPinned, ariaLabel: words.pinLabel(nameOf(row)) });
  box.addEventListener('change', () => pin(index, box.checked));
  const button = create('button', 'link', words.texts.open);
  button.setAttribute('type', 'button');
  button.setAttribute('aria-label', words.openLabel(nameOf(row)));
  button.addEventListener('click', () => open(index));
  return [
    number,
    box,
    nameOf(row),
    who && who !== nameOf(row) ? who : '',
    words.numberText(cost),
    metText(checked),
    judged?.points == null ? '' : String(judged.points),
    drives === null ? '' : words.drivesText(drives, isTold),
    remarks,
    button,
  ];
}

export const csvName = 'hand-ins.csv';

/** What a spreadsheet takes for a formula; a number below zero is none. */
const formula = /^[=+@\t\r]|^-(?!\d+(?:\.\d+)?(?:e[+-]?\d+)?$)/;

/** For the gradebook: the columns by which the learning platform knows its students stand first. No cell is a formula. @param {readonly Row[]} rows @param {string} page The address of this page. */
export function csvOf(rows, page) {
  const idents = [...new Set(rows.flatMap(({ entry }) => Object.keys(entry.ident)))];
  const lines = rows.map((row) => {
    const { checked, entry } = row;
    const { judged } = checked ?? {};
    return [
      nameOf(row),
      ...idents.map((column) => entry.ident[column] ?? ''),
      judged?.points ?? (judged ? Number(judged.isMet) : ''),
      checked ? metText(checked) : '',
      checked ? digits(checked.cost) : '',
      checked?.drives ?? '',
      checked?.minutes ?? '',
      ...(checked ? checked.gains.map(digits) : ['', '', '']),
      checked?.how ?? '',
      checked?.answers ?? '',
      remarksOf(row, rows).join('; '),
      checked?.who ?? '',
      entry.link && checked ? `${page}#${entry.link}` : '',
    ];
  });
  const { points, aim, drives, minutes, how, answers, remarks, link } = words.csvHead;
  const numbers = ['J', drives, minutes, 'kx', 'ky', 'ktheta'];
  const fields = [
    words.columns.name,
    ...idents,
    points,
    aim,
    ...numbers,
    how,
    answers,
    remarks,
    words.columns.who,
    link,
  ];
  // Spreadsheets know by the mark that it is UTF-8.
  return `\ufeff${Papa.unparse({ fields, data: lines }, { escapeFormulae: formula })}\r\n`;
}
