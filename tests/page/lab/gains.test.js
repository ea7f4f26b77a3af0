import assert from 'node:assert/strict';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { evolve, experiment, paperGains, shown, shownGains, simulate } from '../harness/core.js';
import { read } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** What a J that is shown comes to: with its digits in groups, or a power of ten. @param {string} text */
const numberIn = (text) => {
  if (text === '∞') return Number.POSITIVE_INFINITY;
  const power = Array.from(/10([⁰¹²³⁴⁵⁶⁷⁸⁹]+)$/.exec(text)?.[1] ?? '', (letter) =>
    '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(letter),
  );
  return Number(text.replace(/×.*|\u202f/g, '')) * 10 ** Number(power.join(''));
};
/** @typedef {import('../harness/core.js').Gains} Gains */

const velocityLimits = experiment('velocity-limits');
const ep = paperGains('velocity-limits', 'ep');
const arbitrary = paperGains('velocity-limits', 'arbitrary');

/** Who drives, with what, and at what cost. @param {Page} page */
async function readDriver(page) {
  const { driver, gains, cost } = await read(page);
  return { driver, gains, cost };
}

/** @param {string} driver @param {Gains} gains */
const expected = (driver, gains) => ({
  driver,
  gains: shownGains(gains),
  cost: shown(simulate(velocityLimits, gains).cost.total),
});

/** Types into a field over what it holds. @param {Page} page @param {string} id @param {string} text */
async function type(page, id, text) {
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.focus(`#${id}`);
  await page.press(...(text === '' ? [Key.BACK_SPACE] : text), Key.ENTER);
}

/** What is said about a gain's field once it is drawn, and whether it is said beside it. @param {Page} page @param {string} gain */
const complaint = (page, gain) =>
  page.evaluate(async (id) => {
    const [field, message] = [`gain-${id}`, `gain-${id}-error`].map((one) => document.getElementById(one));
    if (!field || !message) throw new Error(`${id} has no field or no message`);
    const [at, said] = [field, message].map((one) => one.getBoundingClientRect());
    const distance = Math.max(said.top - at.bottom, at.top - said.bottom);
    return {
      text: message.checkVisibility() ? message.innerText : '',
      name: document.querySelector(`label[for=gain-${id}]`)?.textContent ?? '',
      isBeside: Math.abs(distance) < 24 && field.getAttribute('aria-describedby') === message.id,
      isInvalid: field.getAttribute('aria-invalid') === 'true',
    };
  }, gain);

pageTest('a gain is copied with all its digits, and pasted it drives to the same J', async (page) => {
  await page.open('#lab&generation=100');
  const { gains } = evolve(velocityLimits, 100);
  /** What is copied of a field, of which that is selected. @param {string} gain @param {number} [from] */
  const copied = (gain, from = 0) =>
    page.evaluate(
      (id, start) => {
        const field = /** @type {HTMLInputElement} */ (document.getElementById(`gain-${id}`));
        field.focus();
        if (start > 0) field.setSelectionRange(start, field.value.length);
        const clipboardData = new DataTransfer();
        const event = new ClipboardEvent('copy', { clipboardData, cancelable: true, bubbles: true });
        // What nobody gives it, it copies as it always does.
        return field.dispatchEvent(event) ? String(getSelection()) : clipboardData.getData('text/plain');
      },
      gain,
      from,
    );
  const texts = [await copied('kx'), await copied('ky'), await copied('ktheta')];
  assert.deepEqual(texts, gains.map(String));
  assert.notEqual(await copied('ky', 2), texts[1], 'a part of it');
  for (const [i, gain] of ['kx', 'ky', 'ktheta'].entries()) await type(page, `gain-${gain}`, texts[i]);
  const { driver, cost } = await readDriver(page);
  assert.deepEqual(
    { driver, cost },
    { driver: 'hand', cost: shown(simulate(velocityLimits, gains).cost.total) },
  );
  await type(page, 'gain-ky', '6.97e-5');
  assert.equal(await copied('ky'), '0.0000697');
});

pageTest('each driver shows its gains and their J', async (page) => {
  const evolved = evolve(velocityLimits);
  assert.deepEqual(await readDriver(page), { driver: 'evolved', ...evolved.shown });
  await page.click('#drives-paper-ep');
  assert.deepEqual(await readDriver(page), expected('paper-ep', ep));
  await page.click('#drives-paper-arbitrary');
  assert.deepEqual(await readDriver(page), expected('paper-arbitrary', arbitrary));
  await page.click('#drives-hand');
  assert.deepEqual(await readDriver(page), expected('hand', arbitrary));
  await page.click('#drives-evolved');
  assert.deepEqual(await readDriver(page), { driver: 'evolved', ...evolved.shown });
});

