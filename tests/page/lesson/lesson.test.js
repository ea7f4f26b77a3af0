import assert from 'node:assert/strict';
import { lockedIn } from '../../../www/lesson/duel/duel.js';
import { progressOf, textOf } from '../../../www/lesson/keepsake.js';
import { links } from '../../../www/lesson/links.js';
import {
  hrefOf,
  linkOfStep,
  pathLength,
  stepNamed,
  stepNames,
  textOfStep,
} from '../../../www/lesson/path.js';
import { noProgress, noTally } from '../../../www/lesson/state.js';
import { steps } from '../../../www/lesson/steps.js';
import { named } from '../../../www/parts/parts.js';
import { en as english, ko as korean } from '../harness/words.js';
import { Key, pageTest } from '../harness/browsers.js';
import { driven, engine, linkOf, opened, samples } from './links.js';
import { test } from '../harness/once.js';

/** @type {any} */
const en = english.lesson;
/** @type {any} */
const ko = korean.lesson;

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/lesson/steps.js').Content} Content */

/** @template {Content['kind']} K @param {K} kind @returns {Extract<Content, { kind: K }>[]} */
const blocksOf = (kind) =>
  steps.flatMap(({ blocks }) =>
    blocks.filter((block) => block.kind === kind).map((block) => /** @type {any} */ (block)),
  );

test('every link of the lesson opens without a complaint', () => {
  for (const [i, { link, blocks }] of steps.entries()) {
    opened(linkOfStep(i + 1));
    for (const block of blocks) {
      const links = block.kind === 'tries' ? block.tries.map(([, to]) => to) : [];
      if (block.kind === 'quiz' && block.quiz.shows) links.push(block.quiz.shows);
      for (const to of [link, ...links]) assert.equal(opened(hrefOf(to, i + 1).slice(1)).lesson, i + 1, to);
    }
  }
});

test('links of the first edition open the step that holds its content; one that is gone opens the nearest and says so', () => {
  const first = [
    ...['drive', 'error', 'law', 'stability', 'limits', 'cost', 'generation', 'sigma', 'duel'],
    ...['landscape', 'task', 'disturbance', 'paper', 'lecturers'],
  ];
  for (const [i, name] of first.entries()) {
    for (const link of [`lesson&step=${i + 1}`, `lab&v=1&lesson=${i + 1}`, `lab&v=1&lesson=${name}`])
      assert.equal(stepNames[opened(link).lesson - 1], name, link);
  }
  for (const [i, name] of stepNames.entries()) {
    assert.equal(opened(linkOfStep(i + 1)).lesson, i + 1, name);
    assert.equal(stepNamed(textOfStep(i + 1)).number, i + 1, name);
  }
  for (const [link, name] of [
    ['lab&v=1&lesson=99', 'build'],
    ['lesson&step=40', 'build'],
    ['lab&v=1&lesson=gone', 'drive'],
    ['lesson&step=gone', 'drive'],
  ]) {
    const { opened: run, problems } = links.openLink(link, engine);
    assert.equal(stepNames[run.lesson - 1], name, link);
    assert.equal(problems.length, 1, link);
    assert.match(problems[0], /has no step (99|40|gone), so the nearest/);
  }
  assert.equal(opened('lab&v=1&lesson=0').lesson, 0);
  // Who counts to the last step comes to it.
  assert.equal(opened(`lesson&step=${pathLength}`).lesson, pathLength);
});

