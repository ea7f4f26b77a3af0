// The checked hand-ins as a table: sorted by a press, each with what is to be remarked, and as rows for the gradebook.
/** @import { Table } from '../../kit/table.js' */
/** @import { Row } from './check.js' */
/** @import { Column } from './words/common.js' */
import { html } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import Papa from 'papaparse';
import { seenText } from '../../kit/text.js';
import { numberText as digits } from '../../link/values.js';
import { mostOfStudent } from './entries.js';
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
/** Rows at once: more would take long to lay out. */
export const mostRows = 100;

/** So many of one answer, or of one student, are named. */
const mostTwins = 3;

/** By these nothing is sorted. @type {readonly Column[]} */
const unsorted = ['pin', 'who', 'open'];

/** @param {Row} row */
export const nameOf = ({ entry, checked }) => entry.name || checked?.who || '';

/** What a lecturer has to look at. @param {Row} row @param {readonly Row[]} rows In the order in which they came. */
export function remarksOf(row, rows) {
  const { entry, checked, problem, same, ones } = row;
  if (!checked) return [words.problemText(entry.text, problem, mostOfStudent)];
  const { worth, told, lacksWho, lacksDrives, differs, cost, own } = checked;
  const othersOf = (/** @type {readonly number[]} */ all) =>
    all
      .slice(0, mostTwins + 1)
      .filter((i) => rows[i] !== row)
      .slice(0, mostTwins);
  const also = othersOf(ones).map((i) => i + 1);
  const twins = othersOf(same).map((i) => ({ number: i + 1, name: nameOf(rows[i]) }));
  return [
    ...(worth === 'holds'
      ? []
      : [worth === 'otherResult' ? words.otherResult(told ?? Number.NaN) : words.worths[worth]]),
    ...(lacksWho ? [words.lacksWho] : []),
    ...(seenText(checked.who) === checked.who ? [] : [words.unseen]),
    ...(lacksDrives ? [words.lacksDrives] : []),
    ...(differs.length > 0 ? [words.differs(differs)] : []),
    ...(own === cost ? [] : [words.ownCost(words.numberText(own))]),
    ...(also.length > 0 ? [words.also(also, ones.length - 1 - also.length)] : []),
    ...(twins.length > 0 ? [words.same(twins, same.length - 1 - twins.length)] : []),
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

/** @typedef {{ sort: (column: Column) => void, open: (row: number) => void, pin: (row: number) => void }} Events */

/** @param {readonly Row[]} rows @param {Order} order @param {(row: Row) => boolean} isPinned @param {Events} on @returns {Table} */
export function tableOf(rows, order, isPinned, on) {
  const indices = ordered(rows, order);
  return {
    caption: words.texts.table,
    columns: columns.map((column) => headOf(column, order, on.sort)),
    count: rows.length,
    keyOf: (row) => indices[row],
    classOf: (row) => (rows[indices[row]].checked ? '' : 'unread'),
    sortingOf: (column) =>
      columns[column] === order.column ? (order.isDown ? 'descending' : 'ascending') : null,
    rowOf: (row) => cellsOf(indices[row], rows, isPinned, on),
  };
}

/** @param {Column} column @param {Order} order @param {(column: Column) => void} sort */
function headOf(column, order, sort) {
  const text = words.columns[column];
  if (unsorted.includes(column)) return text;
  const mark = column === order.column ? (order.isDown ? ' ↓' : ' ↑') : '';
  return html`<button type="button" class="link" data-sort=${column} title=${words.sortBy(text)}
    @click=${() => sort(column)}>${text}<span aria-hidden="true">${mark}</span></button>`;
}

/** @param {import('./check.js').Checked} checked */
function metText({ judged, worth }) {
  if (worth === 'broken') return words.cut;
  return judged ? (judged.isMet ? words.met : words.notMet) : '';
}

/** And how much of what is asked for, where J does not say it. @param {import('./check.js').Checked} checked */
export const judgedText = (checked) => [metText(checked), checked.reached].filter(Boolean).join(', ');

/** @param {number} index @param {readonly Row[]} rows @param {(row: Row) => boolean} isPinned @param {Events} on */
function cellsOf(index, rows, isPinned, { open, pin }) {
  const row = rows[index];
  const { checked } = row;
  const name = nameOf(row);
  const number = words.rowNumber(index);
  const remarks = html`<span class="collect-remarks">${remarksOf(row, rows).join('; ')}</span>`;
  if (!checked) return [number, '', name, '', '', '', '', '', remarks, ''];
  const { judged, who, cost, drives, isTold } = checked;
  return [
    number,
    html`<input type="checkbox" aria-label=${words.pinLabel(name)} .checked=${live(isPinned(row))} @change=${() => pin(index)}>`,
    name,
    who && who !== name ? who : '',
    words.numberText(cost),
    judgedText(checked),
    judged?.points == null ? '' : String(judged.points),
    drives === null ? '' : words.drivesText(drives, isTold),
    remarks,
    html`<button type="button" class="link" data-open=${index} aria-label=${words.openLabel(name)} @click=${() => open(index)}>${words.texts.open}</button>`,
  ];
}

/** By which exercise they were judged, half a year later too. @param {import('./check.js').Given | null} given */
export const csvName = (given) => `hand-ins${given ? `-${given.id}` : ''}.csv`;

/** The sign by which a spreadsheet knows a formula, where a cell begins: also for programs that divide at semicolons, tabs or line ends, whatever is in quotes. */
const sign = /[-=+@＝＋－＠](?<=(?:^|[;\t\r\n])[\s"]*.)/g;
const negative = /^-\d+(?:\.\d+)?(?:e[+-]?\d+)?$/;

/** @param {string} text */
const withoutFormula = (text) => (negative.test(text) ? text : text.replace(sign, "'$&"));

/** What a row has in a column of the file, if it has anything. @typedef {readonly [head: string, cellOf: (row: Row) => string | number | null | undefined]} CsvColumn */

/** For the gradebook: after the name stand the columns by which the learning platform knows its students. No cell is a formula. @param {readonly Row[]} rows @param {string} page The address of this page. */
export function csvOf(rows, page) {
  const names = [...new Set(rows.flatMap(({ entry }) => Object.keys(entry.ident)))];
  /** @type {readonly CsvColumn[]} */
  const idents = names.map((name) => [
    name,
    ({ entry }) => (Object.hasOwn(entry.ident, name) ? entry.ident[name] : ''),
  ]);
  /** @type {readonly CsvColumn[]} */
  const gains = ['kx', 'ky', 'ktheta'].map((name, i) => [
    name,
    ({ checked }) => checked && digits(checked.gains[i]),
  ]);
  const { points, aim, drives, minutes, how, answers, remarks, link, reached } = words.csvHead;
  // Where J says it all, the table is as it always was.
  const hasReached = rows.some(({ checked }) => checked?.reached);
  /** @type {CsvColumn} */
  const reachedColumn = [reached, ({ checked }) => checked?.reached];
  /** @type {readonly CsvColumn[]} */
  const columns = [
    [words.columns.name, nameOf],
    ...idents,
    [points, ({ checked }) => checked?.judged && (checked.judged.points ?? Number(checked.judged.isMet))],
    [aim, ({ checked }) => checked && metText(checked)],
    ['J', ({ checked }) => checked && digits(checked.cost)],
    [drives, ({ checked }) => checked?.drives],
    [minutes, ({ checked }) => checked?.minutes],
    ...gains,
    [how, ({ checked }) => checked?.how],
    [answers, ({ checked }) => checked?.answers],
    [remarks, (row) => remarksOf(row, rows).join('; ')],
    [words.columns.who, ({ checked }) => checked?.who],
    // A link says the same with %3B.
    [link, ({ entry, checked }) => checked && entry.link && `${page}#${entry.link.replaceAll(';', '%3B')}`],
    ...(hasReached ? [reachedColumn] : []),
  ];
  const fields = columns.map(([head]) => withoutFormula(head));
  const data = rows.map((row) => columns.map(([, cellOf]) => withoutFormula(String(cellOf(row) ?? ''))));
  // Some programs divide at these too.
  const quotes = (/** @type {unknown} */ cell) => /[;\t]/.test(String(cell));
  // Spreadsheets know by the mark that it is UTF-8.
  return `\ufeff${Papa.unparse({ fields, data }, { quotes })}\r\n`;
}
