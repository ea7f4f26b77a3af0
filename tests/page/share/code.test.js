// The controller to take away: written in each language and run, it drives as the core does.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { controllerOf } from '../../../www/share/code/controller.js';
import { languages } from '../../../www/share/code/languages.js';
import { smallestDivisor } from '../../../www/share/code/parts.js';
import * as en from '../../../www/share/code/words/en.js';
import * as ko from '../../../www/share/code/words/ko.js';
import { evolve, experiment, lawTerms, paperGains, simulateAll } from '../harness/core.js';
import { test } from '../harness/once.js';
import { saved } from '../harness/saved.js';
import { anyDrive, createChance } from './any-drive.js';
import { printed, printedBy, printedText, runAll, runners } from './programs.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../../../www/core/engine.js').Triple} Triple */
/** @typedef {import('../../../www/share/code/controller.js').Controller} Controller */

const about = { version: '0.1.0', link: 'https://host/ep/#lab&v=1&seed=7' };
/** @type {import('../../../www/share/code/controller.js').Drive} */
const drive = (from, gains) => simulateAll(from, gains.flat());
const take = (/** @type {Experiment} */ from, /** @type {Triple} */ gains) =>
  controllerOf(drive, from, gains, about);

/** The first drives that rounding does not decide. @param {number} count */
function steadyDrives(count) {
  const chance = createChance(7);
  /** @type {Controller[]} */
  const steady = [];
  let made = 0;
  for (; steady.length < count; made += 1) {
    const controller = take(...anyDrive(chance));
    if (controller.isSteady) steady.push(controller);
  }
  return { steady, made };
}
const { steady: controllers, made } = steadyDrives(200);

/** @param {import('../../../www/core/engine.js').Run} run */
const lastOf = ({ x, y, theta }) => [x, y, theta].map((values) => values[values.length - 1]);

/** What of numbers is printed. @param {import('./programs.js').Numbers[]} all */
const shortOf = (all) => all.map((numbers) => numbers.map((value) => Number(value.toPrecision(12))));

/** What the core says: t_f, J and the last pose. @param {Controller} controller */
const numbersOfCore = ({ experiment: from, gains }) => {
  const [run] = drive(from, [gains]);
  return [run.finalTime, run.cost.total, ...lastOf(run)];
};

/** Whether a start moved by much more than the rounding of float leaves the drive as it is. @param {Controller} controller */
function isSteadyForFloat(controller) {
  const { experiment: from, gains, start } = controller;
  const own = numbersOfCore(controller);
  return [-2e-6, 2e-6].every((by) => {
    const starts = [{ x: start.x + by, y: start.y - by, theta: start.theta + by }];
    const other = numbersOfCore({ ...controller, experiment: { ...from, starts }, gains });
    return other.every((value, i) => Math.abs(value - own[i]) < (i === 0 ? 1e-9 : 2e-5));
  });
}

const wordsOf = (/** @type {number} */ i) => (i % 2 ? ko : en).comments;

/** @param {keyof typeof runners} how @param {readonly Controller[]} some @param {number} tolerance */
async function drivesAsCore(how, some, tolerance) {
  const all = await runAll(how, some, wordsOf);
  assert.equal(all.length, some.length);
  for (const [i, own] of all.entries()) {
    const core = numbersOfCore(some[i]);
    assert.equal(own.length, 5);
    for (const [k, value] of own.entries()) {
      if (value === core[k]) continue;
      // However fine the numbers, a sample more or less would be seen.
      const near = k === 0 ? Math.min(tolerance, some[i].experiment.sampleTime / 3) : tolerance;
      const most = near * Math.max(1, Math.abs(core[k]));
      assert.ok(Math.abs(value - core[k]) <= most, `${how} ${i}, number ${k}: ${value} for ${core[k]}`);
    }
  }
}

test('the drives are of every kind, and most drives are steady', () => {
  const count = (/** @type {(controller: Controller) => unknown} */ is) => controllers.filter(is).length;
  for (const [name, found] of Object.entries({
    parked: count(({ page }) => page.outcome === 'arrived'),
    late: count(({ page }) => page.outcome === 'horizon'),
    moving: count(({ isTracking }) => isTracking),
    kanayama: count(({ experiment: { law } }) => law === 'kanayama'),
    unlimited: count(({ canDiverge }) => canDiverge),
    accelerating: count(({ experiment: { limits } }) => limits.acceleration !== null),
    negative: count(({ gains }) => gains.some((gain) => gain < 0)),
    forFloat: count(isSteadyForFloat),
  }))
    assert.ok(found >= 5, `${name}: ${found}`);
  assert.ok(made < 400, `${made} drives`);
});

