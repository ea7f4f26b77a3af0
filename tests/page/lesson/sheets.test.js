// The sheets for a class: shown in a window of their own, and printed.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { asOnPaper } from '../whole/on-paper.js';

pageTest(
  'what is shown to a class opens in a window of its own, the next item in the same one, and the notes stay',
  async (page) => {
    await page.open('#lesson&lang=ko&step=lecturers');
    const { driver } = page;
    const own = await driver.getWindowHandle();
    const press = (/** @type {string} */ item) => page.click(`li:has([data-try="${item}"]) .sheet-apart`);
    const isShown = (/** @type {string} */ link) =>
      page.until(
        link,
        (wanted) =>
          location.hash.startsWith(wanted) &&
          document.documentElement.dataset.ready === 'true' &&
          document.getElementById('lesson')?.hidden &&
          document.documentElement.lang === 'ko',
        link,
      );
    await press('demonstration-park');
    let handles = [own];
    while (handles.length < 2) handles = await driver.getAllWindowHandles();
    const [shown] = handles.filter((handle) => handle !== own);
    await driver.switchTo().window(shown);
    try {
      await isShown('#lab&v=1&lang=ko&drives=hand&gains=3,0,0');
      await page.evaluate(() => document.body.classList.add('followed'));
      await driver.switchTo().window(own);
      await press('demonstration-landscape');
      assert.equal((await driver.getAllWindowHandles()).length, 2);
      await page.until('the notes stay', () => location.hash.includes('&lesson=lecturers'));
      await driver.switchTo().window(shown);
      await isShown('#landscape&v=1&lang=ko&generation=30');
      assert.ok(await page.evaluate(() => document.body.classList.contains('followed')), 'not loaded again');
      await driver.close();
    } finally {
      await driver.switchTo().window(own);
    }
  },
);

pageTest(
  'the addresses on a printed sheet lead to what it sets up, not to the lecturers’ page',
  async (page) => {
    await page.open('#lesson&step=lecturers');
    await asOnPaper(page);
    const links = await page.evaluate(() =>
      [
        .../** @type {NodeListOf<HTMLAnchorElement>} */ (document.querySelectorAll('.sheet-list li > a')),
      ].flatMap((link) => (link.checkVisibility() ? [[link.href, link.textContent ?? '']] : [])),
    );
    assert.ok(links.length > 20);
    for (const [href, text] of links) {
      assert.doesNotMatch(href, /lesson=lecturers/);
      assert.ok(text.endsWith(href), `${text} for ${href}`);
    }
  },
);

pageTest('a list that was not printed is not printed with the next', async (page) => {
  await page.open('#lesson&step=lecturers');
  const marked = await page.evaluate(() => {
    window.print = () => {};
    const buttons = [...document.querySelectorAll('.sheet-list-head button')].slice(0, 2);
    for (const button of buttons) /** @type {HTMLButtonElement} */ (button).click();
    return [...document.querySelectorAll('.sheet-list')].flatMap((list, i) =>
      list.classList.contains('to-print') ? [i] : [],
    );
  });
  assert.deepEqual(marked, [1]);
});

pageTest('a frame may open no window, and paper none: neither offers one', async (page) => {
  const seen = () =>
    page.evaluate(
      () => [...document.querySelectorAll('.sheet-apart')].filter((one) => one.checkVisibility()).length,
    );
  await page.open('?embed#lesson&step=lecturers');
  assert.equal(await seen(), 0);
  await page.open('#lesson&step=lecturers');
  assert.ok((await seen()) > 20);
  await page.evaluate(() => {
    for (const rule of [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]))
      if (rule instanceof CSSMediaRule && rule.media.mediaText === 'print') rule.media.mediaText = 'all';
  });
  assert.equal(await seen(), 0);
});
