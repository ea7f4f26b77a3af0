// Many seeds: the page shows what the core computes, its quartiles are right, and a seed can be opened in the lab.
import assert from 'node:assert/strict';
import { seedRuns } from '../../../pkg/ep_locomotion.js';
import { Key, pageTest } from '../harness/browsers.js';
import { experiment, paperGains, shown, shownGains, simulate } from '../harness/core.js';
import { read } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../pkg/ep_locomotion.js').Preset} Preset */

const [count, generations] = [20, 50];
const drives = 20 * (generations + 1);

/** The same seeds in Node. @param {Preset} preset */
const expectedRuns = (preset) => seedRuns(experiment(preset), { seeds: [1, 1 + count], generations });
const runs = expectedRuns('velocity-limits');

/** Sorted, and counted by hand: of 20 numbers the median lies between the 10th and the 11th. @param {number[]} values */
function quartilesByHand(values) {
  const sorted = [...values].sort((a, b) => a - b);
  return [
    sorted[0],
    sorted[4] + 0.75 * (sorted[5] - sorted[4]),
    (sorted[9] + sorted[10]) / 2,
    sorted[14] + 0.25 * (sorted[15] - sorted[14]),
    sorted[19],
  ];
}

/** Opens the part and chooses few seeds, which take no time. @param {Page} page */
async function openLuck(page) {
  await page.click('#page-luck');
  await page.until('the part is open', () => document.getElementById('luck')?.hidden === false);
  await page.click(`#luck-count option[value="${count}"]`);
  await page.click(`#luck-generations option[value="${generations}"]`);
}

/** @param {Page} page */
async function runSeeds(page) {
  await page.click('#luck-run');
  await page.until('the seeds have run', async () => {
    // The press shows in the next picture.
    await new Promise((resolve) => requestAnimationFrame(resolve));
    return document.getElementById('luck-run')?.textContent?.startsWith('Run');
  });
}

/** Costs and gains in a text. @param {string} text */
const numbersIn = (text) => text.replaceAll('−', '-').match(/-?\d+\.\d+/g) ?? [];

/** The cells of the table, row by row. @param {Page} page */
async function readTable(page) {
  await page.click('#luck-table');
  const rows = await page.evaluate(() =>
    [...document.querySelectorAll('#table-rows tbody tr')].map((row) =>
      [...row.children].map((cell) => (cell.textContent ?? '').replaceAll('−', '-')),
    ),
  );
  await page.press(Key.ESCAPE);
  await page.until('the table is closed', () => !document.querySelector('#table[open]'));
  return rows;
}

/** What the table must say. @param {ReturnType<typeof expectedRuns>} from */
function expectedTable(from) {
  const columns = [
    ...[0, 3, 13, 25, 50].map((generation) => from.map(({ best }) => best[generation])),
    ...[0, 1, 2].map((i) => from.map(({ champion }) => champion.gains[i])),
    from.map(({ random }) => random[generations]),
  ];
  const quartiles = columns.map(quartilesByHand);
  // No −0 is shown.
  const text = (/** @type {number} */ value) => shown(value).replace(/^-(0\.000)$/, '$1');
  return [
    ...['lowest', 'lower quartile', 'median', 'upper quartile', 'highest'].map((name, i) => [
      name,
      ...quartiles.map((one) => text(one[i])),
    ]),
    ...from.map((_, i) => [String(1 + i), ...columns.map((column) => text(column[i]))]),
  ];
}

/** The status and the sentence under the button. @param {Page} page */
const readWords = (page) =>
  page.evaluate(async () => {
    const text = (/** @type {string} */ id) =>
      /** @type {HTMLElement} */ (document.getElementById(id)).innerText;
    return {
      status: text('luck-status'),
      finding: text('luck-finding'),
      note: text('luck-note'),
      readout: text('luck-readout'),
    };
  });

