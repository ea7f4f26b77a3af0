// Luck where random search itself is what runs with many seeds.
import assert from 'node:assert/strict';
import { namesOf } from '../../../www/parts/luck/curve-names.js';
import * as en from '../../../www/parts/luck/words/en.js';
import * as ko from '../../../www/parts/luck/words/ko.js';
import { pageTest } from '../harness/browsers.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';

test('random search is not compared with itself', () => {
  for (const words of [en, ko])
    for (const method of /** @type {const} */ (['ep', 'random'])) {
      const survey = {
        experiment: { evolution: { method } },
        runs: [],
        generations: 50,
        summary: {
          final: { median: 8, most: 9 },
          finalRandom: { median: 8.5 },
          randomWins: 0,
          overtakes: 40,
        },
      };
      const told = words.finding(/** @type {any} */ (survey));
      assert.equal(told.includes('8.500'), method === 'ep', told);
    }
});

test('nor are there two of it: it is named once, and its drives are not told twice', () => {
  const [evolution, random] = /** @type {const} */ (['ep', 'random']).map((method) => {
    const usual = experiment('velocity-limits');
    return { ...usual, evolution: { ...usual.evolution, method } };
  });
  const band = { low: [1], median: [1], high: [1] };
  const frame = { top: 0 };
  for (const [run, lines] of /** @type {const} */ ([
    [evolution, [en.randomLine, en.evolutionLine]],
    [random, [en.randomLine]],
  ])) {
    const summary = { evolution: band, random: band };
    const paper = { gains: /** @type {[number, number, number]} */ ([1, 1, 1]), cost: Number.NaN };
    const named = namesOf({ experiment: run, generations: 0, summary, paper }, (cost) => 100 - cost, frame);
    assert.deepEqual(
      named.map(({ text }) => text),
      lines,
    );
  }
  for (const [words, evolves, searches] of /** @type {const} */ ([
    [en, /evolv/, /random search/],
    [ko, /진화/, /무작위 탐색/],
  ])) {
    assert.match(words.invitation(evolution, 20, 50, 1020), evolves);
    assert.doesNotMatch(words.invitation(random, 20, 50, 1020), evolves);
    assert.match(words.invitation(random, 20, 50, 1020), searches);
    assert.match(words.invitation(random, 20, 50, 1020), /1.?020/);
    const survey = /** @type {any} */ ({
      experiment: random,
      runs: Array(20),
      drives: 1020,
      milliseconds: 300,
    });
    assert.match(words.surveyNote(survey), /1.?020/);
    assert.doesNotMatch(words.surveyNote(survey), /2 ×/);
  }
});

pageTest('its picture and its words speak of nothing beside it', async (page) => {
  for (const [method, heads] of /** @type {[string, string[]][]} */ ([
    ['random', [en.randomHead]],
    ['ep', [en.evolutionHead, en.randomHead]],
  ])) {
    await page.open(`#luck&v=1&evolution.method=${method}&runs=20&length=50`);
    await page.evaluate(() => {
      /** @type {string[]} */
      const drawn = [];
      const write = CanvasRenderingContext2D.prototype.fillText;
      CanvasRenderingContext2D.prototype.fillText = function (text, ...more) {
        drawn.push(text);
        return write.call(this, text, ...more);
      };
      Object.assign(window, { drawn });
    });
    await page.click('#luck-run');
    const drawn = await page.until('the seeds have run', () => {
      const { drawn } = /** @type {{ drawn: string[] }} */ (/** @type {unknown} */ (window));
      return document.getElementById('luck-seed')?.hidden === false && drawn.includes('random') && drawn;
    });
    for (const head of [en.evolutionHead, en.randomHead])
      assert.equal(drawn.includes(head), heads.includes(head), `${method}: ${head}`);
    assert.equal((await page.text('#luck-note')).includes('2 ×'), method === 'ep');
    assert.deepEqual(await page.problems(), []);
  }
});