test('what the tab keeps is read back, and nothing else is believed', () => {
  const tally = { ...noTally, experiment: '{}', drives: 2, costs: [9, Number.POSITIVE_INFINITY] };
  const progress = {
    ...noProgress,
    answers: {
      'drive.bolder': { choice: 1, right: 1, why: 'so' },
      'law.beside': { choice: 0, right: null, why: '' },
    },
    tallies: [tally],
  };
  const back = progressOf(textOf(progress), engine);
  assert.deepEqual(back.answers, { 'drive.bolder': progress.answers['drive.bolder'] });
  assert.deepEqual(back.tallies, [tally]);
  const wrong = { answers: { a: { choice: 'x' } }, tallies: [], duel: null };
  assert.equal(progressOf(JSON.stringify(wrong), engine), noProgress);
  const duel = lockedIn(tally, engine.experiment('velocity-limits'));
  // What was said in another language is kept for who comes back to it.
  const answers = { 'drive.bolder': { ...progress.answers['drive.bolder'], said: 'xx' } };
  const other = progressOf(textOf({ ...progress, answers, duel }), engine);
  assert.deepEqual(other, { ...noProgress, answers, tallies: [tally], duel });
  const read = (/** @type {object} */ kept) =>
    progressOf(JSON.stringify({ answers: {}, tallies: [], duel: null, ...kept }), engine);
  assert.deepEqual(read({ tallies: [{ costs: ['x'] }], duel: { costs: 1 } }), { ...noProgress });
  assert.deepEqual(read({ tallies: [{ ...tally, best: { gains: [1], cost: 1 } }] }), noProgress);
  assert.deepEqual(read({ duel: { ...duel, gains: 3 } }), noProgress);
  assert.throws(() => read({ duel: { ...duel, experiment: { evolution: null } } }));
});

test('there are at least twelve questions, and words for all that a step shows', () => {
  assert.ok(blocksOf('quiz').length >= 12, `${blocksOf('quiz').length} questions`);
  for (const [language, { steps: words, titles }] of Object.entries({ en, ko }))
    for (const { name, blocks } of steps) {
      /** @type {any} */
      const step = words[name];
      const where = `${language} ${name}`;
      assert.ok(titles[name], where);
      for (const block of blocks) {
        if (block.kind === 'text') assert.ok(step.texts[block.name], `${where}: text ${block.name}`);
        if (block.kind === 'notice') assert.ok(step.notice.length >= 2, `${where}: notice`);
        if (block.kind === 'tries')
          for (const [key] of block.tries) assert.ok(step.tries[key], `${where}: try ${key}`);
        if (block.kind === 'quiz') {
          const { question, choices, why } = step.quizzes[block.name];
          assert.ok(question && choices.length >= 2 && why, `${where}: question ${block.name}`);
        }
      }
    }
});

test('both languages have the same live values and symbols', () => {
  const marks = (/** @type {unknown} */ words) =>
    [...JSON.stringify(words).matchAll(/\{=\w+\}/g)].map(([mark]) => mark).sort();
  for (const { name } of steps)
    assert.deepEqual(
      [...new Set(marks(ko.steps[name].texts))],
      [...new Set(marks(en.steps[name].texts))],
      name,
    );
});

test('what is said of its drives is so', () => {
  const [arbitrary, ep] = ['paper-arbitrary', 'paper-ep'].map((driver) => driven(`lab&drives=${driver}`));
  assert.ok(ep.cost.total < arbitrary.cost.total);
  assert.ok(driven('lab&drives=hand&gains=4,0,4').cost.total < ep.cost.total, 'both can be beaten by hand');
  const opening = driven(steps[0].link);
  assert.ok(
    opening.cost.total > arbitrary.cost.total && Math.abs(opening.finalTime) > 1,
    'there is something to do',
  );
  const miss = driven(linkOf(steps[0], 'stops'));
  assert.equal(miss.outcome, 'horizon');
  assert.ok(Math.hypot((miss.x.at(-1) ?? 0) - 2, (miss.y.at(-1) ?? 0) - 2) > 0.5);
});

test('turned wrong by 90° on the goal the robot turns on the spot, and only θe changes', () => {
  const { experiment, handGains } = opened(linkOf(steps[1], 'turned'));
  assert.ok(handGains);
  const all = samples(experiment, handGains);
  assert.ok(Math.abs(all[0].error.theta - Math.PI / 2) < 1e-9);
  for (const { error } of all) assert.ok(Math.hypot(error.x, error.y) < 1e-9);
  assert.equal(all[all.length - 1].outcome, 'arrived');
});

/** Presses within the page, one after the other, each seen drawn before the next. @param {Page} page @param {readonly string[]} selectors */
const pressAll = (page, selectors) =>
  page.evaluate(async (all) => {
    for (const selector of all) {
      const found = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(selector));
      if (found.length !== 1) throw new Error(`${selector} finds ${found.length} elements`);
      found[0].click();
      await pageFrames.settled();
    }
    return document.getElementById('lesson-title')?.textContent;
  }, selectors);

