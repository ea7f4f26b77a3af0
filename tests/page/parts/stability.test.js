// The Lyapunov function beside the robot: what is read and drawn is what the core computes, and what it means is said.
import assert from 'node:assert/strict';
import { layoutOf } from '../../../www/parts/curves/stability/layout.js';
import { amount, amounts } from '../../../www/parts/curves/stability/words/en.js';
import { Key, pageTest } from '../harness/browsers.js';
import { experiment, paperGains, simulate, stability } from '../harness/core.js';
import { coloured, numberOf, pixelsOf, textOf } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../pkg/ep_locomotion.js').Stability} Stability */

const velocityLimits = experiment('velocity-limits');
const unlimited = experiment({ limits: { speed: null, turnRate: null } });
const tracking = { linear: 0.5, angular: 0.3 };
const free = 'limits.speed=off&limits.turnRate=off';
const moving = 'referenceVelocity.linear=0.5&referenceVelocity.angular=0.3';
const [ep, arbitrary] = ['ep', 'arbitrary'].map((method) =>
  stability(velocityLimits, paperGains('velocity-limits', /** @type {'ep' | 'arbitrary'} */ (method))),
);

/** Opens the view, the robots at rest at the end. @param {Page} page @param {string} rest */
async function open(page, rest) {
  await page.open(`#curves&v=1&view=stability&${rest}`);
  await page.focus('#scrub');
  await page.press(Key.END);
}

const ids = ['lyapunov', 'rate', 'promised', 'x', 'y', 'theta'];
/** What stands over each number, and the number. @param {Page} page */
async function readout(page) {
  const texts = await Promise.all(ids.map((id) => textOf(page, `#stability-readout > .${id}`)));
  const pairs = texts.map((text) => text.split('\n').map((line) => line.trim()));
  return { terms: pairs.map(([term]) => term), values: pairs.map(([, value]) => value) };
}

/** @param {Stability} run @param {number} i */
const ratesAt = (run, i) => {
  const parts = [run.promisedX[i], run.promisedY[i], run.promisedTheta[i]];
  return [run.rate[i], parts[0] + parts[1] + parts[2], ...parts];
};

/** What has to be read at a sample. @param {Stability} run @param {number} i */
const expected = (run, i) => [amount(run.lyapunov[i]), ...amounts(ratesAt(run, i))];

/** @param {Page} page @param {Stability} driving @param {Stability[]} others @param {boolean} [isLog] */
async function layoutOn(page, driving, others, isLog = false) {
  const size = await page.until('the picture has its size', async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const { clientWidth: width, clientHeight: height } = /** @type {HTMLElement} */ (
      document.getElementById('stability-picture')
    );
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('stability-lines'));
    const isDrawn = [
      canvas.width - width * devicePixelRatio,
      canvas.height - height * devicePixelRatio,
    ].every((difference) => Math.abs(difference) <= 1);
    return isDrawn && { width, height };
  });
  return layoutOf(size, driving, others, isLog);
}

/** Red, green, blue and alpha of places of the picture. @param {Page} page @param {{ x: number, y: number }[]} places */
const pixelsAt = (page, places) =>
  page.evaluate((all) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('stability-lines'));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    return all.map(({ x, y }) => {
      const [left, top] = [x, y].map((place) => Math.round(place * devicePixelRatio));
      return [...context.getImageData(left, top, 1, 1).data];
    });
  }, places);

/** @param {Page} page */
const note = (page) => textOf(page, '#stability-note');

pageTest('at the cursor V, its rate and the three parts of the law are those of the core', async (page) => {
  await open(page, 'drives=paper-ep');
  const { terms, values } = await readout(page);
  assert.deepEqual(terms, ['V', 'V̇ robot', 'V̇ law =', '−kx xe² cos² θe', '− ky ye⁴', '− kθ sin² θe']);
  const last = ep.time.length - 1;
  assert.deepEqual(values, expected(ep, last));
  await page.press(Key.HOME);
  for (const steps of [0, 30, 90]) {
    await page.press(...Array(steps).fill(Key.ARROW_RIGHT));
    const i = { 0: 0, 30: 30, 90: 120 }[steps] ?? 0;
    const read = (await readout(page)).values;
    assert.deepEqual(read, expected(ep, i), `sample ${i}`);
    const [, rate, law, ...parts] = read.map(numberOf);
    const sum = parts.reduce((a, b) => a + b, 0);
    assert.ok(Math.abs(sum - law) < 0.02 * Math.abs(law), `${parts.join(' + ')} is not ${law}`);
    // Up to 1.14 s the robot is told to drive faster than it can.
    assert.equal(Math.abs(rate - law) < 1e-3, ep.limited[i] === 0, `sample ${i}`);
  }
  assert.match(
    await note(page),
    /^V falls all the way, from 4\.29 to 0\.00125\. Under the bar on top: for 1\.14 s limits cut the command, and V̇ robot is not V̇ law\.$/,
  );
  assert.deepEqual(await page.problems(), []);
  assert.deepEqual(await page.obstacles(), []);
});

