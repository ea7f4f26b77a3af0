// A generation as the page shows it, beside the record of the core.
import assert from 'node:assert/strict';
import { Key } from '../harness/browsers.js';
import { Evolution, experiment } from '../harness/core.js';
import { follow } from '../whole/surround.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

export const velocityLimits = experiment('velocity-limits');
export const { population: count, opponents: bouts } = velocityLimits.evolution;
export const phases = /** @type {const} */ ([
  'parents',
  'mutation',
  'drive',
  'tournament',
  'ranking',
  'survivors',
]);
/** @typedef {typeof phases[number]} Phase */

/** The core's own record of a generation, and who would be who. @param {number} generation @param {typeof velocityLimits} [from] */
export function recordOf(generation, from = velocityLimits) {
  const evolution = new Evolution(from);
  for (let i = 0; i < generation; i++) evolution.step();
  const record = evolution.record(generation);
  return { ...record, all: [...record.parents, ...record.offspring] };
}

/** @param {number} number */
export const nameOf = (number) =>
  number < count ? `parent ${number + 1}` : `offspring ${number - count + 1}`;

/** Where each number stands: most wins first, then lower J, then lower number. @param {number[]} wins @param {number[]} costs */
export const rank = (wins, costs) =>
  wins.map((_, i) => i).sort((a, b) => wins[b] - wins[a] || costs[a] - costs[b] || a - b);

/** The worst survivor and the best of the fallen, if the wrong way round. @param {ReturnType<typeof recordOf>} record */
export function upsetOf({ all, survivors }) {
  const cost = (/** @type {number} */ number) => all[number].cost;
  const byCost = all.map((_, number) => number).sort((a, b) => cost(a) - cost(b));
  const survivor = byCost.filter((number) => survivors.includes(number)).at(-1) ?? -1;
  const fallen = byCost.find((number) => !survivors.includes(number)) ?? -1;
  return cost(survivor) > cost(fallen) ? { survivor, fallen } : null;
}

/** @param {string} text */
export const numbersIn = (text) => text.replaceAll('−', '-').match(/-?\d+(\.\d+)?/g) ?? [];

/** That a printed number is the exact one, rounded. @param {string | undefined} printed @param {number} exact @param {string} what */
export function same(printed, exact, what) {
  assert.ok(printed, what);
  const digits = printed.split('.')[1]?.length ?? 0;
  assert.ok(
    Math.abs(Number(printed) - exact) <= 0.500001 / 10 ** digits,
    `${what}: ${printed}, not ${exact}`,
  );
}

/** Where the part stands. */
export const ownSection = 'section[data-page="generation"]';

/** @param {Page} page @param {Phase} phase */
export const go = (page, phase) => page.click(`#generation-phases-${phase}`);

/** Opens the part at a generation that was evolved there. @param {Page} page @param {number} generation */
export async function openAt(page, generation) {
  await page.click('#page-generation');
  await page.focus('#one-generation');
  await page.press(...Array(generation).fill(Key.ENTER));
  await page.until(
    'the generation',
    (g) => document.getElementById('generation-title')?.innerText.endsWith(` ${g}`),
    generation,
  );
}

/** Follows a link to a generation of the part: what is far away comes in pieces. @param {Page} page @param {number} generation @param {string} more */
export async function followTo(page, generation, more) {
  await follow(page, `generation&v=1&generation=${generation}&${more}`);
  await page.until(
    'the generation',
    (wanted) =>
      document.getElementById('generation-title')?.textContent?.match(/\d+/)?.[0] === wanted &&
      document.getElementById('generation-details')?.children.length,
    String(generation),
  );
}

/** What the part shows once it has drawn what happened last. @param {Page} page */
export const shownOn = (page) =>
  page.evaluate(async () => {
    const text = (/** @type {string} */ selector) =>
      [...document.querySelectorAll(selector)].map(
        (element) => /** @type {HTMLElement} */ (element).innerText,
      );
    const picture = /** @type {HTMLElement} */ (document.getElementById('generation-picture'));
    const phase = /** @type {HTMLInputElement} */ (
      document.querySelector('#generation-phases input:checked')
    );
    return {
      title: text('#generation-title')[0],
      phase: phase.value,
      sentence: text('#generation-sentence')[0],
      chosen: picture.getAttribute('aria-valuetext')?.split(',')[0] ?? '',
      said: picture.getAttribute('aria-valuetext') ?? '',
      headline: text('#generation-details .headline')[0],
      equations: text('#generation-details .equation'),
      common: text('#generation-details .common')[0] ?? '',
      triple: text('#generation-details .triple')[0] ?? '',
      parts: text('#generation-details .parts')[0] ?? '',
      details: text('#generation-details')[0],
      bouts: text('#generation-details .bouts li'),
      ranks: text('#generation-details .ranks li'),
      legend: text('#legend li')[0],
      rival: text('#legend .dashed')[0],
      others: text('#legend .thin')[0],
    };
  });

/** Presses the place of a mark. @param {Page} page @param {number} number */
export async function press(page, number) {
  const place = await page.until(
    'the marks stand still',
    (id) => {
      const picture = document.getElementById('generation-picture');
      const mark = document.getElementById(id);
      if (!picture || !mark || picture.getAnimations({ subtree: true }).length > 0) return null;
      const [box, around] = [mark, picture].map((element) => element.getBoundingClientRect());
      return { x: box.left + box.width / 2 - around.left, y: box.top + box.height / 2 - around.top };
    },
    `individual-${number}`,
  );
  await page.drag('#generation-picture', [place]);
}

/** All rows of the table: texts by column. @param {Page} page */
export async function table(page) {
  await page.click('#generation-table');
  const rows = await page.evaluate(() => {
    const texts = (/** @type {Element} */ row) =>
      [...row.children].map((cell) => /** @type {HTMLElement} */ (cell).innerText);
    const names = texts(/** @type {Element} */ (document.querySelector('#table-rows thead tr')));
    return [...document.querySelectorAll('#table-rows tbody tr')].map((row) =>
      Object.fromEntries(texts(row).map((text, i) => [names[i], text])),
    );
  });
  await page.click('#table-close');
  return rows;
}
