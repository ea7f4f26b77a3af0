// What workers of the page hear, so that work is under way for as long as a test needs it.

/** @typedef {import('./browsers.js').Page} Page */

/** From now on no worker hears what it is to do: it is under way until it is stopped. @param {Page} page @param {number} [most] parts that are heard of before */
export const holdWorkers = (page, most = 0) =>
  page.evaluate((free) => {
    const { prototype } = Worker;
    const { postMessage } = prototype;
    let heard = 0;
    prototype.postMessage = function (/** @type {object} */ message) {
      const isOutfit = 'core' in message;
      if (!isOutfit) heard += 1;
      if (heard <= free) postMessage.call(this, message);
    };
    addEventListener('workers-hear', () => Object.assign(prototype, { postMessage }), { once: true });
  }, most);

/** From now on what workers are asked waits until they hear again. @param {Page} page */
export const delayWorkers = (page) =>
  page.evaluate(() => {
    const { prototype } = Worker;
    const { postMessage } = prototype;
    /** @type {(() => void)[]} */
    const waiting = [];
    prototype.postMessage = function (/** @type {any[]} */ ...asked) {
      waiting.push(() => Reflect.apply(postMessage, this, asked));
    };
    const hear = () => {
      Object.assign(prototype, { postMessage });
      for (const ask of waiting) ask();
    };
    addEventListener('workers-hear', hear, { once: true });
  });

/** From now on they hear again what is asked then. @param {Page} page */
export const releaseWorkers = (page) => page.evaluate(() => dispatchEvent(new Event('workers-hear')));

/** From now on no worker can be started, and `window.refused` counts how often one was wanted. @param {Page} page */
export const blockWorkers = (page) =>
  page.evaluate(() => {
    const { Worker } = window;
    Object.assign(window, { refused: 0 });
    window.Worker = /** @type {typeof Worker} */ (
      /** @type {unknown} */ (
        class {
          constructor() {
            /** @type {{ refused: number }} */ (/** @type {unknown} */ (window)).refused += 1;
            throw new Error('blocked');
          }
        }
      )
    );
    addEventListener('workers-start', () => Object.assign(window, { Worker }), { once: true });
  });

/** From now on they can. @param {Page} page */
export const allowWorkers = (page) => page.evaluate(() => dispatchEvent(new Event('workers-start')));
