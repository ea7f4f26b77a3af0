// The family of the best robot: who descends from whom, and how it is drawn.
import assert from 'node:assert/strict';
import { createRecords, lineageOf, numbersBelow } from '../../../www/lesson/views/lineage.js';
import { sigma as words } from '../../../www/lesson/words/en/sigma.js';
import { sigma as ko } from '../../../www/lesson/words/ko/sigma.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { Evolution, experiment } from '../harness/core.js';
import { opened } from './links.js';
import { tryOf } from './live.js';
import { test } from '../harness/once.js';
import { follow } from '../whole/surround.js';

const usual = experiment('velocity-limits');

test('a lineage is a chain of births that ends with the best, and begins among the first', () => {
  for (const seed of [1, 2, 3]) {
    const evolution = new Evolution({ ...usual, evolution: { ...usual.evolution, seed } });
    const best = Array.from({ length: 61 }, (_, g) => {
      if (g > 0) evolution.step();
      return evolution.statistics().best.cost;
    });
    for (const generation of [0, 1, 2, 30, 60]) {
      const family = lineageOf((g) => evolution.record(g), generation);
      const [first] = family;
      assert.equal(first.born, 0);
      assert.ok(
        evolution.record(0).parents.some(({ gains }) => String(gains) === String(first.individual.gains)),
      );
      assert.equal(family.at(-1)?.individual.cost, best[generation]);
      for (const [i, { born, individual }] of family.slice(1).entries()) {
        const { parents, offspring } = evolution.record(born);
        const pair = offspring.findIndex(({ gains }) => String(gains) === String(individual.gains));
        assert.deepEqual(parents[pair], family[i].individual);
      }
    }
  }
});

test('of a family that begins late it is said that ancestors are left out', () => {
  const evolution = new Evolution(usual);
  for (let g = 1; g <= 620; g++) evolution.step();
  for (const generation of [60, 540, 620]) {
    const family = lineageOf((g) => evolution.record(g), generation);
    const { born } = family[0];
    assert.equal(born > 0, generation > 500);
    for (const [{ lineage }, leftOut, isFirst] of /** @type {const} */ ([
      [words, /left out/, /one of the first/],
      [ko, /생략/, /처음에 뽑은/],
    ]))
      for (const count of [1, family.length, 2]) {
        const said = lineage.title(generation, count, born);
        assert.equal(leftOut.test(said), born > 0, said);
        assert.equal(isFirst.test(said), born === 0 && count === 1, said);
      }
  }
  evolution.free();
});

test('where nobody descends from anybody one record is read, and else those of all generations', () => {
  for (const [method, read] of /** @type {const} */ ([
    ['random', 1],
    ['ep', 8],
  ])) {
    const experiment = { ...usual, evolution: { ...usual.evolution, method } };
    const evolution = new Evolution(experiment);
    const history = [evolution.statistics()];
    while (history.length < 8) history.push(evolution.step());
    let asked = 0;
    const record = (/** @type {number} */ g) => {
      asked += 1;
      return evolution.record(g);
    };
    const recordsOf = createRecords(/** @type {any} */ ({ engine: { record }, store: { redraw() {} } }));
    while (!recordsOf(history, 7, experiment));
    assert.equal(asked, read, method);
    evolution.free();
  }
});

test('the numbers below a family are those of their places, and none touches another', () => {
  for (const range of /** @type {[number, number][]} */ ([
    [6.9, 8.9],
    [-193, 207],
    [-4.6, 5.2],
    [5.57, 6.01],
    [7.43, 7.47],
    [-1e6, 1e6],
  ]))
    for (const wide of [93, 145, 201, 600]) {
      const numbers = numbersBelow(range, wide);
      assert.ok(numbers.length > 1, `${range}, ${wide}`);
      /** At most, in the widest font of a system. @param {string} text */
      const half = (text) => (8.3 * text.length) / 2;
      for (const [i, { at, text }] of numbers.entries()) {
        const value = Number(text.replace('−', '-').replace('k', 'e3').replace('M', 'e6'));
        const place = (value - range[0]) / (range[1] - range[0]);
        assert.ok(Math.abs(at - place) < 1e-3, `${text} at ${at}`);
        assert.ok(Math.min(at, 1 - at) * wide + 5 > half(text), `${text} leaves ${wide} pixels`);
        const before = numbers[i - 1];
        if (before) assert.ok((at - before.at) * wide > half(text) + half(before.text) + 5);
      }
    }
});

