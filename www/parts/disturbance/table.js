// The table of what remains: a row for each part of the error, with its plot and its numbers.
import { byId, create, formula } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { disturbance as words } from '../../words/index.js';
import { parts } from './summary.js';

/** @typedef {import('./summary.js').PartName} PartName */
/** @typedef {import('./summary.js').Summary} Summary */

/** Each number, and the same without the disturbance. */
const columns = /** @type {const} */ (['drive', 'median', 'largest']);

export function createTable() {
  const rows = parts.map((part) => createRow(part));
  byId('remains-rows').replaceChildren(...rows.map(({ row }) => row));
  byId('remains-legend').replaceChildren(
    ...Object.entries(words.legend).map(([name, text]) => {
      const item = document.createElement('li');
      Object.assign(item, { className: name, textContent: text });
      return item;
    }),
  );
  const changed = watch();
  return {
    /** Where the plots belong. */
    plots: rows.map(({ part, plot }) => ({ part, root: plot })),
    /** @param {Summary} summary */
    draw(summary) {
      if (!changed(summary)) return;
      byId('remains-caption').textContent = words.captionText(summary.seconds);
      byId('remains-starts').textContent = words.startsText(summary.starts);
      byId('remains-text').textContent = words.summaryText(summary);
      for (const row of rows) row.draw(summary);
    },
  };
}

/** @param {PartName} part */
function createRow(part) {
  const row = document.createElement('tr');
  const head = document.createElement('th');
  const plot = document.createElement('div');
  row.className = `part-${part}`;
  head.scope = 'row';
  plot.className = 'remains-plot';
  plot.setAttribute('role', 'img');
  const unit = create('span', '', words.axisUnit(part));
  head.append(create('span', 'remains-formula', ...formula(words.formulas[part]), unit), plot);
  const cells = columns.map(createCell);
  const set = createCell();
  set.cell.title = words.equationHints[part];
  const inside = document.createElement('td');
  const [drive, ...others] = cells.map(({ cell }) => cell);
  row.append(head, drive, set.cell, ...others, inside);
  return {
    part,
    row,
    plot,
    /** @param {Summary} summary */
    draw(summary) {
      const numbers = summary.rows[part];
      plot.setAttribute('aria-label', words.plotLabel(part, summary));
      for (const [i, name] of columns.entries())
        cells[i].draw(numbers[name], summary.disturbed ? words.sizeText(summary.calm[part][name]) : '');
      set.draw(numbers.set, words.equations[part]);
      drive.classList.toggle('beyond', !numbers.isInside);
      inside.textContent = words.insideText(numbers.inside, summary.starts);
    },
  };
}

function createCell() {
  const cell = document.createElement('td');
  const value = document.createElement('span');
  const small = document.createElement('small');
  cell.append(value, small);
  return {
    cell,
    /** @param {number} number @param {string} below */
    draw(number, below) {
      value.textContent = words.sizeText(number);
      small.textContent = below;
    },
  };
}
