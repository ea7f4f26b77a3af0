import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { experiment } from '../harness/core.js';
import { middleOf, read, readEvolution } from '../harness/reading.js';
import {
  arbitrary,
  cellOf,
  clickCell,
  compared,
  count,
  degrees,
  driveOf,
  ep,
  finished,
  headings,
  openMap,
  pointOf,
  readDrive,
  survey,
  worst,
} from './robustness-page.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

pageTest('the map says what the core says of the same starts', async (page) => {
  await openMap(page);
  assert.equal(await page.text('#robustness-share'), ep().percent);
  await compared(page);
  assert.equal(
    await page.text('#robustness-rival'),
    `${arbitrary().percent} with the paper’s arbitrary gains`,
  );

  // Dark where all headings arrive, without colour where none does.
  const cells = [];
  for (let row = 1; row < count; row += 4)
    for (let column = 1; column < count; column += 4) {
      const arrivals = ep().arrivals(cellOf(column, row));
      const near = Math.hypot(column - 40, row - 40) < 12 || Math.hypot(column - 20, row - 20) < 16;
      if (!near && (arrivals === 0 || arrivals === headings))
        cells.push({ arrivals, ...(await pointOf(page, column, row)) });
    }
  const colours = await page.evaluate((points) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('robustness-picture'));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    const pixels = canvas.width / canvas.clientWidth;
    return points.map(({ x, y }) => [
      ...context.getImageData(Math.floor(x * pixels), Math.floor(y * pixels), 1, 1).data,
    ]);
  }, cells);
  assert.ok(cells.filter(({ arrivals }) => arrivals === 0).length > 40, 'many cells where none arrives');
  assert.ok(cells.filter(({ arrivals }) => arrivals > 0).length > 40, 'many cells where all arrive');
  for (const [i, { arrivals }] of cells.entries()) {
    const [red, , blue] = colours[i];
    const isDark = red < 20 && blue > 60 && blue < 100;
    assert.equal(isDark, arrivals === headings, `${arrivals} arrive, drawn as ${colours[i]}`);
    if (arrivals === 0) assert.ok(Math.abs(red - blue) < 24, `none arrives, drawn as ${colours[i]}`);
  }
});

pageTest('a click on a cell lets the robot drive from there, and evolution stays as it was', async (page) => {
  await page.open('#lab&v=1&horizon=4');
  await page.click('#one-generation');
  await page.click('#one-generation');
  const before = await readEvolution(page);
  await page.click('#page-robustness');
  await page.click('#drives-paper-ep');
  await finished(page, 'paper’s EP gains');
  const own = await readDrive(page);

  // None arrives from (4.00, 1.00): the worst comes first, and the next click takes the next heading.
  const fails = cellOf(60, 30);
  const first = worst(ep(), fails);
  await clickCell(page, 60, 30);
  assert.deepEqual(await readDrive(page), {
    start: { x: 4, y: 1, degrees: degrees(first) },
    ...driveOf(ep(), fails, first),
  });
  await clickCell(page, 60, 30);
  const second = (first + 1) % headings;
  assert.deepEqual(await readDrive(page), {
    start: { x: 4, y: 1, degrees: degrees(second) },
    ...driveOf(ep(), fails, second),
  });

  // Some arrive from (0.50, 0.50).
  const mixed = cellOf(25, 25);
  assert.ok(ep().arrivals(mixed) > 0 && ep().arrivals(mixed) < headings);
  await clickCell(page, 25, 25);
  assert.deepEqual(await readDrive(page), {
    start: { x: 0.5, y: 0.5, degrees: degrees(worst(ep(), mixed)) },
    ...driveOf(ep(), mixed, worst(ep(), mixed)),
  });
  assert.match(
    await readout(page),
    new RegExp(`^x 0.50 m, y 0.50 m: ${ep().arrivals(mixed)} of 18 headings arrive`),
  );

  await page.click('#restore-postures');
  assert.deepEqual(await readDrive(page), own);

  // From (2.60, −1.20) some fail with the arbitrary gains, though a drive that arrives costs most.
  await page.click('#drives-paper-arbitrary');
  await finished(page, 'paper’s arbitrary gains');
  const rare = cellOf(46, 8);
  const failing = worst(arbitrary(), rare);
  const most = Math.max(...arbitrary().cost.slice(rare * headings, (rare + 1) * headings));
  assert.ok(arbitrary().arrivals(rare) > 0 && arbitrary().cost[rare * headings + failing] < most);
  await clickCell(page, 46, 8);
  assert.deepEqual(await readDrive(page), {
    start: { x: 2.6, y: -1.2, degrees: degrees(failing) },
    ...driveOf(arbitrary(), rare, failing),
  });
  await page.click('#page-lab');
  await page.click('#drives-evolved');
  assert.deepEqual(await readEvolution(page), before);
});

/** What the map says in words, once the page has drawn what happened last. @param {Page} page */
const readout = (page) =>
  page.evaluate(async () => {
    return document.getElementById('robustness-readout')?.innerText ?? '';
  });

