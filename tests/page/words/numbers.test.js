import assert from 'node:assert/strict';
import { test } from '../harness/once.js';
import * as words from '../harness/words.js';
import * as inEnglish from '../../../www/words/en/numbers.js';
import * as inKorean from '../../../www/words/ko/numbers.js';
import * as contestInEnglish from '../../../www/parts/luck/words/contest-en.js';
import * as contestInKorean from '../../../www/parts/luck/words/contest-ko.js';
import * as numbers from '../../../www/words/numbers.js';

/** @type {Record<'en' | 'ko', any>} */
const { en, ko } = words;

test('every number is written as one, also what is none', () => {
  const { fixed, threeDigits, sixDigits, powerText, costText, signed } = numbers;
  const ways = [
    (/** @type {number} */ value) => fixed(value, 2),
    threeDigits,
    sixDigits,
    powerText,
    costText,
    (/** @type {number} */ value) => signed(value, 2),
  ];
  for (const value of [0, -0, 1e-300, 0.1, -7.25, 12345.678, -1e15, 1e21, -1e308, Infinity, -Infinity, NaN])
    for (const write of ways) {
      const text = write(value);
      assert.match(text, /^(?:−?\d+(?:\.\d+)?(?:×10⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)?|−?∞)$/, `${value}: ${text}`);
      assert.equal(text.includes('∞'), !Number.isFinite(value), `${value}: ${text}`);
    }
});

test('with a power of ten a number has the digits that count, and no others', () => {
  for (const [value, text] of /** @type {const} */ ([
    [1.797e308, '1.8×10³⁰⁸'],
    [-9.996e20, '−1×10²¹'],
    [1.25e-7, '1.25×10⁻⁷'],
  ]))
    assert.equal(numbers.powerText(value), text);
});

test('digits stand in groups as each language has them', () => {
  for (const whole of [0, 7, 999, 1000, -1234, 118_098, 2_097_152, 2 ** 53])
    assert.deepEqual(
      [en.lab.grouped(whole).replaceAll('\u202f', ','), ko.lab.grouped(whole)],
      [whole.toLocaleString('en'), whole.toLocaleString('ko')],
    );
});

test('seconds are told as short as they are exact', () => {
  const run = { outcome: 'horizon', referenceX: [0] };
  for (const [seconds, text] of /** @type {const} */ ([
    [10, '10'],
    [2, '2'],
    [1.5, '1.5'],
    [0.4, '0.4'],
    [3 * 0.1, '0.3'],
  ])) {
    assert.ok(en.lab.outcomeText({ ...run, finalTime: seconds }).includes(` ${text} s`));
    assert.ok(ko.lab.outcomeText({ ...run, finalTime: seconds }).includes(`${text}초`));
    assert.equal(en.disturbance.lastText(seconds), `last ${text} s`);
    assert.equal(ko.disturbance.lastText(seconds), `마지막 ${text}초`);
  }
});

test('with more starts than one the landscape says from which the J of a drive is', () => {
  const run = { cost: { total: 7.5 } };
  const [english, korean] = [en, ko].map(({ landscape }) => landscape.readout);
  assert.equal(english('', 'kx 1', run, 'arrives', true), 'kx 1: J 7.500 from the first start, arrives');
  assert.equal(english('', 'kx 1', run, 'arrives', false), 'kx 1: J 7.500, arrives');
  assert.equal(korean('', 'kx 1', run, '도착', true), 'kx 1: 첫 출발점에서 J 7.500, 도착');
});

test('a number that may be a thousand or one is none, and a comma is a point', () => {
  for (const [text, value] of /** @type {const} */ ([
    ['0,5', 0.5],
    ['0,125', 0.125],
    ['−3,25', -3.25],
    [' 1e3 ', 1000],
    ['1,000', Number.NaN],
    ['-10,000', Number.NaN],
    ['1,000,000.5', Number.NaN],
    ['', Number.NaN],
    // As the page itself writes thousands, with whatever space.
    ['118 098', 118098],
    ['1\u202f000\u00a0000.5', 1000000.5],
    // Two numbers, or nobody knows.
    ...['1 2', '1 0000', '3\t100', '3.5 100', '1234 567', '0 123', '1,234 567', '2e-1 000', '1e5 000'].map(
      (text) => /** @type {const} */ ([text, Number.NaN]),
    ),
    // From a Korean keyboard.
    ['−１２．５', -12.5],
    ['10²', Number.NaN],
    // As a word processor writes a minus.
    ['–3', -3],
  ]))
    assert.equal(numbers.numberOf(text), value, text);
});

