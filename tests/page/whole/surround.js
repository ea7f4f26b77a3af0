// The page on another screen, and what is looked at there.
import { within } from '../harness/host.js';
import { setScreen, tellChromium } from '../harness/screen.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {readonly [number, number]} Size */

/** What each browser was last told, as text. @type {WeakMap<object, string>} */
const mediaOf = new WeakMap();

/** @param {Page} page @param {Record<string, string>} media */
async function setMedia(page, media) {
  const features = Object.entries(media).map(([name, value]) => ({ name, value }));
  const text = JSON.stringify(features);
  if ((mediaOf.get(page.driver) ?? '[]') === text) return;
  mediaOf.set(page.driver, text);
  await tellChromium(page, 'Emulation.setEmulatedMedia', { features });
}

/** In Chromium. @param {Page} page @param {Size} size @param {Record<string, string>} [media] */
export async function surround(page, [width, height], media = {}) {
  await setScreen(page, width, height);
  await setMedia(page, media);
}

/** As it was; each test begins with a size of its own. @param {Page} page */
export const endSurrounding = (page) => setMedia(page, {});

/** The page in a frame, which can be as small as a telephone where a window cannot. @param {Page} page @param {string} fragment @param {() => Promise<void>} body */
export async function inFrame(page, fragment, body) {
  await page.visit(page.site.blank);
  await page.evaluate((src) => {
    const frame = document.createElement('iframe');
    Object.assign(frame, { src, width: '1024', height: '768', frameBorder: '0' });
    // What is in it is measured; to paint it takes longer than that.
    frame.style.opacity = '0';
    document.body.append(frame);
  }, page.site.address + fragment);
  await within(page, 0, async () => {
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await body();
  });
}

/** @param {Page} page @param {Size} size */
export const resizeFrame = (page, [width, height]) =>
  page.evaluate(
    async (wide, high) => {
      Object.assign(/** @type {object} */ (frameElement), { width: wide, height: high });
      if (innerWidth !== wide || innerHeight !== high) throw new Error(`${innerWidth} × ${innerHeight}`);
      await pageFrames.settled();
    },
    width,
    height,
  );

/** Follows a link without loading the page again. @param {Page} page @param {string} link */
export const follow = (page, link) =>
  page.evaluate(async (hash) => {
    const opened = new Promise((resolve) => addEventListener('popstate', resolve, { once: true }));
    location.replace(hash);
    await opened;
  }, `#${link}`);

/** How far the page can be scrolled, to the right and down, once it has its new size. @param {Page} page */
export const excess = (page) =>
  page.evaluate(async () => {
    await pageFrames.settled();
    const { scrollWidth, scrollHeight } = document.documentElement;
    return [scrollWidth - innerWidth, scrollHeight - innerHeight];
  });

/** In the page: which pieces of the figure beside the words lie on each other, where none holds the other. @param {string} selector */
export function overlapping(selector) {
  const all = [...document.querySelectorAll(`.figure :is(${selector})`)]
    .filter((one) => one.checkVisibility())
    .map((one) => ({ one, name: one.id || one.className, box: one.getBoundingClientRect() }))
    .filter(({ box }) => box.width > 0 && box.height > 0);
  return all.flatMap(({ one, name, box }, i) =>
    all.slice(i + 1).flatMap((other) => {
      const across = Math.min(box.right, other.box.right) - Math.max(box.left, other.box.left);
      const down = Math.min(box.bottom, other.box.bottom) - Math.max(box.top, other.box.top);
      const isHeld = one.contains(other.one) || other.one.contains(one);
      return across > 2 && down > 2 && !isHeld ? [`${name} and ${other.name}`] : [];
    }),
  );
}
