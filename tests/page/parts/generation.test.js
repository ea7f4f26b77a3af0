// The numbers of a generation, phase by phase.
import assert from 'node:assert/strict';
import { margin } from '../../../www/parts/generation/places.js';
import { pageTest } from '../harness/browsers.js';
import { simulate } from '../harness/core.js';
import { read } from '../harness/reading.js';
import {
  bouts,
  count,
  go,
  nameOf,
  numbersIn,
  openAt,
  press,
  rank,
  recordOf,
  same,
  shownOn,
  velocityLimits,
} from './generation-page.js';

pageTest('a table that is asked for while its record is still computed comes with it', async (page) => {
  await page.open('#generation&v=1&horizon=800&population=300&generation=1');
  await page.until('the first table can be had', () => document.getElementById('generation-table'));
  await page.evaluate(() => {
    const { prototype } = Worker;
    const { postMessage } = prototype;
    /** @type {(() => void)[]} */
    const waiting = [];
    prototype.postMessage = function (/** @type {any[]} */ ...asked) {
      const ask = () => Reflect.apply(postMessage, this, asked);
      if (asked[0].call !== 'record') return ask();
      Object.assign(window, { isAsked: true });
      waiting.push(ask);
    };
    addEventListener('records-come', () => {
      Object.assign(prototype, { postMessage });
      for (const ask of waiting) ask();
    });
    location.hash = location.hash.replace('population=300', 'population=301');
  });
  await page.until('the record is asked for', () => 'isAsked' in window);
  await page.click('#generation-table');
  assert.equal(await page.evaluate(() => document.querySelector('dialog[open]')), null);
  await page.evaluate(() => dispatchEvent(new Event('records-come')));
  const caption = await page.until(
    'the table is there',
    () =>
      document.querySelector('dialog[open] table tbody tr') &&
      document.querySelector('dialog[open]')?.textContent,
  );
  assert.match(caption, /all 602/);
  assert.deepEqual(await page.problems(), []);
});

pageTest('every number of every phase is the record of the core', async (page) => {
  await openAt(page, 4);
  const record = recordOf(4);
  const { all, mutations, opponents, wins, survivors } = record;
  const order = rank(
    wins,
    all.map(({ cost }) => cost),
  );
  for (const chosen of [6, count + 11]) {
    await go(page, 'ranking');
    await press(page, chosen);
    const pair = chosen % count;
    const [parent, child, draws] = [all[pair], all[pair + count], mutations[pair]];

    await go(page, 'parents');
    let seen = await shownOn(page);
    assert.equal(seen.chosen, nameOf(pair));
    same(numbersIn(seen.headline)[1], parent.cost, 'J of the parent');
    for (const [i, text] of seen.equations.entries())
      same(numbersIn(text)[0], i % 2 ? parent.sigmas[(i - 1) / 2] : parent.gains[i / 2], text);

    await go(page, 'mutation');
    seen = await shownOn(page);
    const [product, rate, common] = numbersIn(seen.common);
    same(common, draws.common, 'the common draw');
    same(rate, 1 / Math.sqrt(6), 'τ′');
    same(product, draws.common / Math.sqrt(6), 'τ′N');
    for (const i of [0, 1, 2]) {
      const gain = numbersIn(seen.equations[2 * i]);
      const exact = [parent.gains[i], parent.sigmas[i], draws.gains[i], child.gains[i]];
      for (const [j, printed] of gain.entries()) same(printed, exact[j], seen.equations[2 * i]);
      assert.equal(gain.length, 4);
      const sigma = numbersIn(seen.equations[2 * i + 1]);
      const tau = 1 / Math.sqrt(2 * Math.sqrt(3));
      const parts = [parent.sigmas[i], draws.common / Math.sqrt(6), tau, draws.sigmas[i], child.sigmas[i]];
      for (const [j, printed] of sigma.entries()) same(printed, parts[j], seen.equations[2 * i + 1]);
      assert.equal(sigma.length, 5);
    }

    await go(page, 'drive');
    seen = await shownOn(page);
    const run = simulate(velocityLimits, all[chosen].gains);
    assert.equal(seen.chosen, nameOf(chosen));
    assert.equal(seen.legend, `${nameOf(chosen)} of generation 4`);
    const partner = chosen < count ? chosen + count : chosen - count;
    assert.ok(seen.rival.startsWith(`${nameOf(partner)}, J ${all[partner].cost.toFixed(3)}`), seen.rival);
    same(numbersIn(seen.headline)[1], all[chosen].cost, 'J');
    assert.equal(run.cost.total, all[chosen].cost);
    for (const [i, printed] of numbersIn(seen.triple).entries())
      same(printed, all[chosen].gains[i], seen.triple);
    const { time, path, energy, finalError } = run.cost;
    for (const [i, printed] of numbersIn(seen.parts).entries())
      same(printed, [time, path, energy, finalError][i], seen.parts);
    same(String((await read(page)).finalTime), run.finalTime, 'the clock of the robots');

    await go(page, 'tournament');
    seen = await shownOn(page);
    assert.equal(seen.bouts.length, bouts);
    // Who is met more than once drives once.
    const met = new Set(opponents[chosen]).size;
    assert.ok(seen.others.startsWith(`its ${met} opponents in ${bouts} bouts`), seen.others);
    for (const [i, text] of seen.bouts.entries()) {
      const opponent = opponents[chosen][i];
      assert.ok(text.includes(nameOf(opponent)), text);
      same(numbersIn(text)[1], all[opponent].cost, text);
      assert.equal(text.includes('✓'), all[chosen].cost <= all[opponent].cost, text);
    }
    assert.equal(seen.bouts.filter((text) => text.includes('✓')).length, wins[chosen]);
    assert.ok(seen.headline.includes(`${wins[chosen]} wins of ${bouts}`), seen.headline);

    await go(page, 'ranking');
    seen = await shownOn(page);
    const place = order.indexOf(chosen);
    assert.ok(seen.said.includes(`${wins[chosen]} wins, rank ${place + 1} of 40`), seen.said);
    for (const text of seen.ranks) {
      const [position, , won, cost] = numbersIn(text);
      const who = order[Number(position) - 1];
      assert.ok(text.includes(nameOf(who)), text);
      assert.equal(Number(won), wins[who]);
      same(cost, all[who].cost, text);
    }

    await go(page, 'survivors');
    seen = await shownOn(page);
    const fate = survivors.indexOf(chosen);
    const expected =
      fate < 0 ? `fell: rank ${place + 1} of 40` : `survives as parent ${fate + 1} of generation 5`;
    assert.ok(seen.headline.includes(expected), seen.headline);
  }
});

