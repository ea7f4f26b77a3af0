// Where there is room for one thing only, what one is told to watch is that.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { linkOfStep, stepNames } from '../../../www/lesson/path.js';

/** @typedef {import('../../../www/lesson/path.js').StepName} StepName */

/** @type {[step: StepName, pressed: [selector: string, sight: string][]][]} */
const steps = [
  ['drive', [['#quiz-bolder .choice:first-child', 'robot']]],
  [
    'task',
    [
      ['[data-try="beside"]', 'robot'],
      ['[data-try="training"]', 'part'],
      ['[data-try="withKy"]', 'robot'],
    ],
  ],
];

pageTest(
  'on a telephone what a question or a try is about comes into sight, one after another',
  async (page) => {
    await page.resize(390, 844);
    for (const [name, pressed] of steps) {
      await page.open(`#${linkOfStep(stepNames.indexOf(name) + 1)}`);
      for (const [selector, sight] of pressed) {
        const link = await page.evaluate((selector) => {
          const one = /** @type {HTMLElement} */ (document.querySelector(selector));
          one.click();
          return one.getAttribute('href') ?? '';
        }, selector);
        const part = link.match(/^#(\w+)/)?.[1] ?? '';
        const height = await page.until(
          `${selector} shows ${sight}`,
          (sight, part) => {
            const isThere = part === '' || document.body.dataset.open === part;
            const seen = document.querySelector(
              sight === 'robot' ? '#plane' : `section[data-page="${part}"]`,
            );
            return (
              isThere && document.body.dataset.sight === sight && seen?.checkVisibility() && seen.clientHeight
            );
          },
          sight,
          part,
        );
        assert.ok(height >= 300, `${selector}: ${height}`);
      }
    }
  },
);