pageTest('the keyboard moves the cursor from cell to cell and lets the robot drive', async (page) => {
  await openMap(page);
  const resting = await readout(page);
  assert.match(
    resting,
    new RegExp(
      `^You watch the start at x 0.00 m, y 0.00 m, heading 0°: .* ${ep().arrivals(cellOf(20, 20))} of 18 headings`,
    ),
  );
  await page.focus('#robustness-map');
  await page.press(Key.ARROW_RIGHT, Key.ARROW_DOWN, Key.ARROW_DOWN);
  const keys = page.driver.actions().keyDown(Key.SHIFT);
  await keys.keyDown(Key.ARROW_RIGHT).keyUp(Key.ARROW_RIGHT).keyUp(Key.SHIFT).perform();
  const cell = cellOf(29, 18);
  const some = ep().arrivals(cell);
  assert.ok(some > 0 && some < headings, `${some} arrive`);
  assert.match(await readout(page), new RegExp(`^x 0.90 m, y −0.20 m: ${some} of 18 headings`));

  await page.press(Key.ENTER);
  const heading = worst(ep(), cell);
  assert.deepEqual(await readDrive(page), {
    start: { x: 0.9, y: -0.2, degrees: degrees(heading) },
    ...driveOf(ep(), cell, heading),
  });
  await page.press(Key.ESCAPE);
  assert.match(await readout(page), /^You watch the start at x 0.90 m, y −0.20 m/);
});

pageTest('the dial chooses one heading, of which the map shows the drives', async (page) => {
  await openMap(page);
  await page.click('#robustness-headings-one');
  // The number stays that of all.
  assert.equal(await page.text('#robustness-share'), ep().percent);
  assert.equal(await page.text('#robustness-summary'), 'arrive, of all headings, with the paper’s EP gains');
  await page.focus('#robustness-rose');
  await page.press(Key.ARROW_LEFT, Key.ARROW_LEFT, Key.ARROW_LEFT);
  await clickCell(page, 25, 25);
  const cell = cellOf(25, 25);
  const { start, ...drive } = await readDrive(page);
  assert.deepEqual(
    { start, drive },
    { start: { x: 0.5, y: 0.5, degrees: 60 }, drive: driveOf(ep(), cell, 3) },
  );
  assert.match(await readout(page), /^x 0.50 m, y 0.50 m, heading 60°: .* You watch it\.$/);

  // Up on the dial: 90° lies between two headings, 80° beside it.
  const { x, y } = await middleOf(page, 'robustness-rose', 'robustness-rose');
  await page.drag('#robustness-rose', [{ x: x + 7, y: y - 40 }]);
  await clickCell(page, 25, 25);
  assert.deepEqual((await readDrive(page)).start, { x: 0.5, y: 0.5, degrees: 80 });
  await page.focus('#robustness-rose');
  await page.press(Key.ESCAPE);
  await page.until('Escape takes all headings together', () =>
    document.querySelector('#robustness-headings-all:checked'),
  );
});

pageTest(
  'other gains, limits, reach and goal give other maps; the last stays when workers fail',
  async (page) => {
    await openMap(page);
    const share = () => page.text('#robustness-share');
    await page.click('#drives-paper-arbitrary');
    await finished(page, 'paper’s arbitrary gains');
    assert.equal(await share(), arbitrary().percent);

    await page.click('#robustness-half option[value="2"]');
    await finished(page, 'paper’s arbitrary gains');
    assert.equal(await share(), survey('arbitrary', {}, 2).percent);

    await page.click('#preset-acceleration-limits');
    await page.click('#drives-paper-ep');
    await finished(page, 'paper’s EP gains');
    const { limits } = experiment('acceleration-limits');
    assert.equal(await share(), survey('ep', { limits }, 2).percent);

    // After a drag it is the one for where the goal was let go.
    const { x, y } = await middleOf(page, 'goal-position', 'goal-position');
    const way = Array.from({ length: 12 }, (_, i) => ({ x: x - 9 * i, y: y + 14 * i }));
    await page.drag('#goal-position', way);
    await finished(page, 'paper’s EP gains');
    const { goal } = await read(page);
    assert.ok(Math.hypot(goal.x - 2, goal.y - 2) > 0.3, `the goal is at ${goal.x}, ${goal.y}`);
    const moved = { limits, goal: { x: goal.x, y: goal.y, theta: (goal.degrees * Math.PI) / 180 } };
    assert.equal(await share(), survey('ep', moved, 2).percent);

    // When the workers fail, the last map stays with its name, and the page says why.
    const last = await share();
    await page.evaluate(() => {
      Worker.prototype.postMessage = () => {
        throw new Error('no room for it');
      };
    });
    await page.click('#drives-paper-arbitrary');
    await page.until('the page says why', () =>
      document.getElementById('robustness-note')?.innerText.includes('no room for it'),
    );
    assert.equal(await share(), last);
    assert.equal(await page.text('#robustness-summary'), 'arrive with the paper’s EP gains');
  },
);
