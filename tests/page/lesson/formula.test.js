// What a formula reads with the numbers of now.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';

const steps = ['error', 'law', 'stability', 'cost', 'generation', 'sigma', 'disturbance'];

pageTest('with numbers every product has its sign, and what is below zero its brackets', async (page) => {
  let below = 0;
  for (const step of steps) {
    await page.open(`#lesson&step=${step}`);
    const { lines, unsigned } = await page.evaluate(async () => {
      for (const button of document.querySelectorAll('.formula-button'))
        button.dispatchEvent(new Event('click'));
      for (let i = 0; i < 2; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
      const isSign = (/** @type {Element} */ one) => one.localName === 'mo' && one.textContent !== '(';
      const unsigned = [...document.querySelectorAll('.formula-now mrow > * + *')].filter((one) =>
        [one, one.previousElementSibling].every((of) => of && !isSign(of) && of.textContent !== '('),
      );
      const opening = [...document.querySelectorAll('.formula-now mo')].filter(
        ({ textContent, previousElementSibling: before }) => textContent === '(' && before && !isSign(before),
      );
      return {
        lines: [...document.querySelectorAll('.formula-now mtr')].map((line) => line.textContent ?? ''),
        unsigned: [...unsigned, ...opening].map(({ parentElement }) => parentElement?.textContent),
      };
    });
    assert.ok(lines.length > 0, step);
    assert.deepEqual(unsigned, [], step);
    for (const line of lines) {
      assert.doesNotMatch(line, /[·+−\u2061]−|\u2062/, line);
      below += line.split('(−').length - 1;
    }
  }
  assert.ok(below > 0, 'some number is below zero');
});
