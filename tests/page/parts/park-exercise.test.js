// The parking place in an exercise: what leads away from it leads nowhere that the exercise does not.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { slide } from './parking.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** From an exercise to Park, where evolution comes to its end. @param {Page} page @param {string} exercise */
async function evolvedIn(page, exercise) {
  await page.open(`#lab&v=1&task=Do%20it&aim=J<8;drives<=9000&drives=hand&gains=3,1,5${exercise}`);
  await page.click('#page-park');
  await page.until('Park is open', () => document.getElementById('park-kx')?.checkVisibility());
  await page.setPace(50);
  await slide(page, 'ky', 3);
  await page.click('#park-evolve');
  await page.until('evolution has come to its end', () => document.getElementById('park-between'));
}

/** What leads away. @param {Page} page */
const ways = (page) =>
  page.evaluate(() =>
    ['park-lesson', 'park-lab', 'park-watch'].filter((id) => document.getElementById(id)?.checkVisibility()),
  );

pageTest(
  'from Park an exercise goes on in the step of the lesson that makes a generation by hand',
  async (page) => {
    await evolvedIn(page, '&lock=clock');
    await page.click('#park-lesson');
    await page.until('the lesson is open', () => document.querySelector('#lesson:not([hidden]) h2'));
    assert.equal(await page.text('#lesson h2'), 'One generation by hand');
    assert.equal(await page.text('#task'), 'Do it');
    const address = await page.evaluate(() => decodeURIComponent(location.hash));
    for (const pair of ['task=Do it', 'aim=J<8;drives<=9000', 'lock=clock'])
      assert.ok(address.includes(pair), `${pair} in ${address}`);
  },
);

pageTest('where an exercise holds what a link of Park would change there is no such link', async (page) => {
  await evolvedIn(page, '');
  await page.focus('.park-plane');
  await page.press(Key.ARROW_RIGHT);
  await page.until('one robot is looked at', () => document.getElementById('park-watch'));
  assert.deepEqual(await ways(page), ['park-lesson', 'park-lab', 'park-watch']);
  /** @type {readonly (readonly [exercise: string, left: readonly string[]])[]} */
  const held = [
    ['lock=lesson', ['park-lab', 'park-watch']],
    ['hide=lesson', ['park-lab', 'park-watch']],
    ['hide=paper', ['park-lab', 'park-watch']],
    ['lock=gains', ['park-lesson', 'park-lab']],
    ['hide=gains', ['park-lesson', 'park-lab']],
    ['lock=run', ['park-lesson', 'park-watch']],
    ...['parts', 'postures', 'settings', 'seed', 'drives'].map(
      (group) => /** @type {const} */ ([`lock=${group}`, ['park-lesson']]),
    ),
    ['lock=clock', ['park-lesson', 'park-lab', 'park-watch']],
  ];
  for (const [exercise, left] of held) {
    await page.evaluate((asked) => {
      location.hash = `park&v=1&task=${encodeURIComponent(asked)}&${asked}`;
    }, exercise);
    await page.until(
      'it is opened',
      (task) => document.getElementById('task')?.textContent === task,
      exercise,
    );
    assert.deepEqual(await ways(page), left, exercise);
    const [isBetween, hasKey] = await page.evaluate(() =>
      ['#park-between', '.park-key'].map((one) => document.querySelector(one)?.checkVisibility() === true),
    );
    assert.deepEqual([isBetween, hasKey], Array(2).fill(exercise !== 'hide=gains'), exercise);
    await page.click('#keep-button');
    await page.until('Share is there', () => document.querySelector('#keep #keep-link'));
    const isShared = await page.evaluate(() => document.getElementById('keep-lab') !== null);
    assert.equal(isShared, left.includes('park-lab'), `Share: ${exercise}`);
    await page.click('#keep-close');
  }
});
