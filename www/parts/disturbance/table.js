// What remains as a table: in sight a row for each part of the error, with its plot and its numbers, and in a sheet all that was measured.
/** @import { Table } from '../../kit/table.js' */
/** @import { PartName, Sizes, Summary } from './summary.js' */
import { html, nothing } from 'lit-html';
import { formula } from '../../kit/templates.js';
import words from './words/index.js';
import { parts } from './summary.js';

const { texts } = words;

/** @param {Summary | null} summary Nothing is in sight until there is one. @param {boolean} isVain None comes: its place is not kept. */
export const tableOf = (summary, isVain) => html`
  <ul id="remains-legend" class="remains-legend lines row muted not-in-small-figure" data-picture="disturbance"
    data-name=${texts.disturbancePicture} aria-hidden="true" ?hidden=${isVain}>
    ${Object.entries(words.legend).map(([name, text]) => (name === 'set' && !hasSets(summary) ? nothing : html`<li class=${name}>${text}</li>`))}
  </ul>
  <table id="remains" class="remains${summary ? '' : ' unmeasured'}" data-picture="disturbance"
    aria-labelledby="disturbance-title remains-caption" ?hidden=${isVain}>
    <thead>
      <tr>
        <th id="remains-caption" class="remains-caption" scope="col">${summary && words.captionText(summary)}</th>
        <th scope="col">${texts.remainsDrive}</th>
        <th scope="col">${texts.remainsSet}</th>
        <th scope="col" title=${texts.remainsInsideHint}>${texts.remainsInside}</th>
      </tr>
    </thead>
    <tbody id="remains-rows">${parts.map((part) => rowOf(part, summary))}</tbody>
  </table>
  <p id="remains-text" class="remains-text not-in-figure" ?hidden=${isVain}>${summary && words.summaryText(summary)}</p>`;

/** Until there is a summary nothing speaks against them. @param {Summary | null} summary */
const hasSets = (summary) => summary === null || words.isPromised(summary);

/** @param {PartName} part @param {Summary | null} summary */
function rowOf(part, summary) {
  const numbers = summary?.rows[part];
  const hasSet = hasSets(summary);
  return html`
    <tr class=${part}>
      <th scope="row">
        <span class="remains-formula" translate="no">${formula(words.formulas[part])}<span>${words.axisUnit(part)}</span></span>
        <div class="remains-plot layers" role="img" aria-label=${summary ? words.plotLabel(part, summary) : nothing}><canvas></canvas><canvas></canvas></div>
      </th>
      <td class=${(hasSet && numbers?.place) || ''}>${cell(numbers?.drive, summary?.disturbed ? words.sizeText(summary.calm[part].drive) : '')}</td>
      <td title=${words.equationHints[part]}>${hasSet ? cell(numbers?.set, words.equations[part]) : words.none}</td>
      <td>${summary && othersOf(summary, part)}</td>
    </tr>`;
}

/** @param {number | undefined} number @param {string} below */
const cell = (number, below) =>
  html`<span>${number === undefined ? '' : words.sizeText(number)}</span><small>${below}</small>`;

/** How many others lie there beside their sets. @param {Summary} summary @param {PartName} part @param {'inside' | 'edge'} place */
const countOf = (summary, part, place) =>
  words.isPromised(summary) && summary.pushed.includes(part)
    ? words.shareText(summary.rows[part][place], summary.starts)
    : words.none;

/** How many others stay inside, and beneath how many are on the edge. @param {Summary} summary @param {PartName} part */
const othersOf = (summary, part) => {
  const { place, edge } = summary.rows[part];
  const isOnEdge = words.isPromised(summary) && place !== null && edge > 0;
  return html`<span>${countOf(summary, part, 'inside')}</span><small>${isOnEdge ? `${words.edgeMark} ${edge}` : ''}</small>`;
};

/** All numbers, each part of the error also undisturbed. @param {Summary} summary @returns {Table} */
export function remainsTable(summary) {
  const sizes = (/** @type {Sizes} */ { drive, median, largest }) =>
    [drive, median, largest].map(words.sizeText);
  const rows = parts.flatMap((part) => {
    const disturbed = [
      words.measureText(part),
      ...sizes(summary.rows[part]),
      words.isPromised(summary) ? words.sizeText(summary.rows[part].set) : words.none,
      countOf(summary, part, 'inside'),
      countOf(summary, part, 'edge'),
    ];
    const calm = [words.calmText(part), ...sizes(summary.calm[part]), '', '', ''];
    return summary.disturbed ? [disturbed, calm] : [disturbed];
  });
  return {
    caption: words.tableCaption(summary.seconds),
    columns: [
      texts.remainsPart,
      texts.remainsDrive,
      ...words.othersColumns(summary.starts),
      texts.remainsSet,
      texts.remainsInside,
      texts.remainsEdge,
    ],
    count: rows.length,
    rowOf: (i) => rows[i],
  };
}