for (const [how, tolerance, count] of /** @type {const} */ ([
  ['python', 1e-9, 200],
  ['javascript', 1e-9, 200],
  ['c', 1e-9, 200],
  // Octave takes a hundred times as long.
  ['matlab', 1e-9, 50],
]))
  test(
    `${count} drives in ${how} end as the core's do`,
    { skip: !runners[how].program && `there is no program for ${how}` },
    () => drivesAsCore(how, controllers.slice(0, count), tolerance),
  );

test(
  'in C with float they end as near as float allows',
  { skip: !runners.float.program && 'there is no C compiler' },
  () => drivesAsCore('float', controllers.filter(isSteadyForFloat), 1e-4),
);

const usual = experiment('velocity-limits');
const epGains = /** @type {Triple} */ ([...paperGains('velocity-limits', 'ep')]);
const names = /** @type {import('../../../www/share/code/languages.js').LanguageName[]} */ (
  Object.keys(languages)
);

for (const language of names)
  test(`run as its head says, the program in ${language} prints its numbers beside the page's`, {
    skip: !runners[language].program && `there is no program for ${language}`,
  }, async () => {
    // J of the second has 21 digits.
    for (const [{ comments }, gains] of /** @type {const} */ ([
      [en, epGains],
      [ko, [-1e17, 0.1, 5]],
    ])) {
      const controller = take(usual, gains);
      const text = await printedBy(language, controller, comments);
      const [own] = printed(text);
      const core = numbersOfCore(controller);
      for (const [k, value] of own.entries())
        assert.ok(Math.abs(value - core[k]) < 1e-9 * Math.max(1, core[k]), text);
      for (const line of text.trim().split('\n')) {
        const [, mine, page] = /(\S+) +page (\S+)$/.exec(line) ?? [];
        assert.equal(mine, page, line);
      }
    }
  });

test('a program in JavaScript prints its numbers under whatever name it is saved', async () => {
  const { write } = languages.javascript;
  const text = write(take(usual, epGains), en.comments);
  for (const file of ['controller (1).mjs', '제어기.mjs', '100%.mjs'])
    assert.match(await printedText('javascript', file, text), / page /, file);
});

const unlimited = { speed: null, turnRate: null, acceleration: null, turnAcceleration: null };

test('what leaves the finite numbers ends there, in every language', async () => {
  const lost = experiment({ law: 'kanayama', limits: unlimited, sampleTime: 0.1 });
  const turning = experiment({ limits: { ...unlimited, turnRate: 2 } });
  const finite = [take(lost, [1000, 0, 0]), take(lost, [-500, 1, 1]), take(turning, [3, -1, 5])];
  // Float has no number of this size.
  const whole = [...finite, take(experiment({ limits: unlimited }), [1e308, 1, 1])];
  for (const { page } of whole) assert.equal(page.outcome, 'diverged');
  for (const how of [...names, /** @type {const} */ ('float')]) {
    if (!runners[how].program) continue;
    const some = how === 'float' ? finite : whole;
    const all = await runAll(how, some, wordsOf);
    assert.deepEqual(
      all.map(([, cost]) => cost),
      some.map(() => Number.POSITIVE_INFINITY),
      how,
    );
    if (how !== 'float') assert.ok(Math.abs(all[0][0] - some[0].page.time) < 1e-9, `${how}: ${all[0]}`);
  }
});

test('divisors are guarded as the core guards them', () => {
  const at = { x: 0, y: 1, theta: 0 };
  const { linear } = lawTerms(usual, [0, 1, 0], at).command.ky;
  assert.equal(-1 / linear, smallestDivisor);
});

