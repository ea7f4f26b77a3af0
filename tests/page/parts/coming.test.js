// While a part is on its way what was open stays; where it is slow, or cannot be loaded, its place says so beside the plane alone.
import assert from 'node:assert/strict';
import { unnoticed } from '../../../www/parts/load.js';
import { pageTest } from '../harness/browsers.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const sizes = /** @type {const} */ ([
  [1440, 900],
  [820, 1180],
  [390, 844],
]);

/** What of the lab and of the parts is in sight, and where the robots are. @typedef {{ open: string, shown: string[], robot: string }} Look */

/** Opens a page of which some files are not sent. @param {Page} page @param {string} address @param {readonly [number, number]} size */
async function open(page, address, [width, height]) {
  await page.resize(width, height);
  await page.leave();
  await page.visit(address);
  await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
  await page.evaluate(() => pageFrames.settled());
}

/** Whether it is said where it is seen, how much of it lies under something else, and what else is there. @param {Page} page @param {string} part */
const failure = (page, part) =>
  page.until(
    'it is said',
    (name) => {
      const box = document.querySelector(`#instrument [data-page="${name}"] .part-failed`);
      if (!box?.checkVisibility()) return null;
      const { top, bottom, left, right } = box.getBoundingClientRect();
      const robot = document.querySelector('.robot')?.getBoundingClientRect() ?? new DOMRect();
      const others = [...document.querySelectorAll('#instrument [data-page]')].filter(
        (element) => !element.contains(box) && element.checkVisibility(),
      );
      return {
        text: box.textContent ?? '',
        isSeen: top >= 0 && bottom <= innerHeight,
        crosses: robot.bottom > top && robot.top < bottom && robot.right > left && robot.left < right,
        plane: robot.height,
        others: others.map(({ id }) => id),
        title: document.title,
      };
    },
    part,
  );

pageTest('a part that cannot be loaded leaves the plane where it is, and says so in sight', async (page) => {
  const site = await serve(undefined, {
    send: (name, content) =>
      /page-.*\.js$/.test(name) && !/data-beside|park-plane/.test(content.toString()) ? null : content,
  });
  try {
    for (const size of sizes) {
      await open(page, `${site.address}#lab&v=1`, size);
      for (const part of ['landscape', 'robustness', 'training', 'generation', 'lesson']) {
        await page.click(`#page-${part}`);
        const { text, isSeen, crosses, plane, others, title } = await failure(page, part);
        const where = `${part} at ${size}`;
        assert.ok(isSeen, where);
        // Its run has taken the place of the one there was.
        assert.equal(/Back leads/.test(text), part === 'lesson', where);
        assert.ok(!crosses, where);
        assert.ok(plane > 250, `${where}: a plane of ${plane} pixels`);
        assert.deepEqual(others, [], where);
        assert.match(title, new RegExp(`^${part}`, 'i'));
        await page.click('#page-lab');
        await page.until('the lab is there', () => document.getElementById('curve')?.checkVisibility());
      }
    }
    await open(page, `${site.address}#park`, [390, 844]);
    await page.click('#page-lesson');
    const { isSeen, plane } = await failure(page, 'lesson');
    assert.ok(isSeen);
    assert.equal(plane, 0, 'the plane of the lab stands there');
  } finally {
    await page.leave();
    await site.close();
  }
});

/** However busy the machine is, nothing is late. */
const patient = `
  const later = window.setTimeout.bind(window);
  window.setTimeout = (act, time, ...given) => later(act, time === ${unnoticed} ? 60_000 : time, ...given);`;

pageTest('until a part is there what was open stays as it is', async (page) => {
  const site = await serve(undefined, {
    before: patient,
    async send(name, content) {
      if (/page-.*\.(js|css)$/.test(name)) await new Promise((resolve) => setTimeout(resolve, 60));
      return content;
    },
  });
  try {
    for (const size of sizes) {
      for (const way of [
        ['lab', 'landscape', 'robustness', 'training', 'disturbance', 'luck', 'curves', 'generation'],
        ['park', 'lesson', 'luck'],
      ]) {
        await open(page, `${site.address}#${way[0]}`, size);
        for (const part of way.slice(1)) {
          const looks = await watch(page, part);
          const where = `${part} at ${size}`;
          assert.ok(looks.length > 1, `${where} is there at once`);
          for (const look of looks) assert.deepEqual(look, looks[0], where);
        }
      }
    }
  } finally {
    await page.leave();
    await site.close();
  }
});

/** Opens a part; how the page looks in each frame until that is there. @param {Page} page @param {string} part @returns {Promise<Look[]>} */
const watch = (page, part) =>
  page.evaluate(
    (name) =>
      new Promise((resolve) => {
        /** @type {Look[]} */
        const looks = [];
        const look = () => {
          const { open = '' } = document.body.dataset;
          if (document.getElementById(`${name}-title`)?.checkVisibility()) return resolve(looks);
          const shown = [...document.querySelectorAll('#instrument [data-page], #lesson')].filter((element) =>
            element.checkVisibility(),
          );
          const { x, y, width, height } =
            document.querySelector('.robot')?.getBoundingClientRect() ?? new DOMRect();
          looks.push({
            open,
            shown: shown.map(({ id, className }) => id || className),
            robot: [x, y, width, height].join(' '),
          });
          requestAnimationFrame(look);
        };
        look();
        document.getElementById(`page-${name}`)?.click();
      }),
    part,
  );
