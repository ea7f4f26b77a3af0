// What is said of its own accord to who cannot see the page.
/** @typedef {import('./browsers.js').Page} Page */

/** From now on it is remembered. @param {Page} page */
export const listen = (page) =>
  page.evaluate(() => {
    const region = /** @type {HTMLElement} */ (document.getElementById('announcer'));
    /** @type {string[]} */
    const heard = [];
    new MutationObserver(() => heard.push(region.textContent ?? '')).observe(region, { childList: true });
    Object.assign(window, { heard });
  });

/** Waits until this is what was said last. @param {Page} page @param {string} pattern */
export const hears = (page, pattern) =>
  page.until(
    `it says ${pattern}`,
    (wanted) =>
      new RegExp(wanted).test(
        /** @type {{ heard: string[] }} */ (/** @type {unknown} */ (window)).heard
          .filter((text) => text !== '')
          .at(-1) ?? '',
      ),
    pattern,
  );
