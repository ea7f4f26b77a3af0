import assert from 'node:assert/strict';
import { pushesOf } from '../../../www/lesson/views/push-terms.js';
import { law as words } from '../../../www/lesson/words/en/law.js';
import { law as korean } from '../../../www/lesson/words/ko/law.js';
import { signed } from '../../../www/words/numbers.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { pageTest } from '../harness/browsers.js';
import { experiment, paperGains } from '../harness/core.js';
import { answerOf, driven, engine, linkOf, opened, samples } from './links.js';
import { test } from '../harness/once.js';

const step = stepOf('law');

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/core/engine.js').Sample} Sample */
/** @typedef {import('../../../www/core/engine.js').Triple} Triple */

/** What the law asks for depends on nothing else of it. */
const paper = experiment('velocity-limits');
const tries = step.blocks.flatMap((block) => (block.kind === 'tries' ? block.tries : []));

/** @param {string} link */
function seen(link) {
  const { experiment: own, handGains } = opened(link);
  const gains = handGains ?? paperGains('velocity-limits', 'ep');
  const all = samples(own, gains);
  return { all, gains, own, first: all[0], last: all[all.length - 1] };
}

/** @param {{ linear: object, angular: object }} pushes */
const sumsOf = ({ linear, angular }) =>
  [linear, angular].map((terms) => Object.values(terms).reduce((sum, one) => sum + one, 0));

test('the single terms add up to what the core asks for, also next to the singularity', () => {
  let largest = 0;
  for (const link of [step.link, ...tries.map(([, to]) => to), 'lab&drives=paper-ep']) {
    const { all, gains, own } = seen(link);
    // The sample at the end has no command of its own.
    for (const { error, command } of all.slice(0, -1)) {
      const pushes = pushesOf(own, /** @type {Triple} */ (gains), error);
      for (const [i, asked] of [command.linear, command.angular].entries()) {
        const terms = Object.values(i === 0 ? pushes.linear : pushes.angular);
        const size = Math.max(1, ...terms.map(Math.abs));
        largest = Math.max(largest, size);
        const sum = sumsOf(pushes)[i];
        assert.ok(Math.abs(sum - asked) < 1e-6 * size, `${link}: ${sum} and ${asked}`);
      }
    }
  }
  assert.ok(largest > 1e6, 'a drive comes to where the program no longer divides');
});

test('kx alone steers towards the goal’s line where the robot faces less than 90° off the goal’s direction', () => {
  const goal = { x: 2, y: 2, theta: 0 };
  for (const degrees of [-60, -30, 30, 60, 120, 150, 170]) {
    const theta = (degrees * Math.PI) / 180;
    for (const x of [0, 4]) {
      const own = { ...paper, goal, starts: [{ x, y: 1.5, theta }] };
      const [{ error }] = samples(own, [3, 0, 0]);
      const { angular, linear } = pushesOf(own, [3, 0, 0], error);
      // How fast the robot's way towards the line bends: its speed times its turn rate, seen across the line.
      const bend = sumsOf({ linear, angular }).reduce((product, one) => product * one, Math.cos(theta));
      assert.equal(bend > 0, Math.abs(degrees) < 90, `${degrees}° from ${x}`);
    }
  }
});

test('each gain alone brings its own error to zero and leaves the others', () => {
  const { error } = seen(step.link).first;
  for (const part of [error.x, error.y, error.theta]) assert.ok(Math.abs(part) > 0.5);
  const kx = seen(linkOf(step, 'onlyKx')).last.error;
  assert.ok(Math.abs(kx.x) < 0.001 && Math.abs(kx.y) > 0.4 && Math.abs(kx.theta) > 0.5);
  const kt = seen(linkOf(step, 'onlyKt'));
  assert.ok(Math.abs(kt.last.error.theta) < 0.001);
  for (const { posture } of kt.all) assert.deepEqual([posture.x, posture.y], [1.5, 0.5], 'turns on the spot');
  const ky = seen(linkOf(step, 'onlyKy')).last.error;
  assert.ok(Math.abs(ky.y) < 0.15 * error.y && Math.abs(ky.x) > 1 && Math.abs(ky.theta) > 1);
});

