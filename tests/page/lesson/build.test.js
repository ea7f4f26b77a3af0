// What one takes along to build it oneself is right.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { checkValues } from '../../../www/lesson/views/check-values.js';
import { rateAmounts } from '../../../www/lesson/formulas/formulas-motion.js';
import { build as en } from '../../../www/lesson/words/en/build.js';
import { drive } from '../../../www/lesson/words/en/drive.js';
import { build as ko } from '../../../www/lesson/words/ko/build.js';
import { pathLength, stepNames } from '../../../www/lesson/path.js';
import { titles } from '../../../www/words/en/lesson.js';
import { phases } from '../../../www/parts/generation/state.js';
import { findProgram, pythons } from '../harness/engines.js';
import { pageTest } from '../harness/browsers.js';
import { experiment, lawTerms, paper, paperGains, simulate } from '../harness/core.js';
import { questionsOf } from '../../../www/lesson/views/predictions.js';
import { steps } from '../../../www/lesson/steps.js';
import { engine } from './links.js';
import { answered } from './live.js';
import { test } from '../harness/once.js';

const files = new URL('../../../www/lesson/files/', import.meta.url);
const ep = simulate(experiment('velocity-limits'), paperGains('velocity-limits', 'ep'));
const arbitrary = simulate(experiment('velocity-limits'), paperGains('velocity-limits', 'arbitrary'));

/** The numbers that a program prints. @param {string} command @param {string} file */
function printedBy(command, file) {
  const text = execFileSync(command, [fileURLToPath(new URL(file, files))], { encoding: 'utf8' });
  return [...text.matchAll(/\d+\.\d+(?:e-?\d+)?/g)].map(([number]) => Number(number));
}

/** Whether what a program prints is what the core says. @param {readonly number[]} numbers */
function agrees([cost, time, other, otherTime, ...evolved]) {
  for (const [own, core] of [
    [cost, ep.cost.total],
    [time, ep.finalTime],
    [other, arbitrary.cost.total],
    [otherTime, arbitrary.finalTime],
  ])
    assert.ok(Math.abs(own / core - 1) < 1e-9, `${own} for ${core}`);
  assert.ok(
    evolved.some((number) => number > 7.6 && number < 8.5),
    `evolution came to ${evolved}`,
  );
}

test('the file in JavaScript drives and evolves as the core does', () =>
  agrees(printedBy(process.execPath, 'park.mjs')));

const python = findProgram(pythons);
test(
  'the file in Python drives and evolves as the core does',
  { skip: !python && 'there is no Python' },
  () => agrees(printedBy(String(python), 'park.py')),
);

test('the numbers to check with are the core’s', () => {
  const usual = experiment('velocity-limits');
  const gains = paperGains('velocity-limits', 'ep');
  const { linear, angular } = Object.values(
    lawTerms(usual, gains, { x: 2 * Math.SQRT2, y: 0, theta: Math.PI / 4 }).command,
  ).reduce((a, b) => ({ linear: a.linear + b.linear, angular: a.angular + b.angular }), {
    linear: 0,
    angular: 0,
  });
  const [v, w, time, cost, other] = checkValues(engine, paper());
  assert.ok(Math.abs(v - linear) < 1e-9 && Math.abs(w - angular) < 1e-9, `${v} ${linear} ${w} ${angular}`);
  assert.deepEqual([time, cost, other], [ep.finalTime, ep.cost.total, arbitrary.cost.total]);
  for (const { values } of [en, ko]) assert.equal(values.rows.length, 5);
});

test('every phase has its lines, the same in both languages', () => {
  for (const part of /** @type {const} */ (['drive', 'generation']))
    assert.deepEqual(
      ko.program[part].map(([depth, phase]) => [depth, phase]),
      en.program[part].map(([depth, phase]) => [depth, phase]),
    );
  const named = new Set([...en.program.drive, ...en.program.generation].map(([, phase]) => phase));
  for (const phase of phases) assert.ok(named.has(phase), phase);
});

test('the seven terms of the rate of V come to what the law promises, pair by pair', () => {
  for (const [gains, error] of /** @type {const} */ ([
    [[3, 1, 5], { x: 2, y: 0.5, theta: 0.4 }],
    [[2, 7, 0.3], { x: -1, y: 1.5, theta: -2 }],
  ])) {
    const [kx, steep, cross, ky, kt, lessSteep, lessCross] = rateAmounts(gains, error);
    assert.equal(steep + lessSteep, 0);
    assert.equal(cross + lessCross, 0);
    const { x, y, theta } = error;
    const [s, c] = [Math.sin(theta), Math.cos(theta)];
    for (const [own, term] of [
      [steep, (gains[1] * x * y ** 3 * c) / s],
      [cross, gains[0] * x * y * s * c],
    ])
      assert.ok(Math.abs(own - term) < 1e-9 * (1 + Math.abs(term)));
    const { promised } = lawTerms(experiment('velocity-limits'), [...gains], error);
    for (const [own, core] of [
      [kx, promised?.x],
      [ky, promised?.y],
      [kt, promised?.theta],
    ])
      assert.ok(Math.abs(Number(own) - Number(core)) < 1e-9 * (1 + Math.abs(Number(own))));
  }
});

