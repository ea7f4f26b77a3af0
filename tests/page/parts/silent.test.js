// A file that never comes, as where a network falls silent, holds nothing else back, and one can try again.
import { long } from '../../../www/lab/waiting.js';
import { longest } from '../../../www/parts/load.js';
import { pageTest } from '../harness/browsers.js';
import { serve } from '../harness/server.js';

/** Nobody waits for what is silent; and, once it is said, not for the page itself. */
const impatient = `
  const later = window.setTimeout.bind(window);
  window.setTimeout = (act, time, ...given) => later(act, [${longest}, ${long}].includes(time) ? 0 : time, ...given);
  const until = AbortSignal.timeout.bind(AbortSignal);
  AbortSignal.timeout = (time) => until(window.isSilent ? 1 : time);`;

/** In a frame, for the tests wait for what is still being loaded. @param {import('../harness/browsers.js').Page} page @param {string} src */
const openFrame = (page, src) =>
  page.evaluate((address) => {
    const frame = document.createElement('iframe');
    Object.assign(frame, { src: address, width: '1000', height: '700' });
    document.body.replaceChildren(frame);
  }, src);

/** @param {import('../harness/browsers.js').Page} page @param {string} selector What is seen in the frame. @param {string} [text] */
const isSeen = (page, selector, text = '') =>
  page.until(
    `${selector} ${text} is seen`,
    (one, said) => {
      const found = document.querySelector('iframe')?.contentDocument?.querySelector(one);
      return found?.checkVisibility() && found.textContent?.includes(said);
    },
    selector,
    text,
  );

/** @param {import('../harness/browsers.js').Page} page @param {string} selector @param {boolean} [isSilent] */
const press = (page, selector, isSilent = false) =>
  page.evaluate(
    (one, silent) => {
      const inside = document.querySelector('iframe')?.contentWindow;
      Object.assign(inside ?? {}, { isSilent: silent });
      /** @type {HTMLElement | null | undefined} */ (inside?.document.querySelector(one))?.click();
    },
    selector,
    isSilent,
  );

pageTest('where the open part never comes the rest opens without it, and one can try again', async (page) => {
  const never = new Promise(() => {});
  let isSilent = false;
  /** @type {(name: string, content: Buffer) => boolean} */
  const isLuck = (name, content) => /page-.*\.js$/.test(name) && content.includes('luck-finding');
  let waits = true;
  const site = await serve(undefined, {
    before: impatient,
    send: async (name, content) => {
      if (isSilent || (waits && isLuck(name, content))) await never;
      return content;
    },
  });
  try {
    await page.visit(site.blank);
    await openFrame(page, `${site.address}#luck`);
    await isSeen(page, '[data-page="luck"] > .part-waits', 'To try again');
    await press(page, '#page-lab');
    await isSeen(page, '#one-generation');
    await press(page, '#page-luck');
    isSilent = true;
    await press(page, '.part-waits + button', true);
    await isSeen(page, '[data-page="luck"]', 'Still not there.');
    isSilent = false;
    waits = false;
    await press(page, '.part-waits + button');
    await isSeen(page, '#luck-run');
  } finally {
    await page.leave();
    await site.close();
  }
});
