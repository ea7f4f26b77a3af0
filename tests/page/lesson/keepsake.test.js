// What the tab keeps of the lesson is there whatever of the page is open.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';

pageTest(
  'answers are handed in also where the page was loaded again while no step was open',
  async (page) => {
    await page.open('#lab&v=1&lesson=9&who=s1&task=Answer%20all.&aim=J%3C9');
    await page.until('the question', () => document.querySelector('#quiz-ahead .choice'));
    await page.click('#quiz-ahead .choice:nth-child(2)');
    await page.until('it is answered', () => document.querySelector('#quiz-ahead .quiz-why strong'));
    await page.click('#page-landscape');
    await page.until('no step is in the address', () => /^#landscape(?!.*lesson=)/.test(location.hash));
    await page.driver.navigate().refresh();
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.click('#hand-in');
    const receipt = await page.until(
      'the receipt',
      () => /** @type {HTMLInputElement | null} */ (document.getElementById('handin-link'))?.value,
    );
    assert.match(decodeURIComponent(receipt), /~duel\.ahead:\d[+-]~/);
  },
);