test('why a comma is refused is said, and only where it is', () => {
  for (const { lab, settings, contest } of [
    { ...en, contest: contestInEnglish },
    { ...ko, contest: contestInKorean },
  ])
    for (const refused of [
      (/** @type {string} */ text) => lab.notANumber('kx', text),
      (/** @type {string} */ text) => settings.refused('x', '', text),
      (/** @type {string} */ text) => lab.untilRefused('cost', Number.NaN, text, 1, 9),
      (/** @type {string} */ text) => lab.untilRefused('generation', Number.NaN, text, 1, 9),
      contest.targetRefused,
    ])
      for (const [text, isSaid] of /** @type {const} */ ([
        ['7,465', true],
        ['−７，４６５', true],
        ['1,000,000', true],
        ['7,46', false],
        ['7,465x', false],
        ['', false],
      ]))
        assert.equal(/A comma|쉼표/.test(refused(text)), isSaid, refused(text));
});

test('a J that is told to be below another reads so', () => {
  const told = (/** @type {number} */ limit, /** @type {number} */ cost) =>
    [en, ko].map(
      ({ lab }) => /\d\.\d+/.exec(lab.reachedText(limit, { generation: 65, best: { cost } }))?.[0],
    );
  assert.deepEqual(told(7.73, 7.6), ['7.600', '7.600']);
  assert.deepEqual(told(7.73, 7.72966), ['7.72966', '7.72966']);
  assert.deepEqual(told(7.73, 7.72999987), ['7.72999987', '7.72999987']);
});

test('how long it took is told in milliseconds, and in seconds from one second on', () => {
  for (const [milliseconds, text] of /** @type {const} */ ([
    [4, '4 ms'],
    [999, '999 ms'],
    [1000, '1.0 s'],
    [36_462, '36.5 s'],
  ])) {
    assert.equal(inEnglish.tookText(milliseconds), text);
    assert.equal(inKorean.tookText(milliseconds), text.replace(/ s$/, '초'));
  }
});

test('two numbers that differ are told apart, and what is the same is said to be', () => {
  const statistics = (/** @type {number} */ cost) => ({ evaluations: 40, best: { cost } });
  const told = (/** @type {number} */ from, /** @type {number} */ to) =>
    [en, ko].map(({ lab }) => lab.progressText(statistics(from), statistics(to)));
  assert.match(
    told(11_822_967, 11_805_183).join(),
    /1\.1823×10⁷ to 1\.18052×10⁷.*1\.1823×10⁷ → 1\.18052×10⁷/,
  );
  assert.match(told(8.5494, 8.5491).join(), /8\.5494 to 8\.5491.*8\.5494 → 8\.5491/);
  assert.match(told(8.5494, 7.9).join(), /8\.549 to 7\.900.*8\.549 → 7\.900/);
  assert.match(told(8.5494, 8.5494).join(), /is still 8\.549.*변화 없음: 8\.549/);
});

test('the clock of a drive has as many digits as the drive has places', () => {
  const clocks = (/** @type {number} */ time, /** @type {number} */ end) =>
    [en, ko].map(({ lab }) => lab.clockText(time, end));
  assert.deepEqual(clocks(0.5, 1.53), ['0.50 of 1.53 s', '0.50 / 1.53초']);
  assert.deepEqual(clocks(0.0005, 0.001), ['0.0005 of 0.0010 s', '0.0005 / 0.0010초']);
  assert.deepEqual(clocks(0, 0), ['0.00 of 0.00 s', '0.00 / 0.00초']);
});

test('what the numbers of an axis count from is written whole, or says that it is not', () => {
  for (const [value, text] of /** @type {const} */ ([
    [0.00135, '0.00135'],
    [-0.0005, '−0.0005'],
    [3.09536, '3.09536'],
    [14.4895812, '14.489…'],
    [-1e-10, '−1×10⁻¹⁰'],
    [4, '4'],
  ]))
    assert.equal(en.generation.baseText(value), text);
});