test('without ky the robot parks beside the goal from below, and arrives from the paper’s start', async () => {
  const { last, gains, own } = seen(linkOf(step, 'beside'));
  assert.equal(last.outcome, 'horizon');
  assert.ok(Math.abs(last.error.x) < 0.001 && Math.abs(last.error.theta) < 0.001);
  assert.ok(Math.abs(last.error.y) > 0.5, `${last.error.y} m beside`);
  for (const sum of sumsOf(pushesOf(own, /** @type {Triple} */ (gains), last.error)))
    assert.ok(Math.abs(sum) < 0.001);
  const right = async (/** @type {string} */ name) => {
    const scene = /** @type {any} */ ({ experiment: opened(linkOf(step, name)).experiment });
    return (await answerOf(step, name, { engine, scene })).right;
  };
  assert.match(words.quizzes.beside.choices[await right('beside')], /^Beside the goal/);
  assert.match(words.quizzes.ahead.choices[await right('ahead')], /^It arrives/);
  const { y } = seen(linkOf(step, 'ahead')).first.error;
  assert.ok(Math.abs(y) < 1e-12, 'the paper’s start lies straight behind the goal');
});

test('in the drive from the paper’s start the kx term of ω steers back to the line', () => {
  const { all, gains, own } = seen(linkOf(step, 'ahead'));
  const farthest = all.reduce((a, b) => (Math.abs(b.error.y) > Math.abs(a.error.y) ? b : a));
  const { kx } = pushesOf(own, /** @type {Triple} */ (gains), farthest.error).angular;
  // It turns the robot on, past the goal's heading: driving ahead then brings y_e down.
  assert.ok(farthest.error.y * kx > 0);
});

/** @param {readonly Sample[]} all */
const fastestOf = (all) =>
  all.reduce((a, b) => (Math.abs(b.command.angular) > Math.abs(a.command.angular) ? b : a));

test('with all three it arrives, and what the law asks for is far beyond the limits', () => {
  const { all } = seen(linkOf(step, 'all'));
  assert.equal(all[all.length - 1].outcome, 'arrived');
  const most = fastestOf(all);
  assert.ok(Math.abs(most.command.angular) > 1000);
  assert.equal(Math.abs(most.velocity.angular), 2 * Math.PI);
});

test('what the text tells of 3, 8, 5 is of the drive that its words open', () => {
  const told = step.values?.(/** @type {any} */ ({ engine })) ?? {};
  for (const { texts } of [words, korean]) {
    const [, link] = /\]\((lab[^)]+)\)/.exec(texts.sideways) ?? [];
    assert.ok(link, texts.sideways);
    const { command, velocity, time } = fastestOf(seen(link).all);
    const now = [command.angular, velocity.angular].map((turn) => Math.abs(turn));
    assert.deepEqual(
      [told.most, told.at, told.leaves],
      [signed(now[0], 0), time.toFixed(2), signed(now[1], 2)],
    );
  }
});

test('beside the goal nothing moves without ky; with it the robot goes to and fro, and over', () => {
  const stuck = driven(linkOf(step, 'stuck'));
  assert.ok(stuck.x.every((x) => Math.abs(x - 2.5) < 1e-9) && stuck.y.every((y) => Math.abs(y - 1.5) < 1e-9));
  const { all, first, last } = seen(linkOf(step, 'shuffle'));
  const turns = all.filter(({ velocity }, i) => i > 0 && velocity.linear * all[i - 1].velocity.linear < 0);
  assert.ok(turns.length > 20, `${turns.length} changes of direction`);
  assert.ok(Math.abs(last.error.y) < 0.15 * Math.abs(first.error.y));
  // At sin θ_e = 0 the program divides by 0.000001.
  assert.ok(Math.abs(first.command.linear / (-8 * first.error.y ** 3 * 1e6) - 1) < 1e-9);
});

test('without limits the robot spins', () => {
  const { angular } = driven(linkOf(step, 'unlimited'));
  assert.ok(Math.max(...angular.map(Math.abs)) > 1000);
});

test('where y_e is 0, kx drives, kθ turns, and no other term is left', () => {
  const { linear, angular } = pushesOf(paper, [3, 8, 5], { x: 1, y: 0, theta: 0.5 });
  assert.ok(linear.kx > 0 && angular.kt > 0);
  for (const other of [linear.ky, angular.ky, angular.kx]) assert.equal(Math.abs(other), 0);
});

