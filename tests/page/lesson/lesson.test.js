import assert from 'node:assert/strict';
import { hrefOf, linkOfStep } from '../../../www/lesson/path.js';
import { steps } from '../../../www/lesson/steps.js';
import { en as english, ko as korean } from '../harness/words.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { driven, linkOf, opened, samples } from './links.js';
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
    assert.equal(opened(`lesson&step=${i + 1}`).lesson, i + 1);
    for (const block of blocks) {
      const links = block.kind === 'tries' ? block.tries.map(([, to]) => to) : [];
      if (block.kind === 'quiz' && block.quiz.shows) links.push(block.quiz.shows);
      for (const to of [link, ...links]) assert.equal(opened(hrefOf(to, i + 1).slice(1)).lesson, i + 1, to);
    }
  }
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
  const miss = driven(steps[0].link);
  assert.equal(miss.outcome, 'horizon');
  assert.ok(Math.hypot((miss.x.at(-1) ?? 0) - 2, (miss.y.at(-1) ?? 0) - 2) > 0.5);
  assert.ok(
    driven('lab&drives=hand&gains=4,0,4').cost.total < driven('lab&drives=paper-arbitrary').cost.total,
  );
  // Equal times, other J.
  assert.equal(driven('lab&drives=paper-ep').arrived, true);
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
    const frame = () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    for (const selector of all) {
      const found = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(selector));
      if (found.length !== 1) throw new Error(`${selector} finds ${found.length} elements`);
      found[0].click();
      await frame();
    }
    return document.getElementById('lesson-title')?.textContent;
  }, selectors);

for (const [i, { name, blocks }] of steps.entries())
  pageTest(`step ${i + 1}, ${name}: every try pressed, every question answered`, async (page) => {
    await page.open(`#lesson&step=${i + 1}`);
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
      await pressAll(page, [`#${id} .choice:first-child`]);
      const why = await page.until(
        `an answer to ${name}.${block.name}`,
        (quiz) => document.querySelector(`#${quiz} .quiz-why strong`)?.parentElement?.innerText,
        id,
      );
      assert.doesNotMatch(String(why), /undefined|NaN|–/, `${name}.${block.name}`);
      const right = await page.evaluate((quiz) => document.querySelectorAll(`#${quiz} .right`).length, id);
      assert.equal(right, 1, `${name}.${block.name}`);
    }
    await page.open(`#lesson&step=${i + 1}`);
    await page.until('every number in the text', () =>
      [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#lesson [data-value]'))].every(
        (element) => element.textContent !== '–',
      ),
    );
    assert.deepEqual(await page.problems(), []);
    const fits = await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth);
    assert.equal(fits, true, `${name} is not wider than the window`);
  });

pageTest('the lesson leads on and back, and a link of it opens there again', async (page) => {
  await page.open('');
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

engineTest('a symbol that is pointed at lights up in formula and picture', async (page) => {
  await page.open('#lesson&step=2');
  const lit = () =>
    page.evaluate(() => ({
      formula: document.querySelectorAll('#lesson .formula .lit').length,
      picture: document.querySelectorAll('#error-posture .lit').length,
    }));
  assert.deepEqual(await lit(), { formula: 0, picture: 0 });
  await page.evaluate(() =>
    document
      .querySelector('#lesson .formula [data-term="ye"]')
      ?.dispatchEvent(new PointerEvent('pointerover', { bubbles: true })),
  );
  const now = await lit();
  assert.ok(now.formula >= 1 && now.picture >= 2, JSON.stringify(now));
});

/** What one sees of the figure, and where it stands. @param {Page} page */
const sight = (page) =>
  page.evaluate(async () => {
    for (let i = 0; i < 2; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
    const figure = /** @type {HTMLElement} */ (document.querySelector('.figure'));
    const { top, bottom } = figure.getBoundingClientRect();
    const shown = ['plane', 'stability-picture', 'gains', 'sights'].filter((id) => {
      const box = document.getElementById(id)?.getBoundingClientRect();
      return box && box.height > 20 && box.top >= top - 1 && box.bottom <= bottom + 1;
    });
    return { shown, isOnTop: top === 0, share: Math.round((10 * (bottom - top)) / innerHeight) };
  });

engineTest('where there is no room beside the words, what they speak of stays over them', async (page) => {
  await page.resize(800, 900);
  await page.open('#lesson&step=4');
  const atTheEnd = () =>
    page.evaluate(() => document.querySelector('.lesson-foot')?.scrollIntoView({ block: 'end' }));
  await atTheEnd();
  assert.deepEqual(await sight(page), { shown: ['stability-picture', 'sights'], isOnTop: true, share: 5 });
  for (const [name, shown] of /** @type {const} */ ([
    ['gains', ['plane', 'gains', 'sights']],
    ['robot', ['plane', 'sights']],
    ['part', ['stability-picture', 'sights']],
  ])) {
    await page.click(`#sights-${name}`);
    assert.deepEqual((await sight(page)).shown, shown, name);
  }
  await page.click('#sights-robot');
  await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('.step-on')).click());
  await page.until(
    'the next step, with what it speaks of',
    (title) =>
      document.getElementById('lesson-title')?.textContent === title &&
      /** @type {HTMLInputElement} */ (document.getElementById('sights-part')).checked,
    en.titles.limits,
  );
  await page.resize(1280, 900);
  const { shown } = await sight(page);
  assert.ok(shown.includes('plane') && !shown.includes('sights'), shown.join());
});
