// How many of something there may be, and which values an axis has, as docs/javascript.md says it.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';

const file = await readFile(new URL('../../../docs/javascript.md', import.meta.url), 'utf8');
const text = file.replace(/\s+/g, ' ');

/** The numbers that stand in the document in place of LEAST and MOST. @param {string} sentence @returns {[least?: string, most?: string]} */
function told(sentence) {
  const number = '\\d[\\d ]*';
  const found = text.match(
    new RegExp(sentence.replace('LEAST', `(?<least>${number})`).replace('MOST', `(?<most>${number})`)),
  );
  assert.ok(found, sentence);
  return [found.groups?.least, found.groups?.most];
}

const short = { horizon: 0.1, sampleTime: 0.1 };
const one = { from: 0, to: 1, count: 1 };
const kx = /** @type {const} */ ({ ...one, gain: 'kx' });
const ky = /** @type {const} */ ({ ...one, gain: 'ky' });

/** @type {Record<string, (count: number) => unknown>} */
const sentences = {
  '`starts` has LEAST to MOST postures': (n) => core.experiment({ ...short, starts: Array(n).fill({}) }),
  '`horizon` is at most MOST times `sampleTime`': (n) =>
    core.experiment({ horizon: n / 64, sampleTime: 1 / 64 }),
  '`evolution.population` is LEAST to MOST,': (population) => core.experiment({ evolution: { population } }),
  'from LEAST with the method `de`': (population) =>
    core.experiment({ evolution: { population, method: 'de' } }),
  'from LEAST with `cma-es`': (population) =>
    core.experiment({ evolution: { population, method: 'cma-es' } }),
  'axis of a landscape or of a grid has a `count` of LEAST to MOST,': (count) =>
    core.landscape(short, { x: { ...kx, count }, y: ky, gains: [1, 1, 1] }),
  'or of a grid has a `count` of LEAST to MOST,': (count) =>
    core.startsOnGrid({ x: { ...one, count }, y: one, headings: 1 }),
  'LEAST to MOST, a grid as many `headings`': (headings) => core.startsOnGrid({ x: one, y: one, headings }),
  'a circle a `count` of LEAST to MOST[.]': (count) =>
    core.startsOnCircle({ x: 0, y: 0, radius: 1, count, seed: 1 }),
  '`startsOnGrid` gives at most MOST starts': (n) =>
    core.startsOnGrid({ x: { ...one, count: 1024 }, y: one, headings: 1024, part: [0, n] }),
  'at most MOST gain triples': (n) => core.evaluate(short, new Float64Array(3 * n)),
};

test('so many of something as the document says are taken, and one beyond is refused', () => {
  for (const [sentence, ask] of Object.entries(sentences))
    for (const [i, number] of told(sentence).entries()) {
      if (number === undefined) continue;
      const edge = Number(number.replaceAll(' ', ''));
      assert.doesNotThrow(() => ask(edge), sentence);
      assert.throws(() => ask(i === 0 ? edge - 1 : edge + 1), /must be/, sentence);
    }
});

test('a linear axis has the values that the document says, to the bit', () => {
  assert.ok(text.includes('An axis of n values has `from * (1 - t) + to * t` with t = i / (n - 1) '));
  const n = 31;
  for (const [from, to] of [
    [0.1, 10],
    [7.3, 0.01],
    [3, 3.7],
  ]) {
    const gains = Array.from({ length: n }, (_, i) => {
      const t = i / (n - 1);
      return [from * (1 - t) + to * t, 0.1, 5];
    });
    const x = { ...kx, from, to, count: n };
    const y = { ...ky, from: 0.1, to: 0.1 };
    assert.deepEqual(core.landscape({}, { x, y, gains: [0, 0, 5] }), core.evaluate({}, gains.flat()));
  }
});
