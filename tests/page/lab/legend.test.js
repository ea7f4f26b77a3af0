// The legend on a low plane.
import assert from 'node:assert/strict';
import { stepNames, linkOfStep, hrefOf } from '../../../www/lesson/path.js';
import { steps } from '../../../www/lesson/steps.js';
import { pageTest } from '../harness/browsers.js';
import { endSurrounding, follow, surround } from '../whole/surround.js';

/** Each step as it opens, and as its questions show it. */
const links = steps.flatMap(({ name, blocks }) => {
  const number = stepNames.indexOf(name) + 1;
  const shown = blocks.flatMap((block) => (block.kind === 'quiz' && block.quiz.shows) || []);
  return [linkOfStep(number), ...shown.map((link) => hrefOf(link, number).slice(1))];
});

/** The names of the legend that lie on the arrow of start or goal, or on its knob. */
const covering = () => {
  const handles = [...document.querySelectorAll('#plane .handle')].map((handle) => {
    const { left, right, top, bottom } = handle.getBoundingClientRect();
    const radius = handle.matches('.position') ? 14 : 5;
    return { id: handle.id, x: (left + right) / 2, y: (top + bottom) / 2, radius };
  });
  const range = document.createRange();
  return [...document.querySelectorAll('#legend li')].flatMap((line) => {
    if (!line.checkVisibility()) return [];
    range.selectNodeContents(line);
    return [...range.getClientRects()].flatMap(({ left, right, top, bottom }) =>
      handles
        .filter(
          ({ x, y, radius }) =>
            x + radius > left && x - radius < right && y + radius > top + 2 && y - radius < bottom - 2,
        )
        .map(({ id }) => `“${line.textContent}” on ${id}`),
    );
  });
};

pageTest('in low windows no name of the legend lies on start or goal, in any step', async (page) => {
  if (page.engine !== 'chromium') return;
  /** @type {string[]} */
  const found = [];
  try {
    await page.open('#lab&v=1');
    for (const [width, height] of /** @type {const} */ ([
      [1366, 650],
      [1280, 585],
    ])) {
      await surround(page, [width, height]);
      for (const link of links) {
        await follow(page, link);
        for (const flaw of await page.evaluate(covering)) found.push(`${link}, ${width}: ${flaw}`);
      }
    }
  } finally {
    await endSurrounding(page);
  }
  assert.equal(found.join('\n'), '');
});