pageTest(
  'the family of the best robot is in sight, with as many bells of each gain as it has members',
  async (page) => {
    const evolution = new Evolution(usual);
    for (let g = 1; g <= 60; g++) evolution.step();
    const family = lineageOf((g) => evolution.record(g), 60);
    const [first, last] = [family[0], family[family.length - 1]].map(({ individual }) => individual.sigmas);
    await page.open('#lesson&step=8');
    const { hills, captions } = await page.until(
      'the family of generation 60',
      (title) => {
        const picture = document.getElementById('lineage');
        const columns = [...(picture?.querySelectorAll('figure') ?? [])];
        return (
          picture?.querySelector('.lineage-title')?.textContent === title && {
            hills: columns.map((column) => column.querySelectorAll('.hill').length),
            captions: columns.map((column) => column.querySelector('figcaption .muted')?.textContent),
          }
        );
      },
      words.lineage.title(60, family.length),
    );
    assert.deepEqual(
      hills,
      [0, 1, 2].map(() => family.length),
    );
    assert.deepEqual(
      captions,
      [0, 1, 2].map((i) => words.lineage.sigma(first[i], last[i])),
    );
  },
);

engineTest('the bells of a family end above the numbers below them', async (page) => {
  await page.open('#lesson&step=8');
  const gaps = await page.until('the family', () => {
    const columns = [...document.querySelectorAll('#lineage figure')];
    return (
      columns.length === 3 &&
      columns.map((column) => {
        const [bells, numbers] = ['svg', 'svg + *'].map((one) =>
          column.querySelector(one)?.getBoundingClientRect(),
        );
        return (numbers?.top ?? 0) - (bells?.bottom ?? 0);
      })
    );
  });
  for (const gap of gaps) assert.ok(gap > -1 && gap < 8, `${gaps}`);
});

pageTest('the numbers below a family stand apart, also on a telephone', async (page) => {
  await page.open('#lesson&step=8');
  for (const [width, height] of [
    [1366, 768],
    [390, 844],
  ]) {
    await page.resize(width, height);
    for (const link of [tryOf('sigma', 'none'), tryOf('sigma', 'large'), tryOf('sigma', 'stuck')]) {
      await follow(page, `${link.replace('&', '&v=1&')}&lesson=8`);
      const { generation } = opened(link);
      const rows = await page.until(
        `the numbers of ${link}`,
        (last) => {
          const all = [...document.querySelectorAll('#lineage .lineage-ticks')];
          const title = document.querySelector('.lineage-title')?.textContent ?? '';
          return (
            title.includes(`generation ${last}`) &&
            all.length === 3 &&
            all.every((row) => row.childElementCount > 1) &&
            all.map((row) =>
              [...row.children].map((one) => {
                const { left, right } = one.getBoundingClientRect();
                return { left, right, text: one.textContent };
              }),
            )
          );
        },
        generation,
      );
      const all = rows.flat();
      for (const [i, one] of all.entries())
        if (i > 0) assert.ok(one.left > all[i - 1].right, `${link}, ${width}: ${JSON.stringify(all)}`);
      for (const row of rows) assert.equal(new Set(row.map(({ text }) => text)).size, row.length);
    }
  }
});

pageTest('the bells of a family are of the distribution from which it was drawn', async (page) => {
  for (const [step, density] of /** @type {const} */ ([
    ['gaussian', (/** @type {number} */ draw) => Math.exp(-0.5 * draw * draw)],
    ['cauchy', (/** @type {number} */ draw) => 1 / (1 + draw * draw)],
  ])) {
    await page.open(`#lab&v=1&evolution.step=${step}&generation=12&lesson=8`);
    const outline = await page.until('a hill', () =>
      document.querySelector('#lineage .hill')?.getAttribute('d'),
    );
    const heights = outline
      .slice(1)
      .split('L')
      .map((point) => -Number(point.split(' ')[1]));
    const [middle, end] = [heights[(heights.length - 1) / 2], heights[0]];
    for (const [i, height] of heights.entries()) {
      const draw = 3 * ((2 * i) / (heights.length - 1) - 1);
      const share = (height - end) / (middle - end);
      const expected = (density(draw) - density(3)) / (1 - density(3));
      assert.ok(Math.abs(share - expected) < 0.01, `${step}, ${draw}: ${share}, not ${expected}`);
    }
  }
});

pageTest('the bells are drawn once it is known how wide they may be', async (page) => {
  await page.open('#lab');
  await page.evaluate(() => {
    const { ResizeObserver } = window;
    /** @type {(() => void)[]} */
    const held = [];
    /** Tells what it has seen once `tellSizes` is called. */
    window.ResizeObserver = class extends ResizeObserver {
      /** @param {ResizeObserverCallback} tell */
      constructor(tell) {
        super((...seen) => held.push(() => tell(...seen)));
      }
    };
    const tellSizes = () => {
      for (const tell of held.splice(0)) tell();
    };
    Object.assign(window, { tellSizes });
  });
  await follow(page, 'lesson&v=1&step=sigma');
  await page.until('the step', () => document.getElementById('lineage'));
  const early = await page.evaluate(async () => {
    for (let i = 0; i < 30; i += 1) await pageFrames.settled();
    return document.querySelectorAll('#lineage path').length;
  });
  assert.equal(early, 0);
  await page.until('the bells', () => {
    /** @type {any} */ (window).tellSizes();
    return document.querySelectorAll('#lineage path').length > 30;
  });
});
