// On a tablet held sideways the words of a step stand beside its figure, in which all that one presses or reads is in sight; held upright, below it.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { endSurrounding, follow, overlapping, surround } from '../whole/surround.js';
import { lessonViews } from '../whole/views.js';

/** What lies on nothing else. */
const pieces = '#plane, #robot-clock, .stage, .readings > *';

/** In the page: what of the figure is cut off, and how much of the drive in ink lies under the name of the dotted one, once nothing of it moves. */
async function flaws() {
  const figure = /** @type {Element} */ (document.querySelector('.figure'));
  let found = [''];
  for (let i = 0, still = 0; i < 120 && still < 4; i += 1) {
    await pageFrames.settled();
    const isComputing = document.querySelector('[aria-busy="true"], .part-waits') !== null;
    const now = [...cutOff(), ...inkUnderName(), ...(isComputing ? [`still, ${i}`] : [])];
    still = String(now) === String(found) ? still + 1 : 0;
    found = now;
  }
  return found;

  function cutOff() {
    const { left, right, bottom } = figure.getBoundingClientRect();
    const foot = Math.min(bottom, innerHeight);
    return [...figure.querySelectorAll('button, input, select, canvas, .push-value, #landscape-readout')]
      .filter((one) => one.checkVisibility() && !one.closest('#handles'))
      .filter((one) => {
        const box = one.getBoundingClientRect();
        return box.width > 1 && (box.bottom > foot + 1 || box.right > right + 1 || box.left < left - 1);
      })
      .map(({ id, className, tagName }) => id || className || tagName);
  }

  /** Where the plane shares its row. */
  function inkUnderName() {
    const name = document.querySelector('[data-stage="beside"] #legend .dashed');
    if (!name?.checkVisibility()) return [];
    Object.assign(window, { hasName: true });
    const range = document.createRange();
    range.selectNodeContents(name);
    const boxes = [...range.getClientRects()];
    let count = 0;
    for (const canvas of /** @type {NodeListOf<HTMLCanvasElement>} */ (
      document.querySelectorAll('#plane canvas')
    )) {
      const { left, top, width } = canvas.getBoundingClientRect();
      const scale = canvas.width / width;
      const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
      for (const box of boxes) {
        const [x, y] = [(box.left - left) * scale, (box.top - top) * scale];
        const { data } = context.getImageData(x, y, box.width * scale, box.height * scale);
        for (let i = 0; i < data.length; i += 4)
          if (data[i + 3] > 200 && Math.max(data[i], data[i + 1], data[i + 2]) < 70) count += 1;
      }
    }
    return count > 0 ? [`${count} px of ink under the name`] : [];
  }
}

pageTest(
  'on a tablet held sideways all of a step’s figure is in sight, and no name lies on the drive',
  async (page) => {
    /** @type {Record<string, string[]>} */
    const found = {};
    try {
      await page.open('#lesson&step=1');
      for (const view of lessonViews) {
        await follow(page, view);
        for (const size of /** @type {const} */ ([
          [1180, 745],
          [1024, 768],
          [1133, 670],
        ])) {
          await surround(page, size);
          const cut = await page.evaluate(flaws);
          const all = [...cut, ...(await page.evaluate(overlapping, pieces))];
          // So low that some of it is scrolled to.
          const flawed = size[1] < 700 ? all.filter((flaw) => flaw.includes(' and ')) : all;
          if (flawed.length > 0) found[`${view}, ${size}`] = flawed;
        }
      }
    } finally {
      await endSurrounding(page);
    }
    assert.deepEqual(found, {});
    assert.ok(
      await page.evaluate(() => 'hasName' in window),
      'some plane that shares its row has such a name',
    );
  },
);

pageTest(
  'held upright its map is high, and each drive of a generation as large as its row lets it be',
  async (page) => {
    await page.resize(768, 1024);
    await page.open('#lesson&step=10');
    const shown = await page.until('the map', () => {
      const [map, plane, run] = ['#landscape-map', '#plane', '#run'].map((one) =>
        document.querySelector(one)?.getBoundingClientRect(),
      );
      const sight = document.querySelector('.figure')?.getBoundingClientRect();
      return (
        map &&
        plane &&
        run &&
        sight &&
        map.height > 0 && {
          map: map.height,
          isBeside: plane.right <= map.left,
          isWhole: run.bottom <= sight.bottom,
        }
      );
    });
    assert.ok(shown.map >= 280 && shown.isBeside && shown.isWhole, JSON.stringify(shown));
    await page.open('#lesson&step=7');
    const drive = await page.until('the drives', () => {
      const { width = 0, height = 0 } = document.querySelector('.newborn li')?.getBoundingClientRect() ?? {};
      return width > 0 && { width, height };
    });
    assert.ok(drive.width > 90 && drive.height > 90, JSON.stringify(drive));
  },
);
