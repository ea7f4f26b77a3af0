// Where the reference moves nobody arrives: Training and Robustness say so, and do not count who does.
import assert from 'node:assert/strict';
import * as robustness from '../../../www/parts/robustness/words/en.js';
import { setNames } from '../../../www/parts/training/sets.js';
import * as en from '../../../www/parts/training/words/en.js';
import * as ko from '../../../www/parts/training/words/ko.js';
import { Key, pageTest } from '../harness/browsers.js';

pageTest(
  'where the reference moves nobody is said to arrive or not, and mean J is compared',
  async (page) => {
    for (const language of ['en', 'ko']) {
      await page.open(`#training&v=1&lang=${language}&referenceVelocity.linear=0.5&evolve=50&population=4`);
      await page.until('the paper’s rows are there', () =>
        /\d/.test(document.querySelector('#training-paper-ep .training-cost')?.textContent ?? ''),
      );
      const words = language === 'en' ? en : ko;
      assert.equal(await page.text('#training-finding'), words.tracking);
      await page.click('#training-evolve');
      await page.until(
        'evolution ends',
        (text) => document.getElementById('training-evolve')?.innerText === text,
        words.evolveAgain,
      );
      const { costs, ...said } = await page.evaluate(() => {
        const textsOf = (/** @type {string} */ selector) =>
          [...document.querySelectorAll(selector)].map((cell) => cell.textContent);
        return {
          shares: textsOf('#training-table .training-seen, #training-table strong'),
          costs: textsOf('.training-cost').slice(0, 3),
          finding: textsOf('#training-finding')[0] ?? '',
          titles: textsOf('#training-seen-title, #training-unseen-title'),
          signs: document.querySelectorAll('.training-sign').length,
        };
      });
      assert.ok(said.shares.length >= 10 && said.shares.every((share) => share === '–'), `${said.shares}`);
      assert.equal(said.signs, 0);
      // The lowest of them drives.
      const least = costs.map(Number).indexOf(Math.min(...costs.map(Number)));
      const starts = [1, 32, 36][least];
      assert.deepEqual(said.titles, [
        words.trainingTitle(setNames[least], null, starts),
        words.unseenTitle(null, 1000),
      ]);
      for (const cost of costs) assert.ok(cost && said.finding.includes(cost), said.finding);
    }
  },
);

pageTest('a moving reference is followed, and a random disturbance drawn for each start', async (page) => {
  await page.open('#robustness&v=1&referenceVelocity.linear=0.5&disturbance.kind=random');
  await page.until('the map is there', () =>
    /starts in/.test(document.getElementById('robustness-note')?.textContent ?? ''),
  );
  assert.equal(await page.text('#robustness-share'), '–');
  assert.equal(await page.text('#robustness-summary'), robustness.tracking);
  assert.equal(await page.text('#robustness-rival'), '');
  assert.equal(await page.text('.survey-ring'), robustness.ownDraws(18, true));
  const readout = () => page.text('#robustness-readout');
  assert.match(await readout(), /follows the reference for 10 s, J/);
  await page.focus('#robustness-map');
  await page.press(Key.ARROW_RIGHT);
  assert.match(await readout(), /^x [^:]*\. Press: watch .*, the highest J of all\.$/);
  await page.press(Key.ENTER);
  assert.match(await readout(), /You watch .*: follows the reference for 10 s\. Press again/);
});
