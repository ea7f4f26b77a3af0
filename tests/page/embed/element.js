// A page of another host that has the element.
import assert from 'node:assert/strict';
import { serveHost } from '../harness/host.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Opens a page of another host with what stands in it. @param {Page} page @param {string} html @param {(address: string) => Promise<void>} body */
export async function inPage(page, html, body) {
  const errors = `<script>
    errors = [];
    addEventListener('error', ({ message }) => errors.push(message));
    addEventListener('unhandledrejection', ({ reason }) => errors.push(String(reason)));
  </script>`;
  const host = await serveHost(`${errors}${html}<script type="module" src="/dist/embed.js"></script>`);
  try {
    await page.visit(host.address);
    await body(host.address);
    assert.deepEqual(await page.evaluate(() => Reflect.get(window, 'errors')), []);
  } finally {
    await page.leave();
    await host.close();
  }
}

/** Does something with an element of the page; what comes back goes as text, for one driver changes the last digit of some numbers. @param {Page} page @param {string} id @param {string} code an expression of the element, `it` */
export const use = async (page, id, code) =>
  JSON.parse(
    await page.evaluate(
      async (name, text) => {
        const it = document.getElementById(name);
        const result = await new Function('it', `return (async () => ${text})()`)(it).catch(
          (/** @type {Error} */ { message }) => ({ refused: message }),
        );
        return JSON.stringify(result ?? null);
      },
      id,
      code,
    ),
  );

/** What an element has in sight above its figure. @param {Page} page @param {string} id */
export const complaint = (page, id) =>
  page.evaluate((name) => document.getElementById(name)?.shadowRoot?.querySelector('p')?.innerText, id);

/** @param {Page} page @param {string} id */
export const isReady = (page, id) =>
  page.until(`${id} is ready`, (name) => Reflect.get(document.getElementById(name) ?? {}, 'state'), id);