/** That the CSV holds every number of every seed. @param {Page} page */
async function assertCsv(page) {
  await page.click('#luck-table');
  // The browser would ask where to save it.
  await page.evaluate(() => {
    const saved = /** @type {{ saved?: { blob?: Blob, name?: string } }} */ (/** @type {unknown} */ (window));
    const urlOf = URL.createObjectURL;
    saved.saved = {};
    URL.createObjectURL = (blob) => {
      Object.assign(saved.saved ?? {}, { blob });
      return urlOf.call(URL, blob);
    };
    HTMLAnchorElement.prototype.click = function () {
      if (this.href.startsWith('blob:')) Object.assign(saved.saved ?? {}, { name: this.download });
    };
  });
  await page.click('#table-csv');
  const { text, type, name } = await page.evaluate(async () => {
    const { saved } = /** @type {{ saved: { blob: Blob, name: string } }} */ (
      /** @type {unknown} */ (window)
    );
    return { text: await saved.blob.text(), type: saved.blob.type, name: saved.name };
  });
  assert.deepEqual([type, name], ['text/csv', 'seeds-1-to-20-50-generations.csv']);
  const [header, ...lines] = text
    .trimEnd()
    .split('\r\n')
    .map((line) => line.split(','));
  assert.equal(header.length, 7 + 2 * (generations + 1));
  assert.deepEqual(header.slice(0, 2), ['seed', 'drives']);
  assert.equal(header.at(-1), 'J random search generation 50');
  assert.deepEqual(
    lines.map((line) => line.map(Number)),
    runs.map(({ best, champion, random }, i) => [
      1 + i,
      drives,
      champion.cost,
      ...champion.gains,
      random[generations],
      ...best,
      ...random,
    ]),
  );
}

pageTest(
  'the numbers of many seeds, and of their CSV, are those of the core, with quartiles counted by hand',
  async (page) => {
    await openLuck(page);
    assert.match(await page.text('#luck-finding'), /1\u202f020 drives each/);
    await runSeeds(page);

    const finals = quartilesByHand(runs.map(({ champion }) => champion.cost));
    const randoms = quartilesByHand(runs.map(({ random }) => random[generations]));
    const { finding, note, status } = await readWords(page);
    assert.deepEqual(numbersIn(finding), [finals[2], finals[4], randoms[2]].map(shown));
    const wins = runs.filter(({ champion, random }) => random[generations] < champion.cost).length;
    assert.match(finding, new RegExp(`better for ${wins || 'no'} seed`));
    const medians = Array.from(
      { length: generations + 1 },
      (_, g) => quartilesByHand(runs.map(({ best }) => best[g]))[2],
    );
    assert.match(
      finding,
      new RegExp(`there at generation ${medians.findIndex((one) => one <= randoms[2])}\\.`),
    );
    assert.match(
      note,
      new RegExp(`^${count} seeds, 2 × ${drives} drives each`.replace('1020', '1\u202f020')),
    );
    assert.equal(status, '');
    assert.deepEqual(await readTable(page), expectedTable(runs));

    const label = await page.evaluate(
      () => document.getElementById('luck-curve')?.getAttribute('aria-label') ?? '',
    );
    const paper = simulate(experiment('velocity-limits'), paperGains('velocity-limits', 'ep')).cost.total;
    assert.ok(label.includes(shown(paper)), label);
    assert.deepEqual(await page.obstacles(), []);
    assert.deepEqual(await page.problems(), []);
    await assertCsv(page);
  },
);

pageTest('other limits mark the seeds as out of date until they run again', async (page) => {
  await openLuck(page);
  await runSeeds(page);
  const before = await readWords(page);
  assert.equal(before.status, '');
  assert.equal(await page.evaluate(() => document.getElementById('luck-open')?.hidden), false);

  await page.click('#preset-acceleration-limits');
  const stale = await readWords(page);
  assert.equal(stale.status, 'Out of date: these seeds ran under the earlier limits.');
  assert.equal(stale.finding, before.finding);
  assert.deepEqual(await readTable(page), expectedTable(runs));
  // What another seed's lab would show is not what these seeds have found.
  assert.equal(await page.evaluate(() => document.getElementById('luck-open')?.hidden), true);
  assert.deepEqual(await page.obstacles(), []);

  await page.click('#preset-velocity-limits');
  assert.equal((await readWords(page)).status, '');

  await page.click('#preset-acceleration-limits');
  await runSeeds(page);
  assert.equal((await readWords(page)).status, '');
  assert.deepEqual(await readTable(page), expectedTable(expectedRuns('acceleration-limits')));
});