for (const [i, { name, blocks }] of steps.entries())
  pageTest(`step ${i + 1}, ${name}: every try pressed, every question answered`, async (page) => {
    await page.open(`#lesson&step=${name}`);
    await page.until('every number in the text', () =>
      [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#lesson [data-value]'))].every(
        ({ textContent }) => !/[–…]/.test(textContent ?? ''),
      ),
    );
    const fits = await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
    assert.equal(fits, true, `${name} is not wider than the window`);
    const title = en.titles[name];
    const triesOf = blocks.flatMap((block) => (block.kind === 'tries' ? block.tries : []));
    assert.equal(
      await pressAll(
        page,
        triesOf.map(([key]) => `[data-try="${key}"]`),
      ),
      title,
    );
    for (const block of blocks) {
      if (block.kind !== 'quiz') continue;
      const id = `quiz-${block.name}`;
      // What is asked once somebody has driven.
      if (block.quiz.opens) {
        await pressAll(page, [`[data-try="${triesOf[0][0]}"]`]);
        await page.focus('#slider-kx');
        await page.press(Key.ARROW_LEFT);
      }
      await pressAll(page, [`#${id} .choice:first-child`]);
      const why = await page.until(
        `an answer to ${name}.${block.name}`,
        (quiz) => document.querySelector(`#${quiz} .quiz-why strong`)?.parentElement?.innerText,
        id,
      );
      assert.doesNotMatch(String(why), /undefined|NaN|–/, `${name}.${block.name}`);
      const right = await page.evaluate((quiz) => document.querySelectorAll(`#${quiz} .right`).length, id);
      assert.equal(right, 1, `${name}.${block.name}`);
      const unlocked = `#${id} .choice:not([aria-disabled="true"])`;
      assert.equal((await page.elements(unlocked)).length, 0, `${name}.${block.name} is answered`);
    }
    // Whatever a question uncovers has its words.
    assert.doesNotMatch(await page.text('#lesson'), /undefined|NaN|\[object/);
    assert.deepEqual(await page.problems(), []);
  });

pageTest('the lesson leads on and back, and a link of it opens there again', async (page) => {
  await page.open('#lesson');
  const stands = (/** @type {string} */ title) =>
    page.until(title, (wanted) => document.getElementById('lesson-title')?.textContent === wanted, title);
  await stands(en.titles.drive);
  await page.click('.step-on');
  await stands(en.titles.error);
  await page.evaluate(() => history.back());
  await stands(en.titles.drive);
  await page.click('#page-curves');
  await page.until('the lesson is closed', () => document.getElementById('lesson')?.hidden);
  await page.click('#page-lesson');
  await stands(en.titles.drive);
  const hash = await page.until('the link', () => location.hash.includes('lesson=1') && location.hash);
  await page.open(hash);
  await stands(en.titles.drive);
});

pageTest('the focus and the title of the page go with the step', async (page) => {
  await page.open('#lesson');
  const usual = () => page.evaluate(() => document.title);
  const stands = (/** @type {string} */ title, /** @type {string} */ id) =>
    page.until(
      `${title}, where the focus is on ${id}`,
      (wanted, focused) => document.title.startsWith(wanted) && document.activeElement?.id === focused,
      title,
      id,
    );
  await page.focus('.step-on');
  await page.press(Key.ENTER);
  await stands(`2 ${en.titles.error}`, 'lesson-title');
  await page.click('.lesson-head [aria-label^="Next: "]');
  await stands(`3 ${en.titles.law}`, 'lesson-title');
  await page.click('.lesson-head [aria-label^="Back: "]');
  await page.focus('#lesson-step');
  await page.press(Key.ARROW_DOWN);
  await stands(`3 ${en.titles.law}`, 'lesson-step');
  await page.press(Key.ARROW_DOWN);
  await stands(`4 ${en.titles.stability}`, 'lesson-step');
  await page.click('#page-lab');
  await page.until('the lesson is closed', () => document.getElementById('lesson')?.hidden);
  const { texts } = english.lab;
  assert.equal(await usual(), `${named.lab.name} · ${texts.pageTitle}`);
  await page.click('#page-curves');
  await page.until('the curves are open', () => document.body.dataset.open === 'curves');
  assert.equal(await usual(), `${named.curves.name} · ${texts.pageTitle}`);
});
