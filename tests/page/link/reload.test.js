// A page that is loaded again before its address tells of it opens as it was left.
import { Key, engineTest } from '../harness/browsers.js';

engineTest('what is loaded again at once is as it was left, with every drive that counts', async (page) => {
  const drives = (/** @type {string} */ wanted) =>
    page.until(
      wanted,
      (text) => document.querySelector('.aim:not(.late) .aim-drives')?.textContent === text,
      wanted,
    );
  await page.open('#lab&v=1&drives=hand&gains=3.3,0,4.5&task=Few.&aim=J%3C9;drives%3C%3D3');
  await drives('0 of 3 drives');
  await page.focus('#gain-kx');
  await page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).select());
  await page.press('3', '.', '7', Key.ENTER);
  await drives('1 of 3 drives');
  await page.driver.navigate().refresh();
  await drives('1 of 3 drives');
  await page.until(
    'it drives with what was typed',
    () => /** @type {HTMLInputElement} */ (document.getElementById('gain-kx')).value === '3.700',
  );

  await page.open('#lab&v=1');
  for (let i = 0; i < 3; i += 1) await page.click('#one-generation');
  await page.driver.navigate().refresh();
  await page.until('generation 3 is shown', () =>
    /\b3\b/.test(document.getElementById('generation')?.innerText ?? ''),
  );
});
