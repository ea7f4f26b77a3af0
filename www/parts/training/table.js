// The table: one row for each set of gains, with how they fare.
/** @import { Result, RowName } from './request.js' */
/** @import { Spread } from './spread.js' */
import { html, nothing } from 'lit-html';
import { stacked } from '../../kit/stack.js';
import { styled } from '../../kit/templates.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { isSet } from './sets.js';

/** What a row shows; `result` is null before there is one. @typedef {{ name: RowName, text: string, result: Result | null, old: boolean }} Row */

/** @param {readonly Row[]} rows @param {Spread | null} spread @param {RowName} chosen @param {{ unseen: number, own: number, follows: boolean }} counts How many starts are never seen, and how many are the experiment's own; whether nobody arrives, because the reference moves. @param {(name: RowName) => void} onChoose */
export function tableOf(rows, spread, chosen, counts, onChoose) {
  const heads = words.columnsOf(counts.unseen, counts.own);
  const isLong = rows.some(
    ({ result }) => result && [result.unseen.cost, result.own].some((cost) => words.cost(cost).length > 5),
  );
  return html`
    <table id="training-table" class="training-table ruled not-in-small-figure ${isLong ? 'long' : ''}" aria-label=${words.texts.trainingTable}>
      <thead><tr>${heads.map((text, i) => html`<th scope="col">${text}${i === 0 ? gainsOf((name) => name) : nothing}</th>`)}</tr></thead>
      <tbody>${rows.map((row) => rowOf(row, spread, counts, row.name === chosen, onChoose))}</tbody>
    </table>`;
}

/** Something of each gain, in its colour. @param {(name: string, i: number) => string} write */
const gainsOf = (write) =>
  html`<span class="training-gains">${lab.gains.map(
    ({ id, name }, i) => html`<span class=${id} title=${name}>${write(name, i)}</span>`,
  )}</span>`;

/** @param {Row} row @param {Spread | null} spread @param {{ unseen: number, follows: boolean }} counts @param {boolean} chosen @param {(name: RowName) => void} onChoose */
function rowOf({ name, text, result, old }, spread, { unseen: all, follows }, chosen, onChoose) {
  /** @param {(result: Result) => string} write */
  const shown = (write) => (result ? write(result) : words.none);
  const share = (/** @type {Result['unseen']} */ { count, starts }) =>
    follows ? words.none : words.percent(count, starts.length);
  const filled = result && !follows ? (100 * result.unseen.count) / result.unseen.starts.length : 0;
  // The button is for the keyboard; the whole row is as good for the pointer.
  return html`
    <tr id="training-${name}" class="${chosen ? 'chosen' : ''} ${old ? 'old' : ''}" @click=${() => onChoose(name)}>
      <th scope="row">
        <button type="button" class="training-name" title=${words.chooseHint(text)} aria-pressed=${String(chosen)}>${text}</button>${gainsOf((_, i) => shown(({ gains }) => words.gain(gains[i])))}
      </th>
      <td class="training-seen">${isSet(name) ? shown(({ training }) => share(training)) : words.none}</td>
      <td class="training-unseen"><span class="training-bar"><span ${styled('width', `${filled}%`)}></span>${isSet(name) && spread && !follows ? dotsOf(spread[name], all) : nothing}</span><strong>${shown(
        ({ unseen }) => share(unseen),
      )}</strong></td>
      <td class="training-cost">${shown(({ unseen }) => words.cost(unseen.cost))}</td>
      <td class="training-own">${shown(({ own }) => words.cost(own))}</td>
    </tr>`;
}

/** The bar has room for so many dots beside and above each other; the styles know both. */
const [across, lines] = [15, 7];

/** A dot for each seed, about where its bar would end. @param {readonly number[]} counts @param {number} unseen */
function dotsOf(counts, unseen) {
  const columns = counts.map((count) => Math.min(across - 1, Math.floor((across * count) / unseen)));
  return stacked(columns, lines, 2, [0, across - 1]).map(
    ({ column, level }) =>
      html`<i class="training-dot" ${styled('left', `${(100 * column) / across}%`)} ${styled('bottom', `${(100 * level) / lines}%`)}></i>`,
  );
}
