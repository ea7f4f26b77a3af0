import assert from 'node:assert/strict';
import * as en from '../../../www/words/en/index.js';
import * as ko from '../../../www/words/ko/index.js';
import { rows } from '../../../www/settings/table.js';
import { Key, pageTest } from '../harness/browsers.js';
import { evolve, experiment, fields, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';
import { assertBegun, openGroup, openSettings, setting, summary, type } from '../harness/panel.js';
import { middleOf, read } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/core.js').Experiment} Experiment */

const velocityLimits = experiment('velocity-limits');
/** @param {[number, number, number]} final @returns {Experiment} */
const weighing = (final) => ({ ...velocityLimits, weights: { ...velocityLimits.weights, final } });

/** Drags the knob of a slider by some pixels, in steps. @param {Page} page @param {string} id @param {number} from The share of the slider where its knob is. @param {number} dx */
async function slide(page, id, from, dx) {
  const { width, y } = await page.evaluate((name) => {
    const { width, height } = /** @type {HTMLElement} */ (
      document.getElementById(name)
    ).getBoundingClientRect();
    return { width, y: height / 2 };
  }, id);
  const x = 9 + from * (width - 18);
  await page.drag(
    `#${id}`,
    [0, 0.25, 0.5, 0.75, 1].map((part) => ({ x: x + part * dx, y })),
    // So slowly that frames come between, late ones too.
    400,
  );
}

test('every field has its name and its help, and every word its text, in every language', () => {
  for (const [language, { settings }] of Object.entries({ en, ko })) {
    const wants = (/** @type {string} */ path) => `${path} in www/words/${language}/settings.js`;
    const known =
      /** @type {Record<string, { name: string, help: string, choices?: Record<string, string> }>} */ (
        settings.settings
      );
    for (const { path } of rows) assert.ok(known[path]?.name && known[path].help, wants(path));
    for (const { path, words } of wordFields())
      assert.deepEqual(Object.keys(known[path]?.choices ?? {}).sort(), [...words].sort(), wants(path));
  }
});

test('every field of an experiment has a row', () => {
  const paths = rows.map(({ path }) => path);
  const general = new Set(paths.map((path) => path.replace(/\[\d\]/, '[]')));
  for (const { path } of [...fields(), ...wordFields()])
    assert.ok(general.has(path), `${path} has no row in www/settings/table.js`);
  for (const [list, length] of /** @type {const} */ ([
    ['weights.final', 3],
    ['weights.velocity', 2],
    ['evolution.initialRange', 2],
  ]))
    assert.equal(paths.filter((path) => path.startsWith(list)).length, length, list);
});

pageTest('every row is drawn, with its unit and range', async (page) => {
  await openSettings(page);
  for (const group of ['task', 'arrival', 'law', 'disturbance', 'evolution', 'method'])
    await openGroup(page, group);
  const drawn = await page.evaluate(() =>
    [...document.querySelectorAll('.setting')].map((row) => {
      const field = /** @type {HTMLInputElement} */ (row.querySelector('input[type=text], select'));
      const describedBy = field.getAttribute('aria-describedby')?.split(' ') ?? [];
      const help = describedBy.map((id) => document.getElementById(id)?.textContent).join('');
      return {
        isSeen: field.checkVisibility() && field.getBoundingClientRect().width > 60,
        label: field.labels?.[0]?.querySelector('.name')?.textContent ?? '',
        value: field.value,
        help,
      };
    }),
  );
  assert.equal(drawn.length, rows.length);
  assert.equal(new Set(drawn.map(({ label }) => label)).size, rows.length, 'two rows have the same name');
  for (const { isSeen, label, value, help } of drawn) {
    assert.ok(
      isSeen && (value !== '' || /cceleration|^(Speed|Turn rate) tolerance/.test(label)),
      `${label}: ${value}`,
    );
    assert.ok(help.startsWith(`${label}: `), `${label}: ${help}`);
  }
  const helpOf = (/** @type {string} */ name) => drawn.find(({ label }) => label === name)?.help ?? '';
  assert.match(helpOf('Horizon'), /from 0\.00001 s to 100000 s/);
  assert.match(helpOf('Turn rate'), /from 0°\/s to 57295800°\/s/);
  assert.match(helpOf('Population'), /a whole number from 1 to 2000/);
  assert.deepEqual(await page.obstacles(), []);
});

pageTest('a weight that is dragged changes J at every step, and the landscape follows', async (page) => {
  await page.open('#landscape');
  await openSettings(page);
  const fine = () =>
    page.until('the fine landscape is drawn', () =>
      document.getElementById('landscape-note')?.textContent?.startsWith('16\u202f384 drives'),
    );
  const picture = () =>
    page.evaluate(() =>
      /** @type {HTMLCanvasElement} */ (document.getElementById('landscape-picture')).toDataURL(),
    );
  await fine();
  const before = { picture: await picture(), cost: await page.text('#cost-total') };
  await page.evaluate(() => {
    const seen = /** @type {{ seen: string[] }} */ (/** @type {unknown} */ (window));
    seen.seen = [];
    new MutationObserver(() =>
      seen.seen.push(document.getElementById('cost-total')?.textContent ?? ''),
    ).observe(/** @type {HTMLElement} */ (document.getElementById('cost-total')), {
      childList: true,
      characterData: true,
      subtree: true,
    });
  });
  await slide(page, 'setting-weights-velocity-0-slider', 0.5, 40);
  const { value, back } = await setting(page, 'weights-velocity-0');
  assert.ok(Number(value) > 1, value);
  assert.equal(back, 'Driving fast: back to 1');
  const weights = {
    ...velocityLimits.weights,
    velocity: /** @type {[number, number]} */ ([Number(value), 1]),
  };
  assert.equal(await page.text('#cost-total'), evolve({ ...velocityLimits, weights }).shown.cost);
  const seen = await page.evaluate(
    () => /** @type {{ seen: string[] }} */ (/** @type {unknown} */ (window)).seen.length,
  );
  assert.ok(seen >= 2, `J was shown ${seen} times during the drag`);
  await page.until(
    'another landscape is drawn',
    (old) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('landscape-picture'));
      return (
        document.getElementById('landscape-note')?.textContent?.startsWith('16\u202f384 drives') &&
        canvas.toDataURL() !== old
      );
    },
    before.picture,
  );

  // The whole drag is one step back.
  await page.click('#settings-undo');
  assert.deepEqual(await summary(page), {
    button: 'Settings',
    changed: 'As in the preset',
    isPresetOffered: false,
    canUndo: false,
    canRedo: true,
  });
  assert.equal(await page.text('#cost-total'), before.cost);
});

