// The map of starts in the page, and the core's own answers for it.
import { experiment, paperGains, robustness, shown } from '../harness/core.js';
import { read } from '../harness/reading.js';
import { once } from '../../../www/kit/memo.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {'ep' | 'arbitrary'} Method */

/** Who arrives from here does so sooner, and whoever does not takes less time. */
const brief = experiment({ horizon: 4 });
export const [count, half, headings] = [81, 4, 18];

/** The core's own answers for the starts of the map. @param {Method} method @param {Partial<Experiment>} [change] @param {number} [reach] */
export function survey(method, change = {}, reach = half) {
  const asked = { ...brief, ...change };
  const range = (/** @type {number} */ middle) => ({ from: middle - reach, to: middle + reach, count });
  const preset = asked.limits.acceleration === null ? 'velocity-limits' : 'acceleration-limits';
  const runs = robustness(asked, {
    gains: paperGains(preset, method),
    x: range(asked.goal.x),
    y: range(asked.goal.y),
    headings,
  });
  const arrivals = (/** @type {number} */ cell) =>
    runs.arrived.slice(cell * headings, (cell + 1) * headings).reduce((sum, one) => sum + one, 0);
  const all = runs.arrived.reduce((sum, one) => sum + one, 0);
  return { ...runs, arrivals, percent: `${((100 * all) / runs.arrived.length).toFixed(1)} %` };
}

export const ep = once(() => survey('ep'));
export const arbitrary = once(() => survey('arbitrary'));

/** @param {number} column @param {number} row */
export const cellOf = (column, row) => row * count + column;

/** What the core says of one start. @param {ReturnType<typeof survey>} from @param {number} cell @param {number} heading */
export const driveOf = (from, cell, heading) => {
  const run = cell * headings + heading;
  return { cost: shown(from.cost[run]), finalTime: from.finalTime[run] };
};

/** Degrees as they are shown. @param {number} heading */
export const degrees = (heading) => (heading * 20 > 180 ? heading * 20 - 360 : heading * 20);

/** The heading that fails worst, or else costs most. @param {ReturnType<typeof survey>} from @param {number} cell */
export function worst(from, cell) {
  const rank = (/** @type {number} */ heading) => {
    const run = cell * headings + heading;
    return from.cost[run] + (from.arrived[run] ? 0 : 1e9);
  };
  return Array.from({ length: headings }, (_, i) => i).reduce((a, b) => (rank(b) > rank(a) ? b : a));
}

/** Waits until the fine map of the gains with this name is there. @param {Page} page @param {string} name */
export function finished(page, name) {
  return page.until(
    `the map of the ${name} is complete`,
    async (driver, starts) => {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const text = (/** @type {string} */ id) =>
        document.getElementById(`robustness-${id}`)?.textContent?.replace(/\s/g, ' ') ?? '';
      return text('summary').includes(driver) && text('note').startsWith(starts);
    },
    name,
    '118 098 starts in',
  );
}

/** Waits until the gains that are compared with those of the map have theirs. @param {Page} page */
export const compared = (page) =>
  page.until('the other gains have their share', () =>
    /\d/.test(document.getElementById('robustness-rival')?.textContent ?? ''),
  );

/** Opens the map with the paper's gains by EP. @param {Page} page */
export async function openMap(page) {
  await page.open('#robustness&v=1&drives=paper-ep&horizon=4');
  await finished(page, 'paper’s EP gains');
}

/** Pixels of the middle of a cell from the map's corner. @param {Page} page @param {number} column @param {number} row */
export async function pointOf(page, column, row) {
  const { width, height } = await page.evaluate(() => {
    const map = /** @type {HTMLElement} */ (document.getElementById('robustness-map'));
    return { width: map.clientWidth, height: map.clientHeight };
  });
  // Beside the map are its numbers and the names of its axes.
  const side = Math.min(width - 60, height - 52);
  return { x: 52 + (side * (column + 0.5)) / count, y: 8 + (side * (count - row - 0.5)) / count };
}

/** @param {Page} page @param {number} column @param {number} row */
export const clickCell = async (page, column, row) =>
  page.drag('#robustness-map', [await pointOf(page, column, row)]);

/** @param {Page} page */
export async function readDrive(page) {
  const { start, cost, finalTime } = await read(page);
  return { start, cost, finalTime };
}
