// The table of what remains: a row for each part of the error, with its plot and its numbers.
/** @import { PartName, Summary } from './summary.js' */
import { html, nothing } from 'lit-html';
import { formula } from '../../kit/templates.js';
import words from './words/index.js';
import { parts } from './summary.js';

const { texts } = words;

/** @param {Summary | null} summary Nothing is in sight until there is one. */
export const tableOf = (summary) => html`
  <ul id="remains-legend" class="remains-legend muted" data-picture="disturbance"
    data-name=${texts.disturbancePicture} aria-hidden="true">
    ${Object.entries(words.legend).map(([name, text]) => (name === 'set' && !hasSets(summary) ? nothing : html`<li class=${name}>${text}</li>`))}
  </ul>
  <table id="remains" class="remains${summary ? '' : ' unmeasured'}" data-picture="disturbance"
    aria-labelledby="disturbance-title remains-caption">
    <thead>
      <tr>
        <th id="remains-caption" class="remains-caption" scope="col" rowspan="2">${summary && words.captionText(summary.seconds)}</th>
        <th scope="col" rowspan="2">${texts.remainsDrive}</th>
        <th scope="col" rowspan="2">${texts.remainsSet}</th>
        <th id="remains-starts" scope="colgroup" colspan="3">${summary && words.startsText(summary.starts)}</th>
      </tr>
      <tr>
        <th scope="col">${texts.remainsMedian}</th>
        <th scope="col">${texts.remainsLargest}</th>
        <th scope="col" title=${texts.remainsInsideHint}>${texts.remainsInside}</th>
      </tr>
    </thead>
    <tbody id="remains-rows">${parts.map((part) => rowOf(part, summary))}</tbody>
  </table>
  <p id="remains-text" class="remains-text">${summary && words.summaryText(summary)}</p>`;

/** Until there is a summary nothing speaks against them. @param {Summary | null} summary */
const hasSets = (summary) => summary === null || words.isPromised(summary);

/** @param {PartName} part @param {Summary | null} summary */
function rowOf(part, summary) {
  const numbers = summary?.rows[part];
  const hasSet = hasSets(summary);
  /** With the same without the disturbance below. @param {'drive' | 'median' | 'largest'} name */
  const cellOf = (name) =>
    cell(numbers?.[name], summary?.disturbed ? words.sizeText(summary.calm[part][name]) : '');
  return html`
    <tr class=${part}>
      <th scope="row">
        <span class="remains-formula">${formula(words.formulas[part])}<span>${words.axisUnit(part)}</span></span>
        <div class="remains-plot layers" role="img" aria-label=${summary ? words.plotLabel(part, summary) : nothing}><canvas></canvas><canvas></canvas></div>
      </th>
      <td class=${hasSet && numbers && !numbers.isInside && numbers.set > 0 ? 'beyond' : ''}>${cellOf('drive')}</td>
      <td title=${words.equationHints[part]}>${hasSet ? cell(numbers?.set, words.equations[part]) : words.none}</td>
      <td>${cellOf('median')}</td>
      <td>${cellOf('largest')}</td>
      <td>${summary && (hasSet ? words.insideText(summary.rows[part].inside, summary.starts) : words.none)}</td>
    </tr>`;
}

/** @param {number | undefined} number @param {string} below */
const cell = (number, below) =>
  html`<span>${number === undefined ? '' : words.sizeText(number)}</span><small>${below}</small>`;
