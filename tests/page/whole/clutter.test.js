// On every screen each text can be read and each picture has room: every part, every step of the lesson, as a page and as a figure.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { cluttered } from './cluttered.js';
import { follow, inFrame, resizeFrame } from './surround.js';
import { views } from './views.js';

/** @typedef {import('./surround.js').Size} Size */

/** @type {Record<string, readonly Size[]>} */
const screens = {
  '': [
    [1440, 900],
    [1366, 650],
    [1024, 768],
    [820, 1180],
    [390, 844],
  ],
  '?embed': [
    [640, 420],
    [800, 600],
  ],
};

for (const [search, sizes] of Object.entries(screens))
  pageTest(
    `no text lies on another, and no picture is without room, ${search ? 'as a figure' : 'on every screen'}`,
    async (page) => {
      if (page.engine !== 'chromium') return;
      /** @type {string[]} */
      const found = [];
      await inFrame(page, `${search}#lab&v=1`, async () => {
        for (const [i, view] of views.entries()) {
          await follow(page, view);
          // Beginning with the size that it has.
          for (const size of i % 2 === 0 ? sizes : [...sizes].reverse()) {
            await resizeFrame(page, size);
            for (const flaw of await page.evaluate(cluttered))
              found.push(`${view}, ${size.join(' × ')}: ${flaw}`);
          }
        }
      });
      assert.equal(found.join('\n'), '');
    },
  );