pageTest(
  'a typed value drives at once; nonsense and values out of range are refused by name',
  async (page) => {
    await openSettings(page);
    await type(page, 'weights-final-2', '5');
    await assertBegun(page, weighing([1, 1, 5]));
    await type(page, 'limits-turnRate', '180');
    const turnRate = Math.PI;
    const limited = { ...weighing([1, 1, 5]), limits: { ...velocityLimits.limits, turnRate } };
    await assertBegun(page, limited);

    await type(page, 'weights-final-2', 'heavy');
    assert.deepEqual(await setting(page, 'weights-final-2'), {
      value: 'heavy',
      isEnabled: true,
      error: 'Final heading must be a number from 0 to 1000000; it was “heavy”.',
      back: 'Final heading: back to 1',
    });
    await assertBegun(page, limited);
    await openGroup(page, 'arrival');
    await type(page, 'tolerance-heading', '-1');
    assert.match(
      (await setting(page, 'tolerance-heading')).error,
      /^Heading tolerance must be a number from 0° to /,
    );
    // Only one at a time: the other field shows again what drives.
    assert.deepEqual(
      [(await setting(page, 'weights-final-2')).value, (await setting(page, 'weights-final-2')).error],
      ['5', ''],
    );
    await openGroup(page, 'evolution');
    await type(page, 'evolution-population', '7.5');
    assert.match(
      (await setting(page, 'evolution-population')).error,
      /a whole number from 1 to 2000; it was “7.5”/,
    );

    // What the core refuses, it says in the names on screen.
    await type(page, 'evolution-initialRange-1', '0');
    assert.match(
      (await setting(page, 'evolution-initialRange-1')).error,
      /^First gains from … to must be \[low, high\]/,
    );
    await type(page, 'sampleTime', '0.00001');
    assert.match(
      (await setting(page, 'sampleTime')).error,
      /^Horizon must be at most 100000 times Sample time/,
    );
    await assertBegun(page, limited);
    await type(page, 'evolution-population', '8');
    await assertBegun(page, { ...limited, evolution: { ...limited.evolution, population: 8 } });
  },
);

