// What the parking place has for whoever has tried something: the way to evolution's numbers, and why a robot missed.
import assert from 'node:assert/strict';
import { lawTerms, simulate } from '../../../pkg/ep_locomotion.js';
import { toldOf } from '../../../www/parts/park/after/told.js';
import { gainsBetween } from '../../../www/parts/park/after/walk.js';
import { Key, pageTest } from '../harness/browsers.js';
import { createEngine } from '../harness/core.js';
import { test } from '../harness/once.js';
import { bred, counted, parked, slide, starts, task } from './parking.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/core/engine.js').Triple} Triple */

/** @param {number} start */
const alone = (start) => ({ ...task, starts: [starts[start]] });

test('the way between two robots begins and ends with just their gains', () => {
  const [from, to] = /** @type {Triple[]} */ ([
    [11.7, 0.1, 5.2],
    [5.351708118338456, 37.90224782492658, 5.7418956155022975],
  ]);
  assert.deepEqual(gainsBetween(from, to, 0), from);
  assert.deepEqual(gainsBetween(from, to, 1), to);
  assert.deepEqual(gainsBetween([0, 0, 0], [4, 8, 2], 0.25), [1, 2, 0.5]);
});

test('of a robot that missed it is told how far off it ends, and what its gain asks for there', () => {
  const engine = createEngine();
  let seen = { missed: 0, parked: 0 };
  for (const gains of /** @type {Triple[]} */ ([
    [5, 5, 5],
    [12, 12, 0],
    [0, 0, 0],
  ]))
    for (const start of starts.keys()) {
      const experiment = alone(start);
      const told = toldOf(engine, experiment, gains);
      const { arrived, finalTime, cost, x, y, theta } = simulate(experiment, Float64Array.from(gains));
      if ('parkedAfter' in told) {
        assert.ok(arrived && told.parkedAfter === finalTime);
        seen = { ...seen, parked: seen.parked + 1 };
        continue;
      }
      assert.ok(!arrived && Number.isFinite(cost.total));
      assert.equal(told.seconds, finalTime);
      const { goal, tolerance } = task;
      const far = Math.hypot(goal.x - (x.at(-1) ?? 0), goal.y - (y.at(-1) ?? 0));
      if (far > tolerance.position) {
        assert.ok(told.ahead !== 0 || told.aside !== 0);
        const said = Math.hypot(told.ahead, told.aside);
        assert.ok(said <= far + 1e-9 && said >= far - tolerance.position, `${said} of ${far}`);
        assert.equal(told.gain, Math.abs(told.aside) >= Math.abs(told.ahead) ? 'ky' : 'kx');
      } else assert.deepEqual([told.ahead, told.aside, told.gain], [0, 0, 'kθ']);
      const turned = Math.abs(Math.sin((goal.theta - (theta.at(-1) ?? 0)) / 2));
      assert.ok(Math.abs(Math.sin((told.degrees * Math.PI) / 360)) <= turned + 1e-9);
      const error = engine.samples(experiment, gains).at(-1).error;
      const { linear, angular } = lawTerms(experiment, Float64Array.from(gains), error).command[
        told.gain === 'kθ' ? 'ktheta' : /** @type {'kx' | 'ky'} */ (told.gain)
      ];
      const terms = told.gain === 'kθ' ? [angular] : [linear, angular];
      assert.deepEqual(
        told.asks.map(({ value }) => value),
        terms,
      );
      seen = { ...seen, missed: seen.missed + 1 };
    }
  assert.ok(seen.missed > 40 && seen.parked > 20, JSON.stringify(seen));
});

/** Evolution has come to its end, after one try by hand with three equal gains. @param {Page} page @param {number} value */
async function evolved(page, value) {
  await page.setPace(50);
  for (const gain of ['kx', 'ky', 'ktheta']) await slide(page, gain, value);
  await counted(page);
  await page.click('#park-evolve');
  await page.until('evolution has come to its end', () => document.getElementById('park-between'));
  await counted(page);
}

/** Whose number it is. @param {Page} page */
const driver = (page) => page.text('.park-count .muted');

/** What stands under the slider's own number, and whether the mark is at the end of the rail. @param {Page} page */
const marks = (page) =>
  page.evaluate(() =>
    ['kx', 'ky', 'ktheta'].map((id) => {
      const row = /** @type {Element} */ (document.querySelector(`.park .gain.${id}`));
      return {
        text: row.querySelector('.park-found')?.textContent,
        isBeyond: row.querySelector('.park-mark.is-beyond') !== null,
      };
    }),
  );

