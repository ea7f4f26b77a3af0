// Who leaves an exercise: its goal is moved, its limits are others. An answer counts in the exercise as it was given all the same.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { aimOf } from '../../../www/link/exercise.js';
import { withExercise } from '../../../www/link/link.js';
import { measure } from '../../../www/share/handin/measure.js';
import { isWhole, receiptOf } from '../../../www/share/handin/receipt.js';
import words from '../../../www/share/handin/words/index.js';
import { experiment, paper } from '../harness/core.js';
import { Key, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { engine, exercise, opened } from './hand-ins.js';

const tools = { engine, links, paper: paper() };
const byHand = '&drives=hand&gains=3.3,0,4.5';

test('a receipt from an exercise that was left is judged in the exercise, of which it still is', async () => {
  const given = await opened(`${exercise.replace('postures,', '')}${byHand}&who=s4711`);
  const left = { ...given, experiment: experiment({ goal: { x: 1, y: 1, theta: 0 } }) };
  const [own, other] = [await receiptOf(tools, given), await receiptOf(tools, left)];
  assert.equal(other.exercise, own.exercise);
  assert.deepEqual(other.judged, own.judged);
  assert.notEqual(other.cost, own.cost);
  assert.deepEqual([other.apart, other.there.cost], [['goal'], own.cost]);
  assert.match(words.receiptText(other), /as it was given \(changed here: goal\): J = /);
  assert.doesNotMatch(words.receiptText(own), /as it was given/);
  // Whoever opens it sees what was driven, and has the way back.
  const state = await opened(other.link);
  assert.ok(isWhole(state, engine, links));
  assert.deepEqual([state.experiment, state.student.base], [left.experiment, given.student.base]);
});

pageTest(
  'who leaves the exercise is told what is changed, and is judged in it as it was given; one press leads back',
  async (page) => {
    const apart = () => page.evaluate(() => document.querySelector('#aim-apart span')?.textContent ?? '');
    const measured = (/** @type {string} */ value) =>
      page.until(
        `${value} is measured`,
        (text) => document.querySelector('.aim:not(.late) .aim-value')?.textContent === text,
        value,
      );
    const valueIn = async (/** @type {string} */ link) => {
      const { value } = await measure(engine, aimOf('J<9'), (await opened(link)).experiment, [3.3, 0, 4.5]);
      return words.valueText({ kind: 'cost', below: 9 }, value);
    };
    for (const [given, control, changed] of [
      ['lab&v=1&goal.x=1.5&task=Park.&aim=J%3C9', '#restore-postures', /: goal\./],
      ['lab&v=1&task=Park.&aim=J%3C9&vary=goal,seed&who=s4711', '#restore-postures', /: goal\./],
      ['lab&v=1&task=Park.&aim=J%3C9&vary=goal,seed&who=s4711', '#new-seed', /: seed\./],
      ['lab&v=1&task=Park.&aim=J%3C9', '#preset-acceleration-limits', /: limits\./],
    ]) {
      const link = `${given}${byHand}`;
      await page.open(`#${link}`);
      const own = await valueIn(link);
      await measured(own);
      assert.equal(await apart(), '');
      await page.click(String(control));
      await page.until('it is told', () => document.getElementById('aim-apart'));
      assert.match(await apart(), /** @type {RegExp} */ (changed));
      await measured(own);
      // Its link has both, and so they stay.
      await page.until('the address leads back', () => /&given=/.test(location.hash));
      await page.driver.navigate().refresh();
      await page.until('it is told', () => document.getElementById('aim-apart'));
      await measured(own);
      assert.match(await apart(), /** @type {RegExp} */ (changed));
      await page.click('#back-to-exercise');
      await page.until('nothing is told', () => !document.getElementById('aim-apart'));
      await measured(own);
      const hash = await page.until('the address is the exercise', () =>
        location.hash.includes('given') ? null : location.hash.slice(1),
      );
      assert.deepEqual((await opened(hash)).experiment, (await opened(link)).experiment);
      assert.deepEqual(await page.problems(), [], `${link} ${control}`);
    }
  },
);

pageTest(
  'the lesson has others drive within an exercise that says who does; one press brings back who drives in it, and its generation',
  async (page) => {
    for (const { given, step } of [
      { given: 'lab&v=1&drives=hand&gains=3.3,0,4.5&lock=gains,drives&task=Park.&aim=J%3C9', step: 7 },
      { given: 'lab&v=1&generation=3&lock=run,gains,drives,seed&task=Park.&aim=J%3C9', step: 3 },
      // Nothing is judged.
      { given: 'lab&v=1&drives=hand&gains=3.3,0,4.5&lock=gains,drives&task=Park.', step: 7 },
    ]) {
      await page.open(`#${given}`);
      await page.until('it is all there', () => !document.querySelector('.aim.late'));
      await page.evaluate(
        (hash) => {
          location.hash = hash;
        },
        withExercise(links.linkOfStep(step), await opened(given), experiment),
      );
      await page.until('it is told', () =>
        document.querySelector('#aim-apart span')?.textContent?.includes('what drives'),
      );
      await page.driver.navigate().refresh();
      await page.until('it is told', () => document.getElementById('aim-apart'));
      await page.click('#back-to-exercise');
      await page.until('nothing is told', () => !document.getElementById('aim-apart'));
      const hash = await page.until('the address is the exercise', () =>
        location.hash.includes('given') ? null : location.hash.slice(1),
      );
      const [before, after] = await Promise.all([opened(given), opened(hash)]);
      for (const field of /** @type {const} */ (['driver', 'handGains', 'generation', 'experiment']))
        assert.deepEqual(after[field], before[field], `${given} ${field}`);
      assert.deepEqual(await page.problems(), []);
    }
  },
);

pageTest('in Park the aim stays in sight, with what is said of it and the way to the lab', async (page) => {
  const aim = () => page.evaluate(() => document.getElementById('aim')?.innerText ?? '');
  const away = () => page.evaluate(() => document.getElementById('aim-away')?.innerText ?? '');
  await page.open('#lab&v=1&task=Park.&aim=parks:28/32;drives<=100&points=16:0,32:10');
  await page.until('it can be handed in', () => document.getElementById('hand-in'));
  assert.equal(await away(), '');
  // Where what is said has two lines, none begins with what divides it.
  await page.until('it is measured', () => document.querySelectorAll('#aim .muted').length === 3);
  const dividers = await page.evaluate(() =>
    [...document.querySelectorAll('#aim .muted')].map((one) =>
      ['::before', '::after'].map((side) => getComputedStyle(one, side).content),
    ),
  );
  assert.deepEqual(dividers, [
    ['none', '" ·"'],
    ['none', '" ·"'],
    ['none', 'none'],
  ]);
  await page.click('#page-park');
  await page.until('it is told', () => document.getElementById('aim-away'));
  assert.equal(await aim(), 'parks from 28 of 32 starts, within 100 drives');
  assert.match(await away(), /^What is tried in Park is not handed in\./);
  assert.equal(await page.evaluate(() => document.getElementById('hand-in')), null);
  await page.focus('#aim-to-lab');
  await page.press(Key.ENTER);
  await page.until('it goes on in the lab', () => document.activeElement?.id === 'hand-in');
  assert.equal(await page.evaluate(() => document.body.dataset.open), 'lab');
  assert.equal(await away(), '');
  // Before anything is drawn, too; and no way where the exercise has none.
  await page.open('#park&v=1&aim=J<9&vary=goal&lock=parts');
  await page.until('it is told', () => document.getElementById('aim-away'));
  assert.equal(await aim(), 'J below 9');
  assert.equal(await page.evaluate(() => document.querySelector('#work-who, #aim-to-lab')), null);
  await page.open('#park&v=1&hide=settings');
  await page.until('it is locked', () => document.getElementById('exercise-locks')?.textContent);
  assert.deepEqual([await aim(), await away()], ['', '']);
  assert.deepEqual(await page.problems(), []);
});
