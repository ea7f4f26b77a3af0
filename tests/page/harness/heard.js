/** Waits until the lab, or the open part, says this of its own accord. @param {import('./browsers.js').Page} page @param {string} pattern */
export const hears = (page, pattern) =>
  page.until(
    `it says ${pattern}`,
    (wanted) => new RegExp(wanted).test(document.getElementById('announcer')?.textContent ?? ''),
    pattern,
  );
