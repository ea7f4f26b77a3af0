// Disturbance as a person reads it, and what the core says that should stand there.
import assert from 'node:assert/strict';
import { median as middle } from 'd3-array';
import { experiment, paperGains, remainingErrors, startsOnCircle } from '../harness/core.js';
import { readTable } from '../harness/reading.js';
import { sizeText as shown } from '../../../www/parts/disturbance/words/common.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../harness/core.js').Gains} Gains */
/** @typedef {Partial<Experiment['disturbance']>} Disturbance */
/** @typedef {'x' | 'y' | 'theta'} Part */

export const preset = experiment('velocity-limits');
export const arbitrary = paperGains('velocity-limits', 'arbitrary');
const parts = /** @type {const} */ (['x', 'y', 'theta']);
const circle = { radius: Math.hypot(2, 2), count: 32, seed: 1 };

/** What the core gives: in sight for each part this drive, its set and who of the others stays inside; in the table all of it. @param {Gains} gains @param {Disturbance} disturbance */
export function expected(gains, disturbance) {
  const { x, y } = preset.goal;
  const starts = [preset.starts[0], ...startsOnCircle({ ...circle, x, y })];
  const tolerance = { position: 0, heading: 0 };
  const measured = experiment({ ...preset, starts, tolerance, disturbance });
  const { error, sets } = remainingErrors(measured, gains, 2);
  const calm = remainingErrors({ ...measured, disturbance: { kind: 'none' } }, gains, 2).error;
  /** Below 1 % less than its set it is inside, above 1 % more outside. @param {Part} part @param {number} start */
  const placeOf = (part, start) => {
    const beyond = error[part][start] / sets[part][start] - 1;
    return beyond > 0.01 ? 'outside' : beyond > -0.01 ? 'edge' : 'inside';
  };
  const others = starts.map((_, i) => i).slice(1);
  const placesOf = (/** @type {number} */ start) => parts.map((part) => placeOf(part, start));
  const isCalm = disturbance.kind === 'none';
  const countOf = (/** @type {Part} */ part, /** @type {string} */ place) =>
    isCalm ? '–' : `${others.filter((start) => placeOf(part, start) === place).length}/32`;
  const leavesNone = others.filter((start) => !placesOf(start).includes('outside')).length;
  const sizes = (/** @type {Float64Array} */ all) =>
    [all[0], median(all), Math.max(...all.slice(1))].map(shown);
  return {
    rows: parts.map((part) => [shown(error[part][0]), shown(sets[part][0]), countOf(part, 'inside')]),
    calm: parts.map((part) => shown(calm[part][0])),
    table: parts.flatMap((part) => [
      [...sizes(error[part]), shown(sets[part][0]), countOf(part, 'inside'), countOf(part, 'edge')],
      ...(isCalm ? [] : [[...sizes(calm[part]), '', '', '']]),
    ]),
    places: placesOf(0),
    allInside: others.filter((start) => placesOf(start).every((place) => place === 'inside')).length,
    leavesNone,
  };
}

/** Of all but the first. @param {Float64Array} sizes */
const median = (sizes) => middle(sizes.slice(1)) ?? 0;

/** What a person reads of the part, once it is measured. @param {Page} page */
export async function readPart(page) {
  await page.until('what remains is measured', async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    return document.getElementById('disturbance')?.getAttribute('aria-busy') === 'false';
  });
  return page.evaluate(() => {
    const cells = [...document.querySelectorAll('#remains-rows tr')].map((row) => [
      ...row.querySelectorAll('td'),
    ]);
    const text = (/** @type {Element | null | undefined} */ element) => element?.textContent ?? '';
    return {
      rows: cells.map((row) => row.map((cell) => text(cell.querySelector('span') ?? cell))),
      calm: cells.map(([drive]) => text(drive.querySelector('small'))),
      places: cells.map(([drive]) => drive.className),
      text: text(document.getElementById('remains-text')),
      clock: text(document.getElementById('clock')),
      legend: text(document.querySelector('#legend .dashed')),
    };
  });
}

/** Waits until the table shows these rows, and reads the part then. @param {Page} page @param {string[][]} rows */
export async function shows(page, rows) {
  const isShown = page.until(
    'the table shows what the core measures',
    (wanted) =>
      wanted ===
      JSON.stringify(
        [...document.querySelectorAll('#remains-rows tr')].map((row) =>
          [...row.querySelectorAll('td')].map((cell) => (cell.querySelector('span') ?? cell).textContent),
        ),
      ),
    JSON.stringify(rows),
  );
  await isShown.catch(async () => assert.deepEqual((await readPart(page)).rows, rows));
  return readPart(page);
}

/** The numbers of all rows, whose names are what they should be. @param {Page} page */
export async function numbersOf(page) {
  const [head, ...rows] = await readTable(page, 'disturbance-table');
  assert.equal(
    head.join(),
    'error,this drive,median of 32 other starts,largest of them,its set,others inside,others on the edge',
  );
  for (const [name, ...numbers] of rows) assert.equal(name.endsWith('undisturbed'), numbers.at(-1) === '');
  return rows.map(([, ...numbers]) => numbers);
}
