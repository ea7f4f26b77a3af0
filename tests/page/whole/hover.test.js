// What can be pressed answers the pointer that is over it.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Without a screen a browser has no pointer that hovers: the styles for one hold all the same. */
function hovering() {
  /** @param {CSSRuleList} rules */
  const apply = (rules) => {
    for (const rule of rules) {
      if (rule instanceof CSSMediaRule && /\(hover: hover\)/.test(rule.conditionText))
        rule.media.mediaText = 'all';
      if (rule instanceof CSSGroupingRule || rule instanceof CSSStyleRule) apply(rule.cssRules);
    }
  };
  for (const sheet of document.styleSheets) apply(sheet.cssRules);
}

/** @param {Page} page @param {string} selector */
const look = (page, selector) =>
  page.evaluate((one) => {
    const { color, borderColor, borderTopWidth, backgroundColor } = getComputedStyle(
      /** @type {Element} */ (document.querySelector(one)),
    );
    return [color, backgroundColor, borderTopWidth === '0px' || borderColor].join(', ');
  }, selector);

pageTest('what can be pressed looks otherwise under the pointer', async (page) => {
  if (page.engine !== 'chromium') return;
  /** @type {string[]} */
  const still = [];
  for (const [link, press, ...selectors] of [
    ['lab', '#settings-button', '#run', '#keep-button', '#fitness-table', '#pin', '#settings-close'],
    ['lesson&step=drive', '', '.lesson-way[href]:last-child', '.step-on', '.tries li:first-child .try'],
  ]) {
    await page.open(`#${link}`);
    if (press) await page.click(press);
    await page.evaluate(hovering);
    for (const selector of selectors) {
      const element = await page.element(selector);
      const before = await look(page, selector);
      await page.driver.actions().move({ origin: element }).perform();
      if ((await look(page, selector)) === before) still.push(selector);
    }
  }
  assert.deepEqual(still, []);
});

pageTest('headings are told apart by their size, not by their weight', async (page) => {
  await page.open('#lesson&step=paper');
  const weights = await page.until('both kinds are there', () => {
    const all = [...document.querySelectorAll('h1, #lesson h2, #lesson h3')];
    return all.some((one) => one.matches('h3')) && all.map((one) => getComputedStyle(one).fontWeight);
  });
  assert.deepEqual([...new Set(weights)], ['650']);
});
