// A course's page with three figures.
import { frameOf, within } from '../harness/host.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const three = ['lab&v=1&seed=7', 'landscape&v=1', 'generation&v=1&generation=3'];

/** A long page with three figures and a field in which one writes. @param {Page} page */
export const course = (page) =>
  `<input id="field"><script>document.getElementById('field').focus()</script>
   ${three.map((link) => frameOf(page, link, 640, 420)).join('<p>…</p>')}<div style="height: 3000px"></div>`;

/** What moves in a figure. @param {Page} page @param {number} frame */
export const clockOf = (page, frame) =>
  within(page, frame, () =>
    page.evaluate(async () => {
      const texts = [];
      for (let i = 0; i < 5; i += 1) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
        texts.push(document.getElementById('clock')?.textContent ?? '');
      }
      const [now, end] = texts[0].match(/\d+\.\d+/g) ?? [];
      return { stands: new Set(texts).size === 1, atEnd: now === end };
    }),
  );