pageTest('one walks from the own numbers to those of evolution, and the count follows', async (page) => {
  await page.open('#park');
  await evolved(page, 5);
  const { generation, gains } = bred();
  /** @type {Triple} */
  const own = [5, 5, 5];
  assert.equal(await driver(page), `best robot of generation ${generation}`);
  const shown = gains.map((gain) => ({ text: gain.toFixed(1), isBeyond: false }));
  assert.deepEqual(await marks(page), shown, 'each is on its rail');
  assert.ok(gains[1] > 12, 'one lay beyond it');
  const idle = () => page.evaluate(() => document.querySelector('#park-gains.is-idle') !== null);
  assert.ok(await idle());
  const before = await page.text('.park-table');
  const walkedTo = (/** @type {number} */ share) => {
    const between = gainsBetween(own, /** @type {Triple} */ (gains), share);
    const named = ['kx', 'ky', 'kθ'].map((name, i) => `${name} ${between[i].toFixed(1)}`);
    return { count: parked(between), said: `${named.join(', ')}: ${parked(between)} of 32 parked` };
  };
  const said = () =>
    page.evaluate(() => document.getElementById('park-between')?.getAttribute('aria-valuetext'));
  for (const share of [0, 0.3, 0.5, 0.9]) {
    await slide(page, 'between', share);
    const { count, said: wanted } = walkedTo(share);
    assert.equal(await counted(page), count);
    assert.equal(await said(), wanted);
    assert.equal(await driver(page), `${Math.round(100 * share)} % of the way to evolution’s`);
  }
  await page.focus('#park-between');
  await page.press(Key.ARROW_LEFT);
  await page.until('a key walks', () =>
    document.querySelector('.park-count .muted')?.textContent?.startsWith('89'),
  );
  assert.equal(await said(), walkedTo(0.89).said);
  await page.click('#park-again');
  await counted(page);
  assert.equal(await page.text('.park-table'), before, 'what was walked is no try by hand');
  await slide(page, 'kx', 6);
  assert.equal(await driver(page), 'with your numbers');
  assert.equal(await counted(page), parked([6, 5, 5]));
  assert.ok(!(await idle()));
  assert.deepEqual(await page.obstacles('#park'), []);
});

pageTest('once evolution has gone beyond a slider that goes as far, and a hand parks all', async (page) => {
  await page.open('#park');
  const ends = () =>
    page.evaluate(() =>
      ['kx', 'ky', 'ktheta'].map((id) => document.getElementById(`park-${id}`)?.getAttribute('max')),
    );
  assert.deepEqual(await ends(), ['12', '12', '12']);
  await evolved(page, 5);
  const { gains } = bred();
  const ky = 10 * Math.ceil(gains[1] / 10);
  assert.ok(ky > 12);
  assert.deepEqual(await ends(), ['12', String(ky), '12']);
  assert.ok((await page.text('.park-say')).endsWith(`Now yours goes to ${ky}: try.`));
  assert.equal(await page.text('.ky .park-end'), String(ky));
  const found = gains.map((gain) => Math.round(10 * gain) / 10);
  for (const [i, id] of ['kx', 'ky', 'ktheta'].entries()) await slide(page, id, found[i]);
  assert.equal(await counted(page), 32);
  assert.match(await page.text('.park-say'), /you park 32, now that your slider goes as far/);
  const link = `park=${found}`;
  await page.until('the address has it', (text) => location.hash.includes(text), link);
  await page.open(`#park&v=1&${link}`);
  assert.equal(await counted(page), 32, 'its link opens');
  await slide(page, 'ky', 20);
  assert.deepEqual(await ends(), ['12', String(ky), '12'], 'no slider shrinks under the hand');
});

/** Where a place of the plane is on the picture, in pixels. @param {Page} page @param {{ x: number, y: number }} place */
async function pixel(page, { x, y }) {
  const { width, height } = await page.evaluate(() => {
    const plane = /** @type {Element} */ (document.querySelector('.park-plane'));
    return { width: plane.clientWidth, height: plane.clientHeight };
  });
  const scale = Math.min(width, height) / (2 * (2.83 + 0.45));
  return { x: width / 2 + (x - task.goal.x) * scale, y: height / 2 - (y - task.goal.y) * scale };
}

