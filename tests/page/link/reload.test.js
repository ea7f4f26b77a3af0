// A page that is loaded again before its address tells of it opens as it was left.
import assert from 'node:assert/strict';
import { setTimeout as delay } from 'node:timers/promises';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** From here on the address of this page is not written. @param {Page} page */
const holdAddress = (page) =>
  page.evaluate(() => {
    history.pushState = history.replaceState = () => {};
  });

/** @param {Page} page */
const address = (page) => page.evaluate(() => location.href);

engineTest('what is loaded again at once is as it was left, with every drive that counts', async (page) => {
  const drives = (/** @type {string} */ wanted) =>
    page.until(
      wanted,
      (text) => document.querySelector('.aim:not(.late) .aim-drives')?.textContent === text,
      wanted,
    );
  const type = async (/** @type {string} */ digit) => {
    await holdAddress(page);
    const before = await address(page);
    await page.focus('#gain-kx');
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).select());
    await page.press('3', '.', digit, Key.ENTER);
    return before;
  };
  await page.open('#lab&v=1&drives=hand&gains=3.3,0,4.5&task=Few.&aim=J%3C9;drives%3C%3D3');
  await drives('0 of 3 drives');
  const before = await type('7');
  await drives('1 of 3 drives');
  assert.equal(await address(page), before);
  await page.driver.navigate().refresh();
  await drives('1 of 3 drives');
  await page.until(
    'it drives with what was typed',
    () => /** @type {HTMLInputElement} */ (document.getElementById('gain-kx')).value === '3.700',
  );

  // Who comes from elsewhere gets what the address says.
  const again = await type('8');
  await drives('2 of 3 drives');
  assert.equal(await address(page), again);
  await page.driver.get(page.site.blank);
  await page.driver.get(again);
  await drives('1 of 3 drives');

  await page.open('#lab&v=1');
  await holdAddress(page);
  for (let i = 0; i < 3; i += 1) await page.click('#one-generation');
  await page.driver.navigate().refresh();
  await page.until('generation 3 is shown', () => document.getElementById('generation')?.innerText === '3');
});

pageTest('nor is anything lost where the page goes on while a slow server sends it again', async (page) => {
  let isSlow = false;
  const site = await serve(undefined, {
    async send(name, content) {
      // Longer than a change waits to be in the address.
      if (isSlow && name === 'index.html') await delay(1500);
      return content;
    },
  });
  try {
    await page.visit(`${site.address}#lab&v=1`);
    await page.until('it is there', () => document.documentElement.dataset.ready === 'true');
    isSlow = true;
    await page.evaluate(() => {
      document.getElementById('one-generation')?.click();
      location.reload();
    });
    await page.until(
      'generation 1 is shown in what was loaded again',
      () =>
        performance.getEntriesByType('navigation').some(({ duration }) => duration > 1000) &&
        document.getElementById('generation')?.innerText === '1',
    );
    assert.match(await address(page), /generation=1/);
  } finally {
    await page.leave();
    await site.close();
  }
});

/** What the receipt says by now. @param {Page} page */
async function done(page) {
  await page.until('there is something to hand in', () => document.getElementById('hand-in'));
  await page.click('#hand-in');
  const text = await page.until(
    'the receipt is there',
    () => /** @type {HTMLTextAreaElement | null} */ (document.getElementById('handin-text'))?.value,
  );
  await page.press(Key.ESCAPE);
  const [, drives, minutes] = /(\d+) drives in (\d+) min/.exec(text) ?? [];
  return { drives: Number(drives), minutes: Number(minutes) };
}

pageTest('the work on an exercise goes on where the page is loaded again', async (page) => {
  await page.open('#lab&v=1&drives=hand&gains=3.3,0,4.5&task=Few.&aim=J%3C9&who=s1');
  const first = await done(page);
  assert.ok(first.drives === 0 && first.minutes < 500, JSON.stringify(first));
  for (const digit of ['2', '4']) {
    await page.focus('#gain-kx');
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).select());
    await page.press('3', '.', digit, Key.ENTER);
  }
  await page.evaluate(() => {
    const now = performance.now.bind(performance);
    performance.now = () => now() + 60_000_000;
  });
  for (let time = 0; time < 3; time += 1) {
    const { drives, minutes } = await done(page);
    const least = time < 2 ? 1000 : 3000;
    assert.ok(drives === 2 && minutes >= least, `${drives} drives in ${minutes} min, reload ${time}`);
    // The machine's clock is set back while the page is away, and then on: only time away can count.
    await page.evaluate(
      (ahead) => {
        const now = Date.now();
        Date.now = () => now + ahead;
      },
      time === 0 ? 180_000_000 : -120_000_000,
    );
    await page.driver.navigate().refresh();
  }
  const again = await address(page);
  await page.driver.get(page.site.blank);
  await page.driver.get(again);
  const anew = await done(page);
  assert.ok(anew.drives === 0 && anew.minutes < 500, JSON.stringify(anew));
});

pageTest('what another page has written where the tab keeps its own harms nothing', async (page) => {
  for (const written of [
    ['{}', '[1..2]'],
    ['5', '{}'],
    ['["lab",null]', '["x"]'],
  ]) {
    await page.open('#lesson&step=cost');
    await page.evaluate(([work, place]) => {
      sessionStorage.setItem('ep-locomotion work', work);
      sessionStorage.setItem('ep-locomotion place', place);
      // Else the page writes its own over it.
      Storage.prototype.setItem = () => {};
    }, written);
    await page.driver.navigate().refresh();
    await page.until(
      'the step is there',
      () =>
        performance
          .getEntriesByType('navigation')
          .some((entry) => 'type' in entry && entry.type === 'reload') &&
        document.querySelector('#lesson h2')?.checkVisibility(),
    );
  }
});