test('the head says what the numbers do not: disturbance, and a drive that hangs on rounding', () => {
  const pushed = { ...usual, disturbance: { ...usual.disturbance, kind: 'slip', linear: 0.1 } };
  const wild = take(experiment('acceleration-limits'), [30, 30, 30]);
  const controller = take(/** @type {Experiment} */ (pushed), epGains);
  assert.deepEqual([controller.isDisturbed, controller.isSteady, wild.isSteady], [true, true, false]);
  assert.deepEqual(controller.page, take(usual, epGains).page);
  for (const { comments } of [en, ko])
    for (const { write } of Object.values(languages)) {
      const joined = (/** @type {Controller} */ one) =>
        write(one, comments).replace(/\s+(?:#|%|\/\/)?\s*/g, ' ');
      assert.ok(joined(controller).includes(comments.disturbed));
      assert.ok(!joined(controller).includes(comments.unsteady));
      assert.ok(joined(wild).includes(comments.unsteady));
      assert.ok(!joined(wild).includes(comments.disturbed));
      assert.ok(joined(wild).includes(about.link));
    }
});

test('other drives have files of other names, and the way to the gains changes none', () => {
  const { evolution, weights } = usual;
  const name = (/** @type {object} */ change, gains = epGains) => take({ ...usual, ...change }, gains).name;
  const all = [
    name({}),
    name({ horizon: 9 }),
    name({ weights: { ...weights, penalty: 0 } }),
    name({ goal: { x: 2, y: 2, theta: 0 } }),
    name({}, [3.23673, 0.09678, 5.178910000000001]),
    ...controllers.map((one) => one.name),
  ];
  assert.equal(new Set(all).size, all.length);
  assert.equal(name({ evolution: { ...evolution, seed: 99 } }), name({}));
  for (const one of all) assert.match(one, /^controller_[0-9a-f]{8}$/);
});

test('nothing in a link ends the line in which it stands', () => {
  for (const { write } of Object.values(languages)) {
    const odd = controllerOf(drive, usual, epGains, { version: '1', link: 'file:///a\nb\\\n*/ c\u2028d' });
    const line = write(odd, en.comments)
      .split(/[\n\r\u2028]/)
      .find((one) => one.includes('file:'));
    assert.match(line ?? '', /d$/);
    assert.ok(!line?.includes('\\'));
  }
});

/** What a person reads of the code. @param {import('../harness/browsers.js').Page} page */
const readCode = (page) =>
  page.evaluate(() => {
    const text = (/** @type {string} */ id) => document.getElementById(id)?.innerText ?? '';
    return { file: text('code-file'), code: text('code-text'), status: text('code-status') };
  });

pageTest(
  'Share shows the controller in each language, copies it and saves it as what is shown',
  async (page) => {
    await page.open('#lab&v=1&seed=5&generation=6');
    await page.click('#keep-button');
    await page.until('Share', () => document.getElementById('keep-code'));
    await page.click('#keep-code');
    await page.until('the code', () => document.getElementById('code-text'));
    // What is copied would be what a browser has translated.
    assert.equal(await page.evaluate(() => document.getElementById('code-text')?.translate), false);
    const { gains } = evolve(experiment({ evolution: { seed: 5 } }), 6);
    const [run] = drive(experiment('velocity-limits'), [/** @type {Triple} */ ([...gains])]);
    for (const language of names) {
      await page.click(`label:has(#code-language-${language})`);
      const { ending } = languages[language];
      const { file, code } = await readCode(page);
      assert.match(file, new RegExp(`^controller_[0-9a-f]{8}\\.${ending}$`));
      for (const gain of gains) assert.ok(code.includes(String(gain)), `${language} lacks ${gain}`);
      assert.ok(code.includes(String(run.cost.total)) && code.includes('#lab&v=1&seed=5&generation=6'));
      const text = await saved(page, '#code-save');
      assert.equal(text.trimEnd().replaceAll('\r', ''), code.trimEnd().replaceAll('\u00a0', ' '));
      if (runners[language].program)
        assert.deepEqual(
          shortOf(printed(await printedText(language, file, text))),
          shortOf([[run.finalTime, run.cost.total, ...lastOf(run)]]),
        );
    }
    await page.click('#code-copy');
    await page.until('what is said of the copy', () => document.getElementById('code-status')?.textContent);
    const { code, status } = await readCode(page);
    assert.ok([en.copied, en.notCopied].includes(status), status);
    if (status === en.notCopied)
      assert.equal(
        await page.evaluate(() => String(getSelection()).trim().slice(-30)),
        code.trim().slice(-30),
      );
    await page.click('#code-close');
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('other gains by hand are another file; the pushed robot is taken without its push', async (page) => {
  /** @param {string} link */
  const taken = async (link) => {
    await page.open(link);
    await page.click('#keep-button');
    await page.until('Share', () => document.getElementById('keep-code'));
    await page.click('#keep-code');
    await page.until('the code', () => document.getElementById('code-text'));
    return readCode(page);
  };
  const plain = await taken('#lab&v=1&drives=hand&gains=3,0.1,5');
  const other = await taken('#lab&v=1&drives=hand&gains=3,0.1,5.5');
  assert.notEqual(plain.file, other.file);
  const pushed = await taken('#disturbance&v=1&lang=ko');
  assert.match(pushed.code, /[가-힣]/);
  assert.ok(pushed.code.replace(/\s+# /g, ' ').includes(ko.comments.disturbed), pushed.code.slice(0, 600));
  assert.deepEqual(await page.problems(), []);
});