pageTest('limits are switched off and on', async (page) => {
  await openSettings(page);
  await page.click('#setting-limits-speed-on');
  assert.equal((await setting(page, 'limits-speed')).isEnabled, false);
  await assertBegun(page, { ...velocityLimits, limits: { ...velocityLimits.limits, speed: null } });
  await page.click('#setting-limits-speed-on');
  await assertBegun(page, velocityLimits);
  // Off in this preset: it gets the limit of the other one.
  await page.click('#setting-limits-turnAcceleration-on');
  assert.equal((await setting(page, 'limits-turnAcceleration')).value, '900');
  const { turnAcceleration } = experiment('acceleration-limits').limits;
  await assertBegun(page, { ...velocityLimits, limits: { ...velocityLimits.limits, turnAcceleration } });
  assert.equal((await setting(page, 'limits-turnAcceleration')).back, 'Turn acceleration: back to no limit');
  // Back to none its field cannot have the focus any more.
  await page.click('.setting:has(#setting-limits-turnAcceleration) .back');
  await page.until(
    'what switches it has the focus',
    () => document.activeElement?.id === 'setting-limits-turnAcceleration-on',
  );
});

pageTest('what is changed is seen, and goes back one by one or all together', async (page) => {
  const { gains } = await read(page);
  await openSettings(page);
  await openGroup(page, 'law');
  await openGroup(page, 'disturbance');
  await type(page, 'weights-final-0', '3');
  await page.click('#setting-law option[value="kanayama"]');
  assert.equal((await setting(page, 'disturbance-linear')).isEnabled, false);
  await page.click('#setting-disturbance-kind option[value="slip"]');
  // Without a disturbance its size would change nothing, and cannot be typed.
  assert.equal((await setting(page, 'disturbance-linear')).isEnabled, true);
  await type(page, 'disturbance-linear', '0.1');
  assert.equal((await summary(page)).changed, '4 changed');
  assert.equal((await summary(page)).button, 'Settings · 4');
  assert.equal(await page.text('#settings-disturbance summary'), 'Disturbance 2 changed');
  const disturbance = { ...velocityLimits.disturbance, kind: /** @type {const} */ ('slip'), linear: 0.1 };
  await assertBegun(page, { ...weighing([3, 1, 1]), law: 'kanayama', disturbance });
  await page.click('.setting:has(#setting-law) .back');
  await page.click('.setting:has(#setting-weights-final-0) .back');
  assert.equal((await setting(page, 'weights-final-0')).back, null);
  assert.equal((await summary(page)).changed, '2 changed');
  await assertBegun(page, { ...velocityLimits, disturbance });
  await page.click('#settings-preset');
  assert.equal((await summary(page)).changed, 'As in the preset');
  assert.deepEqual((await read(page)).gains, gains);
});

pageTest('a moving reference is followed, and the plane shows all of its way', async (page) => {
  await openSettings(page);
  await openGroup(page, 'task');
  await type(page, 'referenceVelocity-linear', '0.5');
  const tracking = { ...velocityLimits, referenceVelocity: { linear: 0.5, angular: 0 } };
  await assertBegun(page, tracking);
  assert.equal(await page.text('#outcome'), 'follows the reference for 10 s');
  const [start, goal] = [await middleOf(page, 'start-position'), await middleOf(page, 'goal-position')];
  const scale = (goal.x - start.x) / 2;
  const way = (0.5 * 10) / Math.SQRT2;
  const end = { x: goal.x + scale * way, y: goal.y - scale * way };
  const inked = (/** @type {{ x: number, y: number }} */ at) =>
    page.evaluate(async ({ x, y }) => {
      const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('plane-robots'));
      const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
      const pixels = canvas.width / canvas.clientWidth;
      const { data } = context.getImageData((x - 20) * pixels, (y - 20) * pixels, 40 * pixels, 40 * pixels);
      return data.filter((value, i) => i % 4 === 3 && value > 128).length;
    }, at);
  await page.focus('#scrub');
  await page.press(Key.HOME);
  // The robots are still at the start: only the reference is at the goal, which it leaves.
  assert.ok((await inked(goal)) > 100, 'the reference begins at the goal');
  await page.press(Key.END);
  assert.ok((await inked(end)) > 100, `the reference ends at ${JSON.stringify(end)}`);
  // Nobody can arrive, so nobody is counted.
  assert.doesNotMatch(await page.text('#legend'), /arrive/);
});
