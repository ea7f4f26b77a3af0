// What the page saves as a file.

/** Presses a button of the dialog and returns the text of the file that is saved. @param {import('./browsers.js').Page} page @param {string} button */
export function saved(page, button) {
  return page.evaluate(async (selector) => {
    const create = URL.createObjectURL;
    /** @type {Promise<string>} */
    const text = new Promise((resolve) => {
      // Some are saved a little later.
      URL.createObjectURL = (blob) => {
        URL.createObjectURL = create;
        /** @type {Blob} */ (blob).text().then(resolve);
        return create(blob);
      };
    });
    /** @type {HTMLElement} */ (document.querySelector(selector)).click();
    return text;
  }, button);
}
