import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { evolve } from '../harness/core.js';
import { middleOf, readEvolution } from '../harness/reading.js';
import { excess, follow } from '../whole/surround.js';
import { arbitrary, expected, numbersOf, preset, readPart, shows } from './disturbance-page.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

pageTest('where Theorem 2 promises nothing there are no sets', async (page) => {
  await page.open('#disturbance');
  for (const [link, isPromised] of /** @type {const} */ ([
    ['gains=1,-1,1', false],
    ['gains=1,1,1', true],
    ['gains=1,1,1&law=kanayama', false],
  ])) {
    await follow(page, `disturbance&v=1&under=slip,0.1,0.1,1&drives=hand&${link}`);
    const { rows } = await readPart(page);
    const sets = rows.flatMap((row) => [row[1], row[2]]);
    assert.ok(
      sets.every((text) => (text === '–') !== isPromised),
      `${link}: ${sets}`,
    );
    const marked = () => document.querySelectorAll('#remains .outside, #remains-legend .set').length;
    assert.equal((await page.evaluate(marked)) > 0, isPromised, link);
  }
});

/** Opens the part with the paper's arbitrary gains, which no evolution changes. @param {Page} page */
async function openPart(page) {
  await page.click('#page-disturbance');
  await page.click('#drives-paper-arbitrary');
}

/** Types into a field over what it holds. @param {Page} page @param {string} id @param {string} text */
async function type(page, id, text) {
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.focus(`#${id}`);
  await page.press(...text, Key.ENTER);
}