test('where sin θe is 0 the seven terms are divided as the law does it, and of no gain they are 0', () => {
  for (const [gains, error] of /** @type {const} */ ([
    [[3, 0, 5], { x: 2, y: 2, theta: 0 }],
    [[3, 1, 5], { x: 2, y: -2, theta: 0 }],
    [[3, 1, 5], { x: 2, y: 0, theta: 0 }],
    [[3, 1, 5], { x: 1, y: 0.1, theta: -1e-9 }],
  ])) {
    const [kx, steep, cross, ky, kt, lessSteep, lessCross] = rateAmounts(gains, error);
    const { x, y, theta } = error;
    const divided = (gains[1] * x * y ** 3) / (theta < 0 ? -1e-6 : 1e-6);
    assert.ok(Math.abs(steep - divided) <= 1e-9 * Math.abs(divided), `${steep} for ${divided}`);
    assert.equal(steep + lessSteep, 0);
    assert.equal(cross + lessCross, 0);
    for (const [own, term] of [
      [kx, -gains[0] * x ** 2],
      [ky, -gains[1] * y ** 4],
      [kt, 0],
      [cross, 0],
    ])
      assert.ok(Math.abs(own - term) < 1e-8, `${own} for ${term}`);
  }
  assert.ok(rateAmounts([3, 1, 5], { x: Number.NaN, y: 0, theta: 0 }).every(Number.isNaN));
});

pageTest('the phase that the figure shows lights its lines', async (page) => {
  await page.open('#lesson&step=build');
  const lit = () =>
    page.evaluate(() => [
      ...new Set(
        [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#program .now'))].map(
          ({ dataset }) => dataset.phase,
        ),
      ),
    ]);
  await page.until('the program', () => document.querySelector('#program .now'));
  assert.deepEqual(await lit(), ['parents']);
  await page.click('#generation-step button:last-child');
  await page.until('the next phase', () => document.querySelector('#program .now[data-phase="mutation"]'));
  assert.deepEqual(await lit(), ['mutation']);
});

test('the questions that are counted in the end are those of the path, in its order', () => {
  const asked = steps
    .slice(0, pathLength)
    .flatMap(({ name, blocks }, i) =>
      blocks.flatMap((block) => (block.kind === 'quiz' ? [[i + 1, `${name}.${block.name}`]] : [])),
    );
  const answers = Object.fromEntries(asked.map(([, key], i) => [key, { choice: i, right: 0, why: '' }]));
  assert.deepEqual(
    questionsOf(answers).map(({ number, answer }) => [number, asked[answer?.choice ?? -1]?.[1]]),
    asked,
  );
});

pageTest('the last step says how often one was right, and leads to what came otherwise', async (page) => {
  const all = questionsOf({}).length;
  const { outcome } = await answered('drive', 'bolder');
  const { choices } = drive.quizzes.bolder;
  const goTo = (/** @type {number} */ step) => page.click(`#lesson-step option[value="${step}"]`);
  const told = () => page.evaluate(() => document.querySelector('.predictions:not([hidden])')?.textContent);
  /** @param {boolean} isRight */
  const predict = async (isRight) => {
    await goTo(1);
    await page.until('the question', () => document.querySelector('#quiz-bolder'));
    const text = choices[(outcome.right + Number(!isRight)) % choices.length];
    for (const choice of await page.elements('#quiz-bolder .choice'))
      if ((await choice.getText()).includes(text)) await choice.click();
    await page.until('the answer', () => document.querySelector('#quiz-bolder .choice.right'));
    await goTo(pathLength);
  };
  await page.open(`#lesson&step=${stepNames[pathLength - 1]}`);
  await page.setPace(20);
  assert.equal(await told(), null);
  await predict(false);
  assert.ok((await told())?.includes(en.predictions.counts({ all, answered: 1, right: 0 })));
  await page.click('.predictions a');
  await page.until(
    'the step of the question',
    (title) => document.getElementById('lesson-title')?.textContent === title,
    titles.drive,
  );
  await page.click('#quiz-bolder .link');
  await predict(true);
  assert.ok((await told())?.includes(en.predictions.counts({ all, answered: 1, right: 1 })));
  assert.deepEqual(await page.elements('.predictions a'), []);
});

pageTest(
  'the last step says that the path ends, and leads to Park and to the place for lecturers',
  async (page) => {
    await page.open('#lesson&step=duel');
    const ends = () => page.evaluate(() => document.querySelector('.lesson-end')?.textContent ?? '');
    assert.equal(await ends(), '');
    await page.open(`#lesson&step=${stepNames[pathLength - 1]}`);
    assert.match(await ends(), /That was the path/);
    await page.click('.lesson-end a[href*="lecturers"]');
    await page.until(
      'the place',
      (title) => document.getElementById('lesson-title')?.textContent === title,
      titles.lecturers,
    );
    assert.equal(await ends(), '');
    await page.evaluate(() => history.back());
    await page.until('the end of the path again', () => document.querySelector('.lesson-end'));
    await page.click('.lesson-end a[href^="#park"]');
    await page.until(
      'Park',
      () => document.body.dataset.open === 'park' && document.getElementById('lesson')?.hidden,
    );
  },
);