pageTest(
  'a press on a robot says what became of it, keys go on to the next, and the lab shows it',
  async (page) => {
    await page.open('#park');
    await page.setPace(50);
    for (const [gain, value] of /** @type {const} */ ([
      ['kx', 11.7],
      ['ky', 0.1],
      ['ktheta', 5.2],
    ]))
      await slide(page, gain, value);
    await counted(page);
    const gains = Float64Array.from([11.7, 0.1, 5.2]);
    const ends = starts.map((_, i) => {
      const { x, y, arrived } = simulate(alone(i), gains);
      return { x: x[x.length - 1], y: y[y.length - 1], arrived };
    });
    // Of those that missed, the one that stands most alone.
    const room = ends.map((end, i) =>
      end.arrived
        ? 0
        : Math.min(...ends.map(({ x, y }, j) => (i === j ? 9 : Math.hypot(x - end.x, y - end.y)))),
    );
    const lone = room.indexOf(Math.max(...room));
    await page.drag('.park-plane', [await pixel(page, ends[lone])]);
    const told = () => page.text('#park-told');
    await page.until('it is told', () => document.getElementById('park-told'));
    assert.ok((await told()).startsWith(`Robot ${lone + 1} of 32 missed. After 10 s it is`), await told());
    assert.match(
      await told(),
      /\d\.\d\d m to the side.*; against that, ky asks for −?\d\.\d{3} m\/s and −?\d\.\d{3} rad\/s there\.$/,
    );
    assert.ok((await page.text('.park-side [role="status"]')).startsWith(`${await told()} Start: `));
    assert.deepEqual(await page.obstacles('#park'), []);

    await page.focus('.park-plane');
    await page.press(Key.ARROW_RIGHT);
    const next = (lone + 1) % 32;
    await page.until(
      'the next',
      (text) => document.getElementById('park-told')?.textContent?.startsWith(text),
      `Robot ${next + 1} `,
    );
    await page.press(Key.ESCAPE);
    await page.until('it is closed', () => !document.getElementById('park-told'));
    await page.press(Key.ARROW_RIGHT);
    await page.until('the first', () =>
      document.getElementById('park-told')?.textContent?.startsWith('Robot 1 '),
    );
    const first = simulate(alone(4), gains);
    assert.ok(first.arrived);
    for (let i = 0; i < 4; i++) await page.click('#park-next');
    await page.until('the fifth', () =>
      document.getElementById('park-told')?.textContent?.startsWith('Robot 5 '),
    );
    assert.equal(await told(), `Robot 5 of 32 parked after ${first.finalTime.toFixed(1)} s.`);
    await page.click('#park-previous');
    await page.until('the fourth', () =>
      document.getElementById('park-told')?.textContent?.startsWith('Robot 4 '),
    );

    await page.click('#park-watch');
    await page.until('the lab is open', () => document.body.dataset.open === 'lab');
    await page.until('with these gains', () => {
      const values = ['kx', 'ky', 'ktheta'].map(
        (id) => /** @type {HTMLInputElement} */ (document.getElementById(`gain-${id}`)).value,
      );
      return values.join() === '11.700,0.100,5.200';
    });
    const { cost } = simulate(alone(3), gains);
    await page.until(
      'and its J',
      (text) => document.getElementById('cost')?.textContent?.includes(text),
      cost.total.toFixed(3),
    );
  },
);

pageTest(
  'on a telephone the end is in sight with the picture, and nothing hops while evolution runs',
  async (page) => {
    await page.open('#park');
    await page.evaluate(() => {
      const frame = document.createElement('iframe');
      // Without the bar for scrolling, which a telephone has not.
      Object.assign(frame, {
        src: location.href,
        width: '390',
        height: '844',
        frameBorder: '0',
        scrolling: 'no',
      });
      document.body.append(frame);
    });
    await page.until('the narrow page is ready', () => {
      const inside = document.querySelector('iframe')?.contentDocument;
      return inside?.documentElement?.dataset.ready === 'true' && inside.querySelector('#park-kx') !== null;
    });
    await page.evaluate(() => {
      const inside = /** @type {Document} */ (document.querySelector('iframe')?.contentDocument);
      const slider = /** @type {HTMLInputElement} */ (inside.querySelector('#park-ky'));
      slider.value = '3';
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    });
    await page.until('evolution can begin', () => {
      const inside = document.querySelector('iframe')?.contentDocument;
      const evolve = inside?.querySelector('#park-evolve:not(:disabled)');
      // Of the frame's own kind, not of this page's.
      /** @type {HTMLElement | null | undefined} */ (evolve)?.click();
      return Boolean(evolve);
    });
    const heights = await page.until('evolution has come to its end', () => {
      const inside = /** @type {Document} */ (document.querySelector('iframe')?.contentDocument);
      const known = /** @type {{ heights?: Set<number> }} */ (/** @type {unknown} */ (window));
      known.heights ??= new Set();
      known.heights.add(inside.querySelector('.park-count')?.getBoundingClientRect().height ?? 0);
      return inside.querySelector('#park-lesson') && [...known.heights];
    });
    assert.equal(heights.length, 1, String(heights));
    await page.until('all of the end is in sight', () => {
      const inside = /** @type {Document} */ (document.querySelector('iframe')?.contentDocument);
      const shown = ['.park-plane', '.park-table', '#park-between', '#park-lesson', '#park-lab'];
      const boxes = shown.map((one) => inside.querySelector(one)?.getBoundingClientRect());
      return boxes.every((box) => box && box.top >= -1 && box.bottom <= 845);
    });
  },
);
