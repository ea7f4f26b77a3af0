// What is counted of many seeds.
import assert from 'node:assert/strict';
import { seedRuns } from '../../../pkg/ep_locomotion.js';
import { gainUnits } from '../../../www/core/rules.js';
import { rangeOf } from '../../../www/parts/luck/curve.js';
import { namesOf, placeWhereAlone } from '../../../www/parts/luck/curve-names.js';
import { csvOf, quartilesOf, summaryOf } from '../../../www/parts/luck/statistics.js';
import { seedTable } from '../../../www/parts/luck/table.js';
import { drivesOf, surveyOf } from '../../../www/parts/luck/request.js';
import { luckSlice } from '../../../www/parts/luck/state.js';
import * as en from '../../../www/parts/luck/words/en.js';
import * as ko from '../../../www/parts/luck/words/ko.js';
import { firstMaker, noExercise } from '../../../www/run/exercise.js';
import { Key, pageTest } from '../harness/browsers.js';
import { Evolution, experiment, shown, shownGains, startsOnCircle, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';
import { read } from '../harness/reading.js';

test('quartiles lie between the numbers in proportion, also when some are infinite', () => {
  assert.deepEqual(quartilesOf([4, 1, 3, 2, 5]), { least: 1, low: 2, median: 3, high: 4, most: 5 });
  assert.deepEqual(quartilesOf([10, 0]), { least: 0, low: 2.5, median: 5, high: 7.5, most: 10 });
  const { median, high, most } = quartilesOf([1, 2, Infinity, Infinity, Infinity]);
  assert.deepEqual([median, high, most], [Infinity, Infinity, Infinity]);
});

test('where every seed comes to the same J, the axis has numbers that have room', () => {
  for (const cost of [7.75, 1e4, 0.003]) {
    const flat = { low: [cost], median: [cost], high: [cost] };
    const same = { high: cost };
    const summary = {
      evolution: flat,
      random: flat,
      final: same,
      finalRandom: same,
      lowest: cost,
      costs: [],
    };
    const survey = { paper: { cost }, summary };
    const [low, high] = rangeOf(/** @type {any} */ ({ survey, lab: null, log: false }));
    assert.ok(low < cost && cost < high && high - low > 0.002 * cost, `${low} to ${high}`);
  }
});

test('a line above the plot has an arrow at its name', () => {
  const ends = { low: [1], median: [1], high: [1], least: [1], most: [1] };
  const survey = {
    experiment: experiment('velocity-limits'),
    generations: 0,
    summary: { evolution: ends, random: { ...ends, high: [2] } },
  };
  const frame = { top: 20 };
  const y = (/** @type {number} */ cost) => Math.max(frame.top, 100 - 10 * cost);
  const named = (/** @type {number} */ cost) =>
    namesOf({ ...survey, paper: { gains: [1, 1, 1], cost } }, y, frame).map(({ text }) => text);
  assert.deepEqual(named(3), [en.randomLine, en.evolutionLine, en.paperLine]);
  assert.deepEqual(named(40), [en.randomLine, en.evolutionLine, `${en.paperLine} ↑`]);
});

test('the CSV of one seed is what it was', () => {
  const champion = {
    gains: /** @type {[number, number, number]} */ ([3, -0.5, 5]),
    sigmas: /** @type {[number, number, number]} */ ([1, 1, 1]),
    cost: 7,
  };
  const run = { best: Float64Array.of(8, 7), champion, random: Float64Array.of(8, 7.75) };
  assert.equal(
    csvOf({ experiment: experiment('velocity-limits'), first: 4, drives: 40, runs: [run] }),
    'seed,drives,J evolution,kx (1/s),ky (1/(m^2 s)),ktheta (rad/s),J random search,' +
      'J evolution generation 0,J evolution generation 1,J random search generation 0,J random search generation 1\r\n' +
      '4,40,7,3,-0.5,5,7.75,8,7,8,7.75\r\n',
  );
});

test('as many drives are told of a search as the core counts, or none where each seed has its own number', () => {
  const { words } = /** @type {{ words: string[] }} */ (
    wordFields().find(({ path }) => path === 'evolution.method')
  );
  assert.ok(words.length > 7);
  const usual = experiment('velocity-limits');
  const generations = 12;
  for (const starts of [usual.starts, startsOnCircle({ x: 2, y: 2, radius: 2, count: 3, seed: 1 })])
    for (const method of /** @type {(typeof usual.evolution.method)[]} */ (words)) {
      const evolution = { ...usual.evolution, method };
      const counted = Array.from({ length: 8 }, (_, seed) => {
        const search = new Evolution({ ...usual, starts, evolution: { ...evolution, seed } });
        for (let g = 0; g < generations; g += 1) search.step();
        return search.statistics().evaluations;
      });
      const told = drivesOf({ ...usual, starts, evolution }, generations);
      if (told === null) assert.ok(new Set(counted).size > 1, `${method}: ${counted}`);
      else
        assert.deepEqual(
          counted,
          counted.map(() => told),
          method,
        );
    }
});

test('where seeds have numbers of drives of their own, none is written in their place', () => {
  const usual = experiment('velocity-limits');
  const survey = /** @type {any} */ ({ experiment: usual, runs: Array(20), milliseconds: 300 });
  for (const words of [en, ko]) {
    assert.match(words.invitation(usual, 20, 50, 1020), /1.?020/);
    assert.doesNotMatch(words.invitation(usual, 20, 50, null), /null|NaN|1.?020/);
    assert.match(words.surveyNote({ ...survey, drives: 1020 }), /20.*2 × 1.?020/);
    assert.match(words.surveyNote({ ...survey, drives: null }), /^\D*20\D+300 ms/);
  }
  const champion = /** @type {any} */ ({ gains: [3, 1, 5], cost: 7 });
  const run = { best: Float64Array.of(7), champion, random: Float64Array.of(8) };
  assert.match(
    csvOf({ experiment: experiment('velocity-limits'), first: 4, drives: null, runs: [run] }),
    /\r\n4,,7,3,1,5,8,7,8\r\n$/,
  );
});

test('the table has the units of the law that drove', () => {
  const quartiles = quartilesOf([1]);
  const run = { best: [7], champion: { gains: [3, 1, 5] }, random: [8] };
  const columnsOf = (/** @type {'shim-kim' | 'kanayama'} */ law) =>
    seedTable(
      /** @type {any} */ ({
        experiment: { ...experiment('velocity-limits'), law },
        ...{ first: 1, generations: 0, runs: [run] },
        summary: { gains: [quartiles, quartiles, quartiles], finalRandom: quartiles },
      }),
    )
      .columns.join()
      .replaceAll('\u00a0', ' ');
  for (const law of /** @type {const} */ (['shim-kim', 'kanayama']))
    for (const unit of gainUnits[law])
      assert.ok(columnsOf(law).includes(`(${unit.replace('^2', '²')})`), `${law}: ${columnsOf(law)}`);
});

test('a contest says that a drive from many starts counts as one', () => {
  const asked = { seeds: 15, budget: 1000 };
  for (const words of [en, ko]) {
    assert.equal(words.asOne(1), '');
    assert.doesNotMatch(words.contestInvitation(asked, 1), /32/);
    assert.match(words.contestInvitation(asked, 32), /32/);
  }
});

test('a result from before does not tell what the paper’s gains cost where they are hidden', () => {
  const result = { generations: 50, paper: { gains: [1, 2, 3], cost: 7.935 } };
  const state = /** @type {any} */ ({
    slices: { [luckSlice.name]: { ...luckSlice.first, result } },
    exercise: noExercise,
    maker: firstMaker,
  });
  assert.equal(surveyOf(state), result);
  const hiding = { ...state, exercise: { ...noExercise, hidden: ['paper'] } };
  const shownThen = /** @type {any} */ (surveyOf(hiding));
  assert.equal(surveyOf(hiding), shownThen);
  assert.match(en.curveLabel(/** @type {any} */ (result), ''), /7\.935/);
  assert.doesNotMatch(en.curveLabel(shownThen, ''), /7\.935|paper/);
});

test('a name stands where its line is farthest from the median, of the places where it covers no other', () => {
  const candidates = [10, 60, 110, 160].map((x, i) => ({ x, y: 100, apart: i }));
  const at = (/** @type {{ left: number, right: number, y: number }[]} */ ...taken) =>
    placeWhereAlone(candidates, 50, taken).x;
  assert.equal(at(), 160);
  assert.equal(at({ left: 200, right: 300, y: 104 }), 110);
  assert.equal(at({ left: 200, right: 300, y: 120 }), 160);
  assert.equal(at({ left: 200, right: 300, y: 104 }, { left: 0, right: 150, y: 90 }), 160);
});

pageTest(
  'no name in the curve of the seeds lies on another, and before they run it says what will stand there',
  async (page) => {
    await page.resize(1366, 768);
    await page.evaluate(() => {
      const spied = /** @type {{ written: any[] }} */ (/** @type {unknown} */ (window));
      spied.written = [];
      const { clearRect, fillText } = CanvasRenderingContext2D.prototype;
      const begin = (/** @type {CanvasRenderingContext2D} */ { canvas }) => {
        spied.written = spied.written.filter((one) => one.canvas !== canvas);
      };
      Object.assign(CanvasRenderingContext2D.prototype, {
        clearRect(/** @type {any[]} */ ...args) {
          begin(/** @type {any} */ (this));
          return clearRect.apply(this, /** @type {any} */ (args));
        },
        fillText(/** @type {string} */ text, /** @type {number} */ x, /** @type {number} */ y) {
          const { canvas, textAlign } = /** @type {any} */ (this);
          const { width } = /** @type {any} */ (this).measureText(text);
          if (textAlign === 'left') spied.written.push({ canvas, text, left: x, right: x + width, y });
          return fillText.call(this, text, x, y);
        },
      });
    });
    const written = () =>
      page.evaluate(() => {
        const canvas = document.querySelector('#luck-curve canvas');
        const { written: all } = /** @type {{ written: any[] }} */ (/** @type {unknown} */ (window));
        return all
          .filter((one) => one.canvas === canvas)
          .map(({ text, left, right, y }) => ({ text: String(text), left, right, y }));
      });
    await page.click('#page-luck');
    await page.until('the part is open', () => document.getElementById('luck')?.hidden === false);
    const idle = (await written()).map(({ text }) => text).join(' ');
    assert.ok(idle.includes(en.expectedText) && idle.includes(en.generationAxis), idle);
    await page.click('#luck-count option[value="20"]');
    await page.click('#luck-generations option[value="50"]');
    await page.click('#luck-run');
    await page.until('the seeds have run', () => document.getElementById('luck-seed')?.hidden === false);
    await page.focus('#luck-rank');
    for (const key of [Key.HOME, Key.END]) {
      await page.press(key);
      const names = await page.until(
        'the seed is named',
        (canvasOf) => {
          const { written: all } = /** @type {{ written: any[] }} */ (/** @type {unknown} */ (window));
          const own = all.filter((one) => one.canvas === document.querySelector(canvasOf));
          const seed = document.getElementById('luck-open')?.textContent?.match(/seed \d+/)?.[0];
          return (
            own.some(({ text }) => text === seed) &&
            own.map(({ text, left, right, y }) => ({ text: String(text), left, right, y }))
          );
        },
        '#luck-curve canvas',
      );
      assert.ok(!names.some(({ text }) => text === en.generationAxis || text === 'Here'));
      for (const [i, one] of names.entries())
        for (const other of names.slice(i + 1))
          assert.ok(
            one.right <= other.left || other.right <= one.left || Math.abs(one.y - other.y) >= 12,
            JSON.stringify([one, other]),
          );
    }
  },
);

pageTest(
  'the dots beside the curve are seeds, higher where J is, and drive when they are pressed',
  async (page) => {
    await page.click('#page-luck');
    await page.until('the part is open', () => document.getElementById('luck')?.hidden === false);
    await page.click('#luck-count option[value="20"]');
    await page.click('#luck-generations option[value="50"]');
    await page.click('#luck-run');
    await page.until('the seeds have run', () => document.getElementById('luck-seed')?.hidden === false);
    const runs = seedRuns(experiment('velocity-limits'), { seeds: [1, 21], generations: 50 });
    const { left, height } = await page.evaluate(() => {
      const canvas = /** @type {HTMLElement} */ (document.querySelector('#luck-curve canvas'));
      const box = canvas.getBoundingClientRect();
      const begins = Array.from({ length: Math.round(box.width) }, (_, x) => x).find((x) => {
        const at = { clientX: box.left + x, clientY: box.top + box.height / 2 };
        canvas.dispatchEvent(new PointerEvent('pointermove', at));
        return canvas.classList.contains('pressable');
      });
      return { left: begins ?? 0, height: box.height };
    });
    /** @type {number[]} */
    const named = [];
    for (let y = 24; y < height - 20; y += 10) {
      await page.drag('#luck-curve canvas', [{ x: left + 18, y }]);
      named.push(Number(/seed (\d+)/.exec(await page.text('#luck-open'))?.[1]));
    }
    // The lab's own, before any is met.
    const seeds = [...new Set(named)].slice(1);
    const costs = seeds.map((seed) => runs[seed - 1].champion.cost);
    assert.ok(costs.length >= 4, `${seeds}`);
    assert.deepEqual(
      costs,
      [...costs].sort((a, b) => b - a),
    );
    await page.click('#page-lab');
    const { champion } = runs[named[named.length - 1] - 1];
    const { cost, gains, driver } = await read(page);
    assert.deepEqual([driver, cost, gains], ['hand', shown(champion.cost), shownGains(champion.gains)]);
  },
);

test('with a seed that both searches end alike nobody has won', () => {
  const run = { best: Float64Array.of(8), random: Float64Array.of(8) };
  const champion = { gains: /** @type {const} */ ([1, 1, 1]), cost: 8 };
  assert.equal(summaryOf([/** @type {any} */ ({ ...run, champion })]).randomWins, 0);
});
