import assert from 'node:assert/strict';
import { largestAt, pushesOf, pushesOver } from '../../../www/lesson/views/push-terms.js';
import { dashes } from '../../../www/kit/palette.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { engineTest, Key, pageTest } from '../harness/browsers.js';
import { engine, linkOf, opened } from './links.js';
import { test } from '../harness/once.js';

const step = stepOf('law');

/** @typedef {import('../../../www/core/engine.js').Triple} Triple */

/** @param {string} link */
function seen(link) {
  const { experiment: own, handGains } = opened(link);
  const gains = /** @type {Triple} */ (handGains);
  return { own, gains, held: engine.samples(own, gains) };
}

test('over a drive every term has its values, and no push that is soon over is lost', () => {
  for (const name of ['all', 'unlimited', 'onlyKx']) {
    const { own, gains, held } = seen(linkOf(step, name));
    const { times, linear, angular } = pushesOver(held, own, gains);
    assert.ok(times.length <= 300);
    const most = largestAt(held);
    const at = times.indexOf(most);
    const { error, command } = held.at(Math.round(most * 100));
    for (const asked of [
      linear.asked.values[at] - command.linear,
      angular.asked.values[at] - command.angular,
    ])
      assert.equal(asked, 0, `${name}: the moment at which most is asked for is there`);
    const now = pushesOf(own, gains, error);
    for (const [half, terms] of /** @type {const} */ ([
      [linear, now.linear],
      [angular, now.angular],
    ]))
      assert.deepEqual(Object.fromEntries(half.terms.map(({ term, values }) => [term, values[at]])), terms);
  }
});

pageTest(
  'the pushes over the drive are its clock, open where they are largest and follow a gain',
  async (page) => {
    await page.resize(1366, 768);
    await page.open('#lesson&step=3');
    const most = largestAt(seen(step.link).held);
    const bars = (/** @type {number} */ time) =>
      page.until(
        `the clock stands at ${time}`,
        (at) =>
          /** @type {HTMLInputElement | null} */ (document.getElementById('push-clock'))?.value ===
            String(at) && document.getElementById('clock')?.textContent?.startsWith(at.toFixed(2)),
        time,
      );
    await bars(most);
    const curve = () =>
      page.evaluate(() => document.querySelector('.strip-curve[data-term="kx"]')?.getAttribute('d') ?? '');
    const before = await page.until('its curve', () =>
      document.querySelector('.strip-curve[data-term="kx"]')?.getAttribute('d'),
    );
    // What is moved is the robots' clock, by keyboard and where it is pressed.
    await page.focus('#push-clock');
    await page.press(Key.RIGHT);
    await bars(Number((most + 0.01).toFixed(2)));
    await page.click('#push-clock');
    const middle = await page.evaluate(() =>
      Number(/** @type {HTMLInputElement} */ (document.getElementById('push-clock')).value),
    );
    assert.ok(Math.abs(middle - 5) < 0.1, `pressed in the middle of 10 s, it is ${middle}`);
    await bars(middle);
    assert.equal(await curve(), before);

    await page.focus('#gain-ky');
    await page.press('8', Key.ENTER);
    await page.until(
      'a curve for what is on now, which is in the hand',
      () => document.querySelectorAll('.strip-curve[data-term="ky"][d^="M"].lit').length === 2,
    );
    assert.notEqual(await curve(), before);
    const dashed = await page.evaluate(() =>
      [...document.querySelectorAll('.strip-curve[d^="M"]')].map((one) => [
        one.getAttribute('data-term'),
        one.getAttribute('stroke-dasharray'),
      ]),
    );
    assert.deepEqual(dashed, [
      ...[
        ['kx', null],
        ['ky', dashes['--y'].join(' ')],
      ],
      ...[
        ['ky', dashes['--y'].join(' ')],
        ['kx', null],
      ],
    ]);
    const lit = await page.evaluate(() => {
      document
        .querySelector('#lesson .formula mrow[data-term="ky"]')
        ?.dispatchEvent(new PointerEvent('pointerover', { bubbles: true }));
      return [...document.querySelectorAll('.strip-curve.lit')].map((one) => one.getAttribute('data-term'));
    });
    assert.deepEqual(lit, ['ky', 'ky']);

    for (const [width, height] of [
      [1366, 768],
      [1280, 720],
      [1440, 900],
    ]) {
      await page.resize(width, height);
      await page.until(`at ${width} × ${height} the figure has all of it`, () => {
        const figure = /** @type {HTMLElement} */ (document.querySelector('.figure'));
        return (
          figure.scrollHeight <= figure.clientHeight &&
          document.querySelector('.push-strip')?.checkVisibility()
        );
      });
      const over = await page.evaluate(() => {
        const [hint, picture] = ['.push-strip p', '.strip-picture svg'].map((one) =>
          /** @type {Element} */ (document.querySelector(one)).getBoundingClientRect(),
        );
        return hint.bottom - picture.top;
      });
      assert.ok(over <= 0, `at ${width} × ${height} the words lie ${over} px over the curves`);
    }
    await page.resize(390, 844);
    await page.until(
      'there is no room for it on a telephone',
      () => !document.querySelector('.push-strip')?.checkVisibility(),
    );
    const scrolled = await page.evaluate(() => {
      const stage = /** @type {HTMLElement} */ (document.querySelector('#stage'));
      return stage.scrollHeight - stage.clientHeight;
    });
    assert.ok(scrolled <= 1, `the bars can be scrolled by ${scrolled} px`);
  },
);

pageTest('what comes of a moving goal is dotted, for no gain asks for it', async (page) => {
  await page.resize(1366, 768);
  await page.open('#lesson&step=law&referenceVelocity.linear=0.5');
  const { dots } = await page.until('its lines', () => {
    const line = document.querySelector('.strip-curve[data-term="moving"]');
    return line && { dots: line.getAttribute('stroke-dasharray') };
  });
  const gains = Object.values(dashes).map((dash) => dash.join(' ') || null);
  assert.ok(!gains.includes(dots), String(dots));
});

engineTest(
  'the numbers of the pushes have room, as what is drawn before them has, however wide letters are',
  async (page) => {
    await page.resize(1280, 800);
    await page.open('#lesson&step=law');
    const { widths, over } = await page.until('they are there', () => {
      const table = document.querySelector('.pushes');
      const cells = [...document.querySelectorAll('.push-cell')].map(
        (cell) => cell.getBoundingClientRect().width,
      );
      return (
        table &&
        table.clientWidth > 0 &&
        cells.length > 0 && { widths: cells, over: table.scrollWidth - table.clientWidth }
      );
    });
    assert.ok(Math.min(...widths) >= 60, widths.join(', '));
    assert.ok(over <= 0, `${over} px`);
  },
);