for (const isLog of [false, true])
  pageTest(
    `V, the parts and the rate are where the core has them, ${isLog ? 'also logarithmic' : 'linear'}`,
    async (page) => {
      await open(page, 'drives=paper-ep');
      if (isLog) {
        await page.click('#stability-log');
        await page.until('the link says so', () => location.hash.includes('scale=log'));
      }
      const { time, lyapunov, rate } = await layoutOn(page, ep, [arbitrary], isLog);
      const scaled = (/** @type {Float64Array} */ values) => (/** @type {number} */ i) =>
        isLog ? values[i] / ep.lyapunov[i] : values[i];
      const [own, promised] = [scaled(ep.rate), scaled(ep.promisedX)];
      const samples = [10, 25, 45, 65, 80, 95];
      const at = (/** @type {(i: number) => number} */ value, /** @type {typeof rate} */ axes) =>
        samples.map((i) => ({ x: time(ep.time[i]), y: axes.y(value(i)), token: '--ink' }));
      const lines = { V: at((i) => ep.lyapunov[i], lyapunov), rate: at(own, rate) };
      for (const [name, points] of Object.entries(lines)) {
        const found = await coloured(page, '#stability-lines', points);
        assert.ok(found >= samples.length - 1, `${name}: ${found} of ${samples.length}`);
        const wrong = points.map((point) => ({ ...point, y: point.y - 14 }));
        assert.ok((await coloured(page, '#stability-lines', wrong)) <= 1, `${name} is elsewhere too`);
      }
      // Where limits cut the command a bar says so, on top.
      const top = samples.map((i) => ({ x: time(ep.time[i]), y: lyapunov.frame.top + 1, token: '--muted' }));
      assert.equal(
        await coloured(page, '#stability-lines', top),
        samples.filter((i) => ep.limited[i]).length,
      );
      // Between the robot's rate and what x_e promises there is blue.
      const tint = await pixelsAt(
        page,
        samples.map((i) => ({ x: time(ep.time[i]) + 3, y: rate.y((promised(i) + own(i)) / 2) })),
      );
      for (const [red, , blue] of tint) assert.ok(blue - red > 25, `${red} red and ${blue} blue`);
      assert.deepEqual(await page.obstacles(), []);
    },
  );

pageTest('without limits the robot does what the law promises', async (page) => {
  const run = stability(unlimited, [3, 1, 5]);
  await open(page, `${free}&drives=hand&gains=3,1,5`);
  assert.match(
    await note(page),
    /^V falls all the way, from 4\.29 to 0\.00124\. No limit cuts the command: V̇ robot is V̇ law\.$/,
  );
  await page.press(Key.HOME, ...Array(20).fill(Key.ARROW_RIGHT));
  const { values } = await readout(page);
  assert.deepEqual(values, expected(run, 20));
  assert.equal(values[1], values[2]);
  assert.equal(await pixelsOf(page, '#stability-lines', '--error'), 0);
});

pageTest('where the law would divide by 0 nothing is promised, and it is said', async (page) => {
  await open(page, `${free}&drives=hand&gains=3,8,5&start=2,1,45deg`);
  assert.match(await note(page), /No limit cuts the command, but .* guarded: there V̇ robot is not V̇ law\./);
  // Its numbers are large, and none is cut off at the left.
  const [cut, drawn] = await page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('stability-lines'));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    return [1, canvas.width].map((width) =>
      context.getImageData(0, 0, width, canvas.height).data.some((value, i) => i % 4 === 3 && value > 0),
    );
  });
  assert.deepEqual([cut, drawn], [false, true]);
});

pageTest('the cursor is the robots’ clock, both ways', async (page) => {
  await open(page, 'drives=paper-ep');
  const { time } = await layoutOn(page, ep, [arbitrary]);
  await page.drag('#stability-picture', [
    { x: time(0.4), y: 60 },
    { x: time(1.2), y: 160 },
  ]);
  const [now] = (await textOf(page, '#clock')).split(' ').map(Number);
  assert.ok(Math.abs(now - 1.2) <= 0.011, `dragged to ${now} s`);
  assert.deepEqual((await readout(page)).values, expected(ep, Math.round(100 * now)));
});

