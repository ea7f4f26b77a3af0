import { layoutOf } from '../../../www/parts/curves/layout.js';
import { Key } from '../harness/browsers.js';
import { experiment, paperGains, simulate } from '../harness/core.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

export const velocityLimits = experiment('velocity-limits');
export const ep = simulate(velocityLimits, paperGains('velocity-limits', 'ep'));
export const arbitrary = simulate(velocityLimits, paperGains('velocity-limits', 'arbitrary'));

/** Opens the curves with the paper's gains from evolution, at rest. @param {Page} page */
export async function openCurves(page) {
  await page.open('#curves');
  await page.click('#drives-paper-ep');
  await toEnd(page);
}

/** @param {Page} page */
export async function toEnd(page) {
  await page.focus('#scrub');
  await page.press(Key.END);
}

/** @param {Page} page @param {string} view */
export const show = (page, view) => page.click(`#curves-view-${view}`);

/** The rows of a table, its head first. @param {Page} page @param {string} id */
export const table = (page, id) =>
  page.evaluate(async (name) => {
    const element = /** @type {HTMLTableElement} */ (document.getElementById(name));
    return [...element.rows].map((row) =>
      [...row.cells].map((cell) => cell.innerText.replaceAll('\n', ' ').trim()),
    );
  }, id);

/** What the comparison says, by the names of its rows. @param {Page} page */
export async function comparison(page) {
  await show(page, 'compare');
  const [head, ...rows] = await table(page, 'pins-table');
  const body = rows.map(([name, ...values]) => /** @type {[string, string[]]} */ ([name, values]));
  return { names: head.slice(1), rows: Object.fromEntries(body) };
}

/** @param {Page} page */
export const readings = (page) =>
  page.evaluate(async () => {
    return ['x', 'y', 'theta', 'linear', 'angular', 'cost'].map((id) =>
      Number(document.getElementById(`reading-${id}`)?.innerText.replace('−', '-')),
    );
  });

/** What has to be read at a sample. @param {import('../../../pkg/ep_locomotion.js').Run} run @param {number} i */
export const expectedReadings = (run, i) => [
  Number(run.x[i].toFixed(2)),
  Number(run.y[i].toFixed(2)),
  Number(((run.theta[i] * 180) / Math.PI).toFixed(1)),
  Number(run.linear[i].toFixed(2)),
  Number(run.angular[i].toFixed(2)) + 0,
  Number(
    (i === run.time.length - 1 ? run.cost.total : run.time[i] + run.pathCost[i] + run.energyCost[i]).toFixed(
      3,
    ),
  ),
];

/** Where the picture has its plots. @param {Page} page @param {import('../../../pkg/ep_locomotion.js').Run[]} others */
export async function layoutOn(page, others, driving = ep) {
  const size = await page.evaluate(() => {
    const { clientWidth, clientHeight } = /** @type {HTMLElement} */ (
      document.getElementById('curves-picture')
    );
    return { width: clientWidth, height: clientHeight };
  });
  return layoutOf(size, driving, others, velocityLimits.limits);
}