pageTest(
  'where evolution has nearly ended the axis of J is whole, and its numbers stand apart',
  async (page) => {
    await page.resize(1366, 768);
    await page.open('#generation&v=1&generation=300&phase=mutation&individual=0&lesson=8');
    const { texts, left } = await page.until('the axis', () => {
      const axis = [...document.querySelectorAll('.generation-picture .axis text')];
      const figure = document.querySelector('.generation-picture')?.getBoundingClientRect();
      return (
        figure &&
        axis.some((one) => one.textContent?.startsWith('×10')) && {
          left: figure.left,
          texts: axis.map((one) => {
            const { left, right, top, bottom } = one.getBoundingClientRect();
            return { text: one.textContent ?? '', left, right, top, bottom };
          }),
        }
      );
    });
    assert.ok(texts.some(({ text }) => /^\+\d(\.\d)?$/.test(text)));
    const numbers = texts.filter(({ text }) => /^[+×]|best|↑/.test(text));
    for (const [i, one] of numbers.entries()) {
      assert.ok(one.left >= left, JSON.stringify(one));
      for (const other of numbers.slice(i + 1))
        assert.ok(one.bottom - other.top < 5 || other.bottom - one.top < 5, JSON.stringify([one, other]));
    }
    const index = await page.evaluate(() => document.querySelector('.rule sup sub')?.textContent);
    assert.equal(index, 'i', 'an index of the formula’s own font, which is not cut');
  },
);

pageTest('a press in a column chooses who stands there, however high', async (page) => {
  await openAt(page, 3);
  await go(page, 'parents');
  const { width, height } = await page.evaluate(() => {
    const box = document.getElementById('generation-picture')?.getBoundingClientRect();
    return { width: box?.width ?? 0, height: box?.height ?? 0 };
  });
  const step = (width - margin.left - margin.right) / count;
  for (const number of [4, 13, 19])
    for (const y of [0.1 * height, 0.5 * height]) {
      const point = { x: margin.left + (number + 0.5) * step, y };
      await page.drag('#generation-picture', [point, point]);
      assert.equal((await shownOn(page)).chosen, nameOf(number), `${number} at ${y}`);
    }
});

pageTest('who wants less motion sees none from one phase to the next', async (page) => {
  await openAt(page, 1);
  await go(page, 'drive');
  await shownOn(page);
  const lasts = await page.evaluate(() => {
    const picture = /** @type {Element} */ (document.querySelector('.generation-picture'));
    picture.classList.remove('still');
    return [...picture.querySelectorAll('.mark, .pair, .ring')].map(
      (mark) => getComputedStyle(mark).transitionDuration,
    );
  });
  assert.deepEqual([...new Set(lasts)], ['0s']);
});

pageTest(
  'while another run begins, the generation that is still seen is the one that was recorded',
  async (page) => {
    await page.open('#generation&v=1&generation=9');
    for (const population of ['300', '299']) {
      await page.evaluate((count) => {
        location.hash = `#generation&v=1&evolution.population=${count}&goal.x=3&generation=2`;
      }, population);
      await page.until('the other run is seen', () =>
        document.getElementById('generation-title')?.textContent?.includes('2'),
      );
      await page.click('#preset input:not(:checked)');
      await page.until('generation 0 is seen', () =>
        document.getElementById('generation-title')?.textContent?.includes('0'),
      );
    }
    // What was thrown meanwhile fails the test.
    assert.deepEqual(await page.problems(), []);
  },
);