pageTest("the paper's gains cost what they are known to cost, the sum of the parts shown", async (page) => {
  for (const [preset, driver, known] of [
    ['velocity-limits', 'paper-ep', '7.935'],
    ['velocity-limits', 'paper-arbitrary', '9.016'],
    ['acceleration-limits', 'paper-ep', '8.271'],
  ]) {
    await page.click(`#preset-${preset}`);
    await page.click(`#drives-${driver}`);
    assert.equal((await read(page)).cost, known, `${driver} under ${preset}`);
    const parts = await page.evaluate(() =>
      [...document.querySelectorAll('#cost-parts .cost-value')].map((value) =>
        Number(/** @type {HTMLElement} */ (value).innerText),
      ),
    );
    assert.equal(parts.length, 5);
    const sum = parts.reduce((total, part) => total + part, 0);
    // Each part is rounded to two digits, J to three.
    assert.ok(Math.abs(sum - Number(known)) < 5 * 0.005 + 0.001, `J ${known}, parts ${parts}`);
  }
});

engineTest('a slider takes over by hand from the gains that are shown, and they are kept', async (page) => {
  await page.click('#drives-paper-ep');
  await page.focus('#slider-kx');
  await page.press(Key.ARROW_RIGHT);
  const moved = await readDriver(page);
  const kx = Number(moved.gains[0]);
  assert.ok(kx > ep[0] && kx < ep[0] + 0.1, `kx went from ${ep[0]} to ${kx}`);
  assert.deepEqual(moved, expected('hand', [kx, ep[1], ep[2]]));

  await page.focus('#slider-ktheta');
  await page.press(Key.ARROW_LEFT);
  const again = await readDriver(page);
  const ktheta = Number(again.gains[2]);
  assert.ok(ktheta < ep[2], `kθ went from ${ep[2]} to ${ktheta}`);
  assert.deepEqual(again, expected('hand', [kx, ep[1], ktheta]));

  await page.click('#drives-evolved');
  await page.click('#drives-hand');
  assert.deepEqual(await readDriver(page), again);
});

pageTest('whoever drives by hand finds the gains beside every part that drives', async (page) => {
  const inSight = (/** @type {boolean} */ wanted) =>
    page.until(
      `sliders ${wanted}`,
      (yes) => document.getElementById('gains')?.checkVisibility() === yes,
      wanted,
    );
  for (const part of ['curves', 'landscape', 'robustness', 'disturbance']) {
    await page.resize(1366, 768);
    await page.open(`#${part}`);
    await inSight(false);
    await page.click('#drives-hand');
    await inSight(true);
    for (const [width, height] of /** @type {const} */ ([
      [1366, 768],
      [1280, 720],
    ])) {
      await page.resize(width, height);
      await page.until(
        `nothing of ${part} lies below a page of ${width}`,
        () => document.documentElement.scrollHeight <= innerHeight,
      );
    }
    assert.deepEqual(await page.obstacles(), []);
    const kx = () =>
      page.evaluate(() => Number(/** @type {HTMLInputElement} */ (document.getElementById('gain-kx')).value));
    const before = await kx();
    await page.focus('#slider-kx');
    await page.press(Key.ARROW_RIGHT);
    assert.ok((await kx()) > before, part);
  }
  assert.deepEqual(await page.problems(), []);
});

engineTest('a slider that is dragged near 0 is caught there, and the keys leave it again', async (page) => {
  await page.click('#drives-paper-ep');
  const { width, height, low, high } = await page.evaluate(() => {
    const slider = /** @type {HTMLInputElement} */ (document.getElementById('slider-ky'));
    const box = slider.getBoundingClientRect();
    return { width: box.width, height: box.height, low: Number(slider.min), high: Number(slider.max) };
  });
  const radius = 8;
  const thumb = (/** @type {number} */ ky) => ({
    x: radius + ((width - 2 * radius) * (ky - low)) / (high - low),
    y: height / 2,
  });
  await page.drag('#slider-ky', [thumb(ep[1]), thumb(4), thumb(0.07)]);
  assert.equal((await readDriver(page)).gains[1], '0.000');
  await page.focus('#slider-ky');
  await page.press(Key.ARROW_RIGHT);
  assert.equal((await readDriver(page)).gains[1], '0.010');
});