/** What is drawn of the three plots, as a string. @param {Page} page */
const pictures = (page) =>
  page.evaluate(async () => {
    return [...document.querySelectorAll('.remains-plot canvas:first-child')]
      .map((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL())
      .join();
  });

pageTest('what remains is what the core measures, for each kind of disturbance', async (page) => {
  await openPart(page);
  for (const [kind, disturbance] of /** @type {const} */ ([
    ['slip', { kind: 'slip', linear: 0.1, angular: 0.2 }],
    ['random', { kind: 'random', linear: 0.1, angular: 0.2, seed: 1 }],
  ])) {
    await page.click(`#disturbance-kind-${kind}`);
    const core = expected(arbitrary, disturbance);
    const { calm, places, text, clock, legend } = await shows(page, core.rows);
    assert.deepEqual(places, core.places, kind);
    assert.deepEqual(calm, core.calm, kind);
    assert.deepEqual(await numbersOf(page), core.table, kind);
    assert.match(text, new RegExp(`Of 32 other starts, ${core.allInside} stays? within reach of all three`));
    const atEdge = core.leavesNone - core.allInside;
    assert.equal(/, (\d+) within 1 % of an edge/.exec(text)?.[1] ?? '0', String(atEdge), text);
    const isInside = core.places.every((place) => place === 'inside');
    assert.equal(text.includes('this drive stays within reach of all three sets'), isInside, text);
    // Nobody arrives, and the robot is compared with itself.
    assert.match(clock, /of 10\.00 s/);
    assert.match(legend, /without the disturbance/);
  }
  await page.click('#disturbance-kind-none');
  const core = expected(arbitrary, { kind: 'none' });
  const { text } = await shows(page, core.rows);
  assert.match(text, /Without a disturbance/);
  assert.deepEqual(await numbersOf(page), core.table);
});

pageTest(
  'where the experiment has a disturbance of its own the part says that another is tried',
  async (page) => {
    const own = 'disturbance.kind=random&disturbance.linear=0.1&disturbance.angular=0.1';
    const note = () => page.text('#disturbance-note');
    await page.open(`#disturbance&v=1&${own}`);
    await readPart(page);
    assert.equal(await note(), 'only tried here; in the experiment: random, 0.1 m/s, 0.1 rad/s');
    await follow(page, `disturbance&v=1&${own}&under=random,0.1,0.1,1`);
    await readPart(page);
    assert.match(await note(), /drawn afresh/);
  },
);

pageTest('kind and sizes follow the mouse and the keys', async (page) => {
  await openPart(page);
  await readPart(page);
  const before = await pictures(page);
  await page.focus('#disturbance-kind-slip');
  await page.press(Key.ARROW_LEFT);
  await shows(page, expected(arbitrary, { kind: 'random', linear: 0.1, angular: 0.2, seed: 1 }).rows);
  await page.focus('#slider-epsilon1');
  await page.press(Key.ARROW_RIGHT);
  const linear = await page.until('the slider has moved', () => {
    const { value } = /** @type {HTMLInputElement} */ (document.getElementById('gain-epsilon1'));
    return value !== '0.100' && Number(value);
  });
  assert.ok(linear > 0.1 && linear < 0.2, `ε1 is ${linear}`);
  await type(page, 'gain-epsilon2', '0,5');
  const random = { kind: /** @type {const} */ ('random'), linear, angular: 0.5, seed: 1 };
  await shows(page, expected(arbitrary, random).rows);
  assert.notEqual(await pictures(page), before);

  await page.click('#disturbance-draw');
  const seed = await page.until('another draw has a number', () => {
    const [, number] = document.getElementById('disturbance-note')?.textContent.match(/draw (\d+)/) ?? [];
    return number !== '1' && Number(number);
  });
  await shows(page, expected(arbitrary, { ...random, seed }).rows);

  await page.click('#disturbance-kind-slip');
  await type(page, 'gain-delta1', '−0.25');
  const slip = { kind: /** @type {const} */ ('slip'), linear: -0.25, angular: 0.5 };
  await shows(page, expected(arbitrary, slip).rows);
  // A bound has no sign.
  await page.click('#disturbance-kind-random');
  await shows(page, expected(arbitrary, { ...random, linear: 0.25, seed }).rows);
});

pageTest('a size out of range is refused beside its field, and the last measurement stays', async (page) => {
  await openPart(page);
  await page.click('#disturbance-kind-random');
  const good = { kind: /** @type {const} */ ('random'), linear: 0.1, angular: 0.2, seed: 1 };
  const before = await shows(page, expected(arbitrary, good).rows);
  for (const [id, name, text, range] of [
    ['epsilon1', 'ε1', 'abc', 'must be a number'],
    ['epsilon1', 'ε1', '101', 'from -100 to 100 m/s'],
    ['epsilon2', 'ε2', '1e9', 'from -100 to 100 rad/s'],
    ['epsilon2', 'ε2', '-0.1', '0 or more'],
  ]) {
    await type(page, `gain-${id}`, text);
    await page.until(
      `the message says that ${name} ${range}`,
      (field, ...words) => {
        const message = document.getElementById(`${field}-error`);
        return message?.checkVisibility() && words.every((word) => message.textContent.includes(word));
      },
      `gain-${id}`,
      name,
      range,
    );
    const { rows } = await readPart(page);
    const invalid = await page.evaluate(
      (field) => document.getElementById(field)?.getAttribute('aria-invalid'),
      `gain-${id}`,
    );
    assert.equal(invalid, 'true');
    assert.deepEqual(rows, before.rows);
  }
  await type(page, 'gain-epsilon2', '0.3');
  await shows(page, expected(arbitrary, { ...good, angular: 0.3 }).rows);
  assert.equal(
    await page.evaluate(() => document.querySelectorAll('#disturbance [aria-invalid=true]').length),
    0,
  );
});

pageTest(
  'a disturbance and a start that are tried end with the part, and evolution is untouched',
  async (page) => {
    await page.click('#one-generation');
    await page.click('#one-generation');
    const before = await readEvolution(page);
    await page.click('#page-disturbance');
    const first = await readPart(page);
    const start = await middleOf(page, 'start-position');
    await page.drag('#plane-robots', [start, { x: start.x + 60, y: start.y - 40 }]);
    await page.until(
      'the start that is tried is measured',
      (before) => document.getElementById('remains-text')?.textContent !== before,
      first.text,
    );
    await page.click('#disturbance-kind-random');
    await readPart(page);
    await page.click('#page-lab');
    assert.deepEqual(await readEvolution(page), before);
    const { clock, legend } = await page.evaluate(async () => {
      const text = (/** @type {string} */ selector) => document.querySelector(selector)?.textContent ?? '';
      return { clock: text('#clock'), legend: text('#legend .dashed') };
    });
    assert.doesNotMatch(clock, /of 10\.00 s/);
    assert.doesNotMatch(legend, /without the disturbance/);
    // What was tried is kept for the next time, the start is not.
    await page.click('#page-disturbance');
    const again = expected(evolve(preset, 2).gains, { kind: 'random', linear: 0.1, angular: 0.2, seed: 1 });
    await shows(page, again.rows);
  },
);

/** Where the formulas end, and where the numbers and fields below them begin. @param {Page} page */
const heightsOf = (page) =>
  page.evaluate(() => {
    const range = document.createRange();
    const boxes = (/** @type {string} */ selector) =>
      [...document.querySelectorAll(selector)].map((one) => {
        range.selectNodeContents(one);
        return one.matches('td') ? range.getBoundingClientRect() : one.getBoundingClientRect();
      });
    return {
      formulas: boxes('.remains-formula').map(({ bottom }) => bottom),
      numbers: boxes('.remains th + td').map(({ top }) => top),
      draw: boxes('#disturbance-draw')[0].bottom,
      fields: boxes('.sizes input[type="text"]').map(({ top }) => top),
    };
  });

pageTest(
  'without obstacles the part fits a laptop and a projector, and neither numbers nor fields lie under what stands above them',
  async (page) => {
    await page.open('#disturbance');
    await readPart(page);
    assert.deepEqual(await page.obstacles(), []);
    for (const [width, height] of /** @type {const} */ ([
      [1440, 900],
      [1024, 768],
    ])) {
      await page.resize(width, height);
      for (const kind of ['none', 'slip', 'random']) {
        await page.click(`#disturbance-kind-${kind}`);
        await readPart(page);
        assert.deepEqual(await excess(page), [0, 0], `${kind} at ${width} × ${height}`);
      }
      const { formulas, numbers, draw, fields } = await heightsOf(page);
      assert.deepEqual([numbers.length, fields.length], [3, 2]);
      for (const [i, top] of numbers.entries()) assert.ok(top >= formulas[i] - 1, `${formulas[i]}, ${top}`);
      for (const top of fields) assert.ok(top >= draw + 4, `${draw}, ${top}`);
    }
    assert.deepEqual(await page.problems(), []);
  },
);