/** The numbers of the table at a time, once they are drawn. @param {Page} page @param {number} time */
async function barsAt(page, time) {
  await page.evaluate((value) => {
    const scrub = /** @type {HTMLInputElement} */ (document.getElementById('scrub'));
    scrub.value = String(value);
    scrub.dispatchEvent(new Event('input', { bubbles: true }));
  }, time);
  return page.evaluate(async () => {
    return [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#pushes tr:not([hidden])'))]
      .filter((row) => row.querySelector('.push-value'))
      .map((row) => row.querySelector('.push-value')?.textContent ?? '');
  });
}

/** What the table has to say. @param {Sample} sample @param {Triple} gains */
function rowsOf({ error, command, velocity }, gains) {
  const { linear, angular } = pushesOf(paper, gains, error);
  return [
    ...[linear.kx, linear.ky, command.linear, velocity.linear],
    ...[angular.kt, angular.ky, angular.kx, command.angular, velocity.angular],
  ].map((value) => signed(value, 2));
}

pageTest('the bars are the core’s numbers at the robot’s clock, and follow a gain', async (page) => {
  await page.open('#lesson&step=3');
  await page.click('[data-try="all"]');
  const { all } = seen(linkOf(step, 'all'));
  for (const at of [0, 13, 60]) assert.deepEqual(await barsAt(page, at / 100), rowsOf(all[at], [3, 8, 5]));
  assert.deepEqual(await barsAt(page, 60), rowsOf(all[all.length - 2], [3, 8, 5]), 'at the end');
  const arrow = () => page.evaluate(() => document.querySelectorAll('#pushes .push-beyond.at-right').length);
  await barsAt(page, 0.13);
  assert.ok((await arrow()) > 0, 'what leaves the picture has an arrow');

  await page.focus('#gain-ky');
  await page.press('0', '\uE007');
  const without = samples(opened(linkOf(step, 'all')).experiment, [3, 0, 5]);
  assert.deepEqual(await barsAt(page, 0.6), rowsOf(without[60], [3, 0, 5]));
});

pageTest(
  'the try without limits stands where the law asks for the fastest turn, which is said, and drives on',
  async (page) => {
    await page.open('#lesson&step=3');
    const { all } = seen(linkOf(step, 'all'));
    const told = await page.evaluate(() =>
      ['most', 'at'].map((name) => document.querySelector(`#lesson [data-value="${name}"]`)?.textContent),
    );
    const fastest = fastestOf(all);
    assert.deepEqual(told, [signed(fastest.command.angular, 0), fastest.time.toFixed(2)]);

    const free = seen(linkOf(step, 'unlimited')).all;
    const largest = fastestOf(free);
    assert.equal(largest.velocity.angular, largest.command.angular);
    await page.click('[data-try="unlimited"]');
    const shown = signed(largest.command.angular, 2);
    await page.until(
      'its bar',
      (text) =>
        [...document.querySelectorAll('#pushes .of-left .push-value')].some(
          (one) => one.textContent === text,
        ),
      shown,
    );
    const cut = await page.evaluate(() =>
      [...document.querySelectorAll('#pushes .push-value')]
        .filter((one) => one.scrollWidth > one.clientWidth)
        .map((one) => one.textContent),
    );
    assert.deepEqual(cut, []);
    const clock = () =>
      page.evaluate(() => Number(/** @type {HTMLInputElement} */ (document.getElementById('scrub')).value));
    assert.equal(await clock(), largest.time);
    await page.click('#play');
    await page.until(
      'it drives on',
      (time) => Number(/** @type {HTMLInputElement} */ (document.getElementById('scrub')).value) > time,
      largest.time,
    );
  },
);

pageTest('a term lights up its slider, its bars and its errors; another law shows no terms', async (page) => {
  await page.open('#lesson&step=3');
  await page.evaluate(() => /** @type {HTMLElement} */ (document.getElementById('scrub')).focus());
  await barsAt(page, 0.2);
  const lit = await page.evaluate(() => {
    document
      .querySelector('#lesson .formula mrow[data-term="ky"]')
      ?.dispatchEvent(new PointerEvent('pointerover', { bubbles: true }));
    const count = (/** @type {string} */ selector) => document.querySelectorAll(`${selector}.lit`).length;
    return {
      slider: count('.gain.ky'),
      otherSliders: count('.gain.kx') + count('.gain.ktheta'),
      bars: count('#pushes tr'),
      errors: ['xe', 'ye', 'te'].map((name) => count(`#error-posture g[data-term="${name}"]`)),
    };
  });
  assert.deepEqual(lit, { slider: 1, otherSliders: 0, bars: 2, errors: [0, 1, 1] });

  await page.open('#lab&v=1&drives=hand&gains=3,1,5&law=kanayama&lesson=3');
  assert.equal((await barsAt(page, 0.2)).length, 4, 'asked for and after the limits, twice');
});

pageTest('the clock of a step stands where its words say, also when one comes back to it', async (page) => {
  await page.open('#lesson&step=3');
  const time = () => page.evaluate(() => document.getElementById('clock')?.textContent);
  const first = await page.until('it stands', () => {
    const text = document.getElementById('clock')?.textContent;
    return text && !/^0[.,]00/.test(text) && text;
  });
  await page.click('#page-lab');
  await page.until('the lesson is closed', () => document.getElementById('lesson')?.hidden);
  await page.click('#page-lesson');
  await page.until('it is open', () => document.getElementById('lesson')?.hidden === false);
  assert.equal(await time(), first);
});
