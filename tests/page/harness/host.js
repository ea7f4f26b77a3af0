// A page of someone else that holds figures in frames, on an origin of its own, as a course's page has one.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { By } from 'selenium-webdriver';
import { listen, typeOf } from './http.js';

/** @typedef {import('./browsers.js').Page} Page */
/** What came to the host: from which of its frames, counted from 0. @typedef {{ frame: number, origin: string, data: any }} Heard */

const top = fileURLToPath(new URL('../../../', import.meta.url));

/** Keeps every message that comes. */
const listener = `<script>
  window.heard = [];
  addEventListener('message', ({ source, origin, data }) => {
    const frame = [...document.querySelectorAll('iframe')].findIndex((one) => one.contentWindow === source);
    heard.push({ frame, origin, data });
  });
</script>`;

/** Serves HTML as `/`, and the files of the project beside it. @param {string} html */
export async function serveHost(html) {
  const { port, close } = await listen(async (request, response) => {
    const { pathname } = new URL(request.url ?? '/', 'http://localhost');
    const body =
      pathname === '/'
        ? `<!doctype html><html lang="en"><title>A course</title>${listener}${html}`
        : await readFile(join(top, normalize(decodeURIComponent(pathname)))).catch(() => null);
    const headers = { 'Content-Type': typeOf(pathname), 'Cache-Control': 'no-store' };
    response.writeHead(body === null ? 404 : 200, headers);
    response.end(body);
  });
  return { address: `http://127.0.0.1:${port}/`, close };
}

/**
 * Opens a page of the host and waits until all of its figures can be spoken to.
 * @param {Page} page @param {string} html @param {(page: Page) => Promise<void>} body
 */
export async function inHost(page, html, body) {
  const host = await serveHost(html);
  try {
    await page.visit(host.address);
    const count = await page.evaluate(() => document.querySelectorAll('iframe').length);
    for (let frame = 0; frame < count; frame += 1)
      await page.until(`frame ${frame} is ready`, isReady, frame);
    await body(page);
    for (let frame = 0; frame < count; frame += 1)
      assert.deepEqual(await within(page, frame, () => page.problems()), [], `frame ${frame}`);
  } finally {
    await page.leave();
    await host.close();
  }
}

/**
 * In the page of the host: another figure, alone. It begins sooner than in a page of its own, which is given a process of its own.
 * @param {Page} page @param {string} html @param {() => Promise<void>} body
 */
export async function inNextFrame(page, html, body) {
  await page.evaluate((text) => {
    Object.assign(window, { heard: [] });
    document.body.innerHTML = text;
  }, html);
  await page.until('the frame is ready', isReady, 0);
  await body();
  assert.deepEqual(await within(page, 0, () => page.problems()), []);
}

/** In the host. @param {number} frame */
const isReady = (frame) =>
  /** @type {{ heard: Heard[] }} */ (/** @type {unknown} */ (window)).heard.some(
    (one) => one.frame === frame && one.data.type === 'ready',
  );

/** @param {Page} page @param {string} link @param {number} width @param {number} height @param {string} [more] */
export const frameOf = (page, link, width, height, more = 'allow="fullscreen"') =>
  `<iframe src="${page.site.address}?embed#${link.replaceAll('&', '&amp;')}" width="${width}" height="${height}" style="border: 0" ${more}></iframe>`;

/** All that a frame has said. As text, for one driver changes the last digit of some numbers. @param {Page} page @param {number} frame @returns {Promise<any[]>} */
export const heardFrom = async (page, frame) =>
  JSON.parse(
    await page.evaluate(
      (number) =>
        JSON.stringify(
          /** @type {{ heard: Heard[] }} */ (/** @type {unknown} */ (window)).heard
            .filter((one) => one.frame === number)
            .map(({ data }) => data),
        ),
      frame,
    ),
  );

/** Sends a message to a frame and waits for its answer. @param {Page} page @param {number} frame @param {object} message @returns {Promise<any>} */
export async function ask(page, frame, message) {
  const id = `question ${await page.evaluate(
    (number, text) => {
      const own = /** @type {{ asked?: number }} */ (/** @type {unknown} */ (window));
      own.asked = (own.asked ?? 0) + 1;
      const question = { ep: 1, id: `question ${own.asked}`, ...JSON.parse(text) };
      document.querySelectorAll('iframe')[number].contentWindow?.postMessage(question, '*');
      return own.asked;
    },
    frame,
    JSON.stringify(message),
  )}`;
  const answer = await page.until(
    `frame ${frame} answers ${JSON.stringify(message)}`,
    (question) =>
      JSON.stringify(
        /** @type {{ heard: Heard[] }} */ (/** @type {unknown} */ (window)).heard.find(
          ({ data }) => data.id === question,
        )?.data,
      ),
    id,
  );
  return JSON.parse(answer);
}

/** Does something within a frame, scrolled into sight, where everything of a page is that of the frame. @template T @param {Page} page @param {number} frame @param {() => Promise<T>} body */
export async function within(page, frame, body) {
  const { driver } = page;
  await page.evaluate(
    (number) => document.querySelectorAll('iframe')[number].scrollIntoView({ block: 'nearest' }),
    frame,
  );
  await driver.switchTo().frame((await driver.findElements(By.css('iframe')))[frame]);
  try {
    // What nobody sees is not drawn.
    await page.until(
      'the figure is drawn',
      () => document.body?.dataset.open && document.documentElement.dataset.ready,
    );
    return await body();
  } finally {
    await driver.switchTo().defaultContent();
  }
}
