// The run in numbers, for who wants to read or to hear them; the row of the robots' clock is marked.
/** @import { Run } from '../../core/engine.js' */
/** @import { View } from './page.js' */
import { html, nothing, render } from 'lit-html';
import { paidUntil } from '../../core/paid.js';
import { remember, watch } from '../../kit/memo.js';
import { sampleBefore } from '../../lab/track.js';
import words from './words/index.js';

/** More rows than this nobody reads. */
const mostRows = 60;

/** @param {HTMLElement} root @returns {View} */
export function createNumbers(root) {
  const textsOf = remember(numbersOf);
  const changed = watch();
  return {
    draw(_, { driving }, { name, time }) {
      const numbers = textsOf(driving);
      const now = sampleBefore(driving, time);
      const marked = numbers.rows.findLast(({ sample }) => sample <= now);
      if (changed(name, numbers, marked)) render(tableOf(name, numbers, marked), root);
    },
  };
}

/** @typedef {ReturnType<typeof numbersOf>} Numbers */

/** @param {Run} run */
function numbersOf(run) {
  const { every, samples } = readableSamples(run.time.length);
  const step = every * (run.time[1] ?? 0);
  return {
    step,
    rows: samples.map((sample) => ({
      sample,
      texts: words.numberColumns.map(({ text }) => text(run, sample, paidUntil(run, sample), step)),
    })),
  };
}

/** @param {string} name @param {Numbers} numbers @param {Numbers['rows'][number] | undefined} marked */
const tableOf = (name, { step, rows }, marked) => html`
  <table id="numbers-table" class="curves-table ruled numbers">
    <caption>${words.numbersCaption(name, step)}</caption>
    <thead><tr>${words.numberColumns.map(({ head }) => html`<th scope="col">${head}</th>`)}</tr></thead>
    <tbody>${rows.map(
      (row) =>
        html`<tr aria-current=${row === marked ? 'true' : nothing}>${row.texts.map((text) => html`<td>${text}</td>`)}</tr>`,
    )}</tbody>
  </table>`;

/** Of so many samples some that can be read, 1, 2 or 5 times a power of ten apart, and the last. @param {number} count */
export function readableSamples(count) {
  const every = stepOf(count);
  const samples = Array.from({ length: Math.ceil(count / every) }, (_, i) => i * every);
  return { every, samples: samples[samples.length - 1] === count - 1 ? samples : [...samples, count - 1] };
}

/** @param {number} samples */
function stepOf(samples) {
  for (let power = 1; ; power *= 10)
    for (const factor of [1, 2, 5]) if (samples / (factor * power) <= mostRows) return factor * power;
}
