// A page as it is on paper, and what is drawn there.
/** @typedef {import('../harness/browsers.js').Page} Page */

/** About the width of an A4 sheet between its margins. */
export const paper = 680;
/** As high as a sheet of Letter between its margins, the lower of the two. */
export const sheet = 960;

/** From now on the rules for paper hold on the screen, where one can look. */
export const turnToPaper = () => {
  dispatchEvent(new Event('beforeprint'));
  let found = 0;
  const rules = [...document.styleSheets].flatMap((sheet) => [...sheet.cssRules]);
  for (const rule of rules)
    if (rule instanceof CSSMediaRule && rule.media.mediaText === 'print') {
      rule.media.mediaText = 'all';
      found += 1;
    } else if (rule instanceof CSSMediaRule && rule.media.mediaText.startsWith('screen'))
      rule.media.mediaText = 'not all';
  return found;
};
export const asOnPaper = (/** @type {Page} */ page) => page.evaluate(turnToPaper);

/** What is seen on paper before anything is drawn again, as a printer waits for no frame. @template T @param {Page} page @param {() => T} look @returns {Promise<T>} */
export const printed = (page, look) =>
  page.driver.executeScript(`(${turnToPaper})();
    for (const sheet of document.styleSheets)
      for (const rule of sheet.cssRules)
        if (rule.media?.mediaText.startsWith('(min-width: 1')) rule.media.mediaText = 'not all';
    return (${look})();`);

/** What is drawn and seen, by its place among all. @param {Page} page */
export const canvasesIn = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('main canvas')].flatMap((canvas, i) => (canvas.checkVisibility() ? i : [])),
  );