pageTest('a gain that is no number is refused beside its field, and what drove goes on', async (page) => {
  const before = await read(page);
  for (const [gain, text] of [
    ['kx', 'abc'],
    ['kx', ''],
    ['ky', '1e999'],
    ['ktheta', '-1e999'],
    ['ktheta', '3.5.1'],
  ]) {
    await type(page, `gain-${gain}`, text);
    const { cost, driver } = await read(page);
    const said = await complaint(page, gain);
    assert.ok(said.name !== '' && said.text.includes(said.name), `${said.name} is not named: ${said.text}`);
    assert.ok(said.isBeside && said.isInvalid, `${gain}: ${JSON.stringify(said)}`);
    assert.deepEqual({ cost, driver }, { cost: before.cost, driver: before.driver });
  }

  await type(page, 'gain-ktheta', '3.5');
  const { text, isInvalid } = await complaint(page, 'ktheta');
  assert.deepEqual({ text, isInvalid }, { text: '', isInvalid: false });
  const [kx, ky] = evolve(velocityLimits).gains;
  assert.deepEqual(await readDriver(page), expected('hand', [kx, ky, 3.5]));
});

pageTest('gains of every finite size drive at their J or are refused, and the page goes on', async (page) => {
  const [kx, ky, ktheta] = evolve(velocityLimits).gains;
  let shownBefore = (await read(page)).cost;
  for (const text of ['-2', '4000', '-1e12', '1e308']) {
    await type(page, 'gain-ky', text);
    const { cost, gains } = await read(page);
    const refused = (await complaint(page, 'ky')).text !== '';
    const { total } = simulate(velocityLimits, [kx, Number(text), ktheta]).cost;
    if (refused) assert.equal(cost, shownBefore);
    else {
      assert.equal(Number(gains[1]), Number(text));
      // Large costs are shown with fewer digits.
      const [read, wanted] = [numberIn(cost), total];
      assert.ok(
        read === wanted || Math.abs(read - wanted) <= 0.005 * wanted,
        `${text}: ${cost}, not ${total}`,
      );
    }
    shownBefore = cost;
  }
  await type(page, 'gain-ky', String(ky));
  assert.deepEqual(await readDriver(page), expected('hand', [kx, ky, ktheta]));
});

pageTest('what is being typed is not overwritten by what evolution finds', async (page) => {
  // It does not pause by itself, at generation 100, before two generations are seen.
  await page.setPace(0.2);
  await page.click('#run');
  await page.focus('#gain-kx');
  await page.press('4');
  const before = Number((await read(page)).generation);
  await page.until(
    'two generations have passed',
    (from) => Number(document.getElementById('generation')?.innerText) >= from + 2,
    before,
  );
  await page.press('2', Key.ENTER);
  const { driver, gains } = await read(page);
  assert.deepEqual([driver, gains[0]], ['hand', '42.000']);
});

pageTest('a hand is asked to beat the one that is dotted', async (page) => {
  const beaten = async () => {
    await page.click('#drives-evolved');
    await page.click('#drives-hand');
    return /([\d.]+)\?$/.exec(await page.text('#gains-note'))?.[1];
  };
  assert.equal(await beaten(), shown(simulate(velocityLimits, ep).cost.total));
  assert.match(await page.text('#legend .dashed'), /paper’s EP/);
  await page.click('#one-generation');
  assert.equal(await beaten(), evolve(velocityLimits, 1).shown.cost);
  assert.match(await page.text('#legend .dashed'), /best of generation 1/);
});

pageTest(
  'what corrects a gain that was refused is typed to its end while evolution goes on',
  async (page) => {
    await page.focus('#gain-kx');
    await page.press('a', 'b', 'c', Key.ENTER);
    await page.until('it is refused', () => document.getElementById('gain-kx-error')?.checkVisibility());
    await page.press('3');
    // Its button would take the focus.
    await page.evaluate(() => {
      for (let i = 0; i < 5; i += 1) document.getElementById('one-generation')?.click();
    });
    await page.press('.', '5', Key.ENTER);
    await page.until('they drive', () => !document.getElementById('gain-kx-error')?.checkVisibility());
    assert.equal((await read(page)).gains[0], '3.500');
  },
);