pageTest('a gain below zero is moved here, and V rises in sight', async (page) => {
  await open(page, 'drives=paper-ep');
  assert.equal(await pixelsOf(page, '#stability-lines', '--error'), 0);
  const [kx, , ktheta] = paperGains('velocity-limits', 'ep');
  await page.focus('#gain-ky');
  await page.press('-', '1', Key.ENTER);
  await page.until('the hand drives', () =>
    document.getElementById('stability-note')?.textContent?.includes('ky is negative'),
  );
  const run = stability(velocityLimits, [kx, -1, ktheta]);
  const rising = run.lyapunov.reduce((sum, value, i) => sum + (value < run.lyapunov[i + 1] ? 0.01 : 0), 0);
  const said = await note(page);
  assert.match(said, /The part of yₑ is above zero, because ky is negative: the law itself drives V up\./);
  const told = /rises \(thick, marked below\) for ([\d.]+) of 10\.00 s/.exec(said);
  assert.ok(Math.abs(Number(told?.[1]) - rising) < 0.02, `${told?.[1]} s, not ${rising}`);
  assert.ok((await pixelsOf(page, '#stability-lines', '--error')) > 200);

  await page.focus('#scrub');
  await page.press(Key.END);
  const { values } = await readout(page);
  assert.deepEqual(values, expected(run, run.time.length - 1));
  assert.ok(numberOf(values[4]) > 0);
  // Its area stands on the zero line.
  const { time, rate } = await layoutOn(page, run, []);
  const [above, below] = await pixelsAt(
    page,
    [12, -8].map((up) => ({ x: time(9.5), y: rate.y(0) - up })),
  );
  assert.ok(above[0] - above[2] > 25, `above zero: ${above}`);
  assert.ok(below[0] - below[2] < 15, `below zero: ${below}`);
  assert.deepEqual(await page.problems(), []);
  assert.deepEqual(await page.obstacles(), []);
});

pageTest('Kanayama’s rule cannot park, and its own function says why', async (page) => {
  await open(page, 'law=kanayama&drives=hand&gains=3,2,5');
  const run = stability({ ...velocityLimits, law: 'kanayama' }, [3, 2, 5]);
  const last = run.time.length - 1;
  const { terms, values } = await readout(page);
  assert.deepEqual(terms.slice(3), ['−kx x²', '+ 0', '− vr kθ/ky sin² θe']);
  assert.deepEqual(values, expected(run, last));
  assert.ok(run.lyapunov[last] > 2 && Math.abs(run.rate[last]) < 1e-12);
  assert.match(
    await note(page),
    /V never rises: it goes from 4\.15 to 2\.15\..*only x, how far the goal is ahead, is in V̇/,
  );

  await page.focus('#gain-ky');
  await page.press('0', Key.ENTER);
  await page.until('nothing is promised', () =>
    document.getElementById('stability-note')?.textContent?.includes('promises nothing unless ky > 0'),
  );
  await page.focus('#scrub');
  await page.press(Key.END);
  const unproved = stability({ ...velocityLimits, law: 'kanayama' }, [3, 0, 5]);
  const read = (await readout(page)).values;
  assert.deepEqual(read.slice(2), ['–', '–', '–', '–']);
  assert.equal(read[0], amount(unproved.lyapunov[unproved.time.length - 1]));
  assert.deepEqual(await page.problems(), []);
  assert.deepEqual(await page.obstacles(), []);
});

pageTest('both laws track a moving reference, one of them pinned', async (page) => {
  const pin = ['kanayama', '3,10,5', 'law:kanayama', ...moving.replaceAll('=', ':').split('&')].join('~');
  await open(page, `${moving}&drives=hand&gains=3,1,5&scale=log&pin1=${encodeURIComponent(pin)}`);
  const [own, pinned] = /** @type {const} */ ([
    ['shim-kim', [3, 1, 5]],
    ['kanayama', [3, 10, 5]],
  ]).map(([law, gains]) => stability({ ...velocityLimits, law, referenceVelocity: tracking }, [...gains]));
  const last = own.time.length - 1;
  assert.deepEqual((await readout(page)).values, expected(own, last));
  assert.ok(pinned.lyapunov[last] < 1e-9 && own.lyapunov[last] > 1e-3);
  assert.ok((await pixelsOf(page, '#stability-lines', '--pin-1')) > 30);
  assert.match(
    await note(page),
    /Between two samples V can rise though V̇ is below zero at both: a command is held for 0\.01 s\./,
  );
});

pageTest('V and its rate can be read as a table', async (page) => {
  await open(page, 'drives=paper-ep');
  await page.click('#stability-table');
  const [head, ...rows] = await page.evaluate(() =>
    [.../** @type {HTMLTableElement} */ (document.getElementById('table-rows')).rows].map((row) =>
      [...row.cells].map((cell) => cell.innerText),
    ),
  );
  assert.equal(head.length, 11);
  assert.equal(rows.length, 39);
  const run = simulate(velocityLimits, paperGains('velocity-limits', 'ep'));
  for (const n of [0, 10, 20, 38]) {
    const i = Math.min(5 * n, run.time.length - 1);
    const [rate, law, ...parts] = ratesAt(ep, i);
    assert.deepEqual(rows[n], [
      run.time[i].toFixed(2),
      ...[ep.errorX[i], ep.errorY[i]].map(amount),
      ((ep.errorTheta[i] * 180) / Math.PI).toFixed(2).replace('-', '−'),
      ...[ep.lyapunov[i], ...parts, law, rate].map(amount),
      ep.limited[i] ? 'yes' : '',
    ]);
  }
  assert.deepEqual(await page.obstacles(), []);
});
