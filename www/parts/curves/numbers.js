// The run in numbers, for who wants to read or to hear them; the row of the robots' clock is marked.
import { sampleBefore } from '../../lab/track.js';
import { create } from '../../kit/elements.js';
import { headRow } from '../../kit/table.js';
import { watch } from '../../kit/memo.js';
import { curves as words } from '../../words/index.js';
import { paidUntil } from '../../core/paid.js';

/** @typedef {import('../../core/engine.js').Run} Run */

/** More rows than this nobody reads. */
const mostRows = 60;

/** @param {HTMLTableElement} table */
export function createNumbers(table) {
  const changed = watch();
  /** @type {{ sample: number, row: HTMLTableRowElement }[]} */
  let rows = [];
  /** @type {HTMLTableRowElement | undefined} */
  let marked;
  return {
    /** @param {{ name: string, run: Run, time: number }} model */
    draw({ name, run, time }) {
      if (changed(name, run)) {
        const { every, samples } = readableSamples(run.time.length);
        const body = document.createElement('tbody');
        rows = samples.map((sample) => ({ sample, row: rowOf(body, run, sample) }));
        const caption = create('caption', '', words.numbersCaption(name, every * (run.time[1] ?? 0)));
        table.replaceChildren(caption, headRow(words.numberColumns.map(({ head }) => head)), body);
        marked = undefined;
      }
      const now = sampleBefore(run, time);
      const row = rows.findLast(({ sample }) => sample <= now)?.row;
      if (row === marked) return;
      marked?.removeAttribute('aria-current');
      row?.setAttribute('aria-current', 'true');
      marked = row;
    },
  };
}

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

/** @param {HTMLTableSectionElement} body @param {Run} run @param {number} sample */
function rowOf(body, run, sample) {
  const row = body.insertRow();
  for (const { text } of words.numberColumns)
    row.insertCell().textContent = text(run, sample, paidUntil(run, sample));
  return row;
}
