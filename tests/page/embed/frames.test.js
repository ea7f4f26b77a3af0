// A figure finds its place in a frame of any size, for everybody.
import assert from 'node:assert/strict';
import { sizes, wantedHeight } from '../../../www/embed/frame.js';
import { pageNames, parts } from '../../../www/parts/parts.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { frameOf, inHost, inNextFrame, within } from '../harness/host.js';
import { samples } from '../parts/samples.js';
import { follow } from '../whole/surround.js';

/** The picture of a part, and what one presses first. @param {string} name */
const essentialsOf = (name) =>
  samples[name].essentials ?? [
    `section.${name} [data-picture]`,
    `section.${name} :is(button, select, input):not(.heading *)`,
  ];

/** In the frame: what of a figure has no place. @param {readonly string[]} selectors */
function misplaced([picture, control]) {
  const problems = [];
  const { clientWidth: width, clientHeight: height, scrollWidth, scrollHeight } = document.documentElement;
  if (scrollWidth > width || scrollHeight > height)
    problems.push(`${scrollWidth} × ${scrollHeight} in ${width} × ${height}`);
  const boxOf = (/** @type {Element} */ element) => element.getBoundingClientRect();
  /** @param {DOMRect} box */
  const isInside = (box) =>
    box.left >= 0 && box.top >= 0 && box.right <= width + 0.5 && box.bottom <= height + 0.5;
  for (const selector of [picture, control, '#embed-full', '#embed-screen']) {
    const element = document.querySelector(selector);
    if (!element?.checkVisibility()) problems.push(`${selector} is not in sight`);
    else if (!isInside(boxOf(element)))
      problems.push(`${selector} sticks out: ${JSON.stringify(boxOf(element))}`);
  }
  const { width: wide, height: high } = boxOf(/** @type {Element} */ (document.querySelector(picture)));
  if (wide < 170 || high < 130) problems.push(`${picture} is small: ${wide} × ${high}`);
  // No control lies on another, but those on the plane.
  const controls = [...document.querySelectorAll('button, select, input, a')].filter(
    (one) => one.checkVisibility({ opacityProperty: false }) && !one.closest('.plane, .segmented'),
  );
  const boxes = controls.map((one) => ({ name: one.id || one.className, box: boxOf(one) }));
  for (const [i, { name, box }] of boxes.entries()) {
    if (!isInside(box)) problems.push(`${name} sticks out`);
    if (box.height < 24) problems.push(`${name} is only ${box.height} high`);
    for (const other of boxes.slice(i + 1))
      if (
        box.left < other.box.right - 1 &&
        other.box.left < box.right - 1 &&
        box.top < other.box.bottom - 1 &&
        other.box.top < box.bottom - 1
      )
        problems.push(`${name} lies on ${other.name}`);
  }
  for (const face of document.querySelectorAll('button, .segmented span, #embed-full'))
    if (face.checkVisibility() && face.scrollWidth > face.clientWidth + 1)
      problems.push(`${face.id || face.parentElement?.parentElement?.id} is cut: ${face.textContent}`);
  return problems;
}

pageTest('the colours of an embedded map have their scale where it has room', async (page) => {
  for (const [width, height, hasScale] of /** @type {const} */ ([
    [640, 420, true],
    [560, 400, false],
  ]))
    await inHost(page, frameOf(page, 'landscape&v=1', width, height), () =>
      within(page, 0, async () => {
        const isInSight = () =>
          page.evaluate(() => {
            const legend = document.querySelector('.map-legend');
            return legend?.checkVisibility() && legend.getBoundingClientRect().bottom <= innerHeight;
          });
        assert.equal(await isInSight(), hasScale, `${width} × ${height}`);
      }),
    );
});

/** What has most controls is tightest: in every engine. */
const tightest = ['generation'];

for (const [[width, height], language, names, declare] of /** @type {const} */ ([
  [sizes[0], 'en', pageNames, pageTest],
  [sizes[0], 'ko', pageNames, pageTest],
  [sizes[2], 'en', pageNames, pageTest],
  [sizes[0], 'ko', tightest, engineTest],
]))
  declare(
    `${names === tightest ? tightest.join() : 'every part'} finds its place in ${width} × ${height}, in ${language}`,
    async (page) => {
      await inHost(page, '', async () => {
        for (const name of names) {
          const link = `${name}&v=1${language === 'en' ? '' : `&lang=${language}`}`;
          // One figure at a time: nine are a lot to begin at once.
          await inNextFrame(page, frameOf(page, link, width, height), async () => {
            const problems = () => within(page, 0, () => page.evaluate(misplaced, essentialsOf(name)));
            assert.deepEqual(await problems(), [], name);
            // At the height that it asks for it fits as well.
            const wanted = wantedHeight(parts, name, 0, width);
            await page.until(
              `${name} has the height that it has asked for`,
              (expected) => {
                const { heard } = /** @type {{ heard: import('../harness/host.js').Heard[] }} */ (
                  /** @type {unknown} */ (window)
                );
                const height = heard.findLast(({ data }) => data.type === 'height')?.data.height;
                const frame = /** @type {HTMLIFrameElement} */ (document.querySelector('iframe'));
                frame.height = height;
                return height === expected;
              },
              wanted,
            );
            await within(page, 0, () =>
              page.until(`${name} is that high`, (expected) => innerHeight === expected, wanted),
            );
            assert.deepEqual(await problems(), [], `${name} at ${wanted}`);
          });
        }
      });
    },
  );

pageTest('nothing in a figure is in the way of assistive technology', async (page) => {
  await page.resize(640, 420);
  await page.open('?embed#luck');
  for (const link of [...pageNames.map((name) => `${name}&v=1`), 'lesson&step=2']) {
    await follow(page, link);
    if (link.startsWith('disturbance'))
      await page.until('the errors are known', () => document.getElementById('remains-caption')?.textContent);
    assert.deepEqual(await page.obstacles(), [], link);
  }
});
