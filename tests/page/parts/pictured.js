// What samples of several parts need for their pictures.

/** @typedef {import('../harness/browsers.js').Page} Page */

export const plane = {
  name: 'The plane',
  key: 'plane',
  texts: ['0 m', 'Goal 2.00 m, 2.00 m, 45°'],
  lines: 6,
};

/** @param {Page} page @param {string} id @param {string} beginning */
export const textOf = (page, id, beginning) =>
  page.until(
    `#${id} says ${beginning}`,
    (element, text) =>
      document.getElementById(element)?.textContent?.replace(/\s/g, ' ').startsWith(text) ?? false,
    id,
    beginning,
  );