pageTest('the slider goes from the luckiest seed to the unluckiest, and its gains drive', async (page) => {
  await openLuck(page);
  await runSeeds(page);
  const ranking = [...runs.keys()].sort((a, b) => runs[a].champion.cost - runs[b].champion.cost);
  /** @param {number} rank */
  const expected = (rank) => {
    const i = ranking[rank - 1];
    const { cost, gains } = runs[i].champion;
    const [kx, ky, ktheta] = shownGains(gains);
    return `Seed ${i + 1}, number ${rank} of 20: J ${shown(cost)} kx ${kx}, ky ${ky}, kθ ${ktheta}`.replaceAll(
      '-0.000',
      '0.000',
    );
  };
  const readout = async () => (await readWords(page)).readout.replaceAll('−', '-').replace(/\s+/g, ' ');
  // The lab's own seed, at first.
  assert.equal(await readout(), expected(ranking.indexOf(0) + 1));
  await page.focus('#luck-rank');
  await page.press(Key.HOME);
  assert.equal(await readout(), expected(1));
  await page.press(Key.ARROW_RIGHT);
  assert.equal(await readout(), expected(2));
  await page.press(Key.END);
  assert.equal(await readout(), expected(20));

  await page.click('#page-lab');
  const { champion } = runs[ranking[19]];
  const { cost, driver } = await read(page);
  assert.deepEqual([driver, cost], ['hand', shown(champion.cost)]);
  assert.equal(await page.text('#legend .solid'), 'gains from Luck');
});

pageTest('a dot names its seed; opened in the lab, that seed ends at the same J', async (page) => {
  await openLuck(page);
  await runSeeds(page);
  const first = (await readWords(page)).readout;
  const canvas = await page.element('#luck-gains');
  const width = await page.evaluate(() => document.getElementById('luck-gains')?.clientWidth ?? 0);
  const height = await page.evaluate(() => document.getElementById('luck-gains')?.clientHeight ?? 0);
  // Along the foot of the strip of kθ, from its far end, until a dot is met.
  let met = first;
  for (let x = width - 60; x > 30 && met === first; x -= 5) {
    await page.driver
      .actions()
      .move({ origin: canvas, duration: 0, x: Math.round(x - width / 2), y: Math.round(height / 2 - 24) })
      .perform();
    met = (await readWords(page)).readout;
  }
  const seed = Number(/Seed (\d+)/.exec(met)?.[1]);
  // Those beyond the end of the axis stand at its end, on each other.
  const larger = runs.filter(({ champion }) => champion.gains[2] > runs[seed - 1].champion.gains[2]);
  assert.ok(larger.length <= 2, `kθ of seed ${seed} is not among the largest`);
  await page.driver.actions().click().perform();

  assert.equal(await page.text('#luck-open'), `Open seed ${seed} in the lab`);
  await page.click('#luck-open');
  await page.until('the lab is open', () => document.body.dataset.open === 'lab');
  assert.equal(await page.text('#seed'), String(seed));
  assert.equal((await read(page)).driver, 'evolved');
  await page.until('the seed has run', () => document.getElementById('generation')?.textContent === '50');
  const { cost, gains, generation } = await read(page);
  const { champion } = runs[seed - 1];
  assert.deepEqual([generation, cost, gains], ['50', shown(champion.cost), shownGains(champion.gains)]);

  // Back among the seeds, it is the one in question.
  await page.click('#page-luck');
  assert.equal((await readWords(page)).readout, met);
});
