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

/** The step and the part of a link: where it has no plane, none of the other links there has. @param {string} link */
const placeOf = (link) => link.replace(/&.*&lesson/, '&lesson');

/** The words on the plane that lie on the arrow of start or goal, or on its knob. @param {string} words */
const covering = async (words) => {
  await pageFrames.settled();
  const handles = [...document.querySelectorAll('#plane .handle')].map((handle) => {
    const { left, right, top, bottom } = handle.getBoundingClientRect();
    const radius = handle.matches('.position') ? 14 : 5;
    return { id: handle.id, x: (left + right) / 2, y: (top + bottom) / 2, radius };
  });
  const range = document.createRange();
  const lines = [...document.querySelectorAll(words)].filter((line) => line.checkVisibility());
  const flaws = lines.flatMap((line) => {
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
  return { flaws, isSeen: handles.length > 0 && lines.length > 0 };
};

pageTest('in low windows no name of the legend lies on start or goal, in any step', async (page) => {
  if (page.engine !== 'chromium') return;
  /** @type {string[]} */
  const found = [];
  /** @type {Set<string>} */
  const planeless = new Set();
  let seen = 0;
  const sizes = [/** @type {const} */ ([1366, 650]), /** @type {const} */ ([1280, 585])];
  try {
    await page.open('#lab&v=1');
    for (const link of links) {
      if (planeless.has(placeOf(link))) continue;
      await follow(page, link);
      const before = seen;
      for (const size of sizes) {
        await surround(page, size);
        const { flaws, isSeen } = await page.evaluate(covering, '#legend li');
        for (const flaw of flaws) found.push(`${link}, ${size[0]}: ${flaw}`);
        if (isSeen) seen += 1;
      }
      if (seen === before) planeless.add(placeOf(link));
      // The next begins in the window that is there.
      sizes.reverse();
    }
  } finally {
    await endSurrounding(page);
  }
  assert.equal(found.join('\n'), '');
  // Nothing lies on what is not there.
  assert.ok(seen > 30, `${seen} have a legend, a start and a goal`);
});

pageTest(
  'on a small laptop the dotted robot beside the lesson has its name where there is room',
  async (page) => {
    if (page.engine !== 'chromium') return;
    try {
      await page.open('#lab&v=1');
      for (const name of /** @type {const} */ (['landscape', 'task', 'lecturers'])) {
        await follow(page, linkOfStep(stepNames.indexOf(name) + 1));
        await surround(page, [1024, 768]);
        const text = await page.until(`${name} has it`, () => {
          const dotted = document.querySelector('#legend .dashed');
          return dotted?.checkVisibility() && dotted.textContent;
        });
        assert.match(text, /^paper’s/);
      }
    } finally {
      await endSurrounding(page);
    }
  },
);

pageTest('on a telephone the names of two pins leave start and goal alone', async (page) => {
  if (page.engine !== 'chromium') return;
  try {
    await page.open('#lab&v=1');
    for (const part of ['lab', 'curves']) {
      await follow(page, `${part}&v=1&generation=40&pin1=first~5,1,5&pin2=second~8.2,3.1,7~law:kanayama`);
      await surround(page, [390, 844]);
      const { flaws, isSeen } = await page.evaluate(covering, '#legend li, #postures li');
      assert.deepEqual(
        flaws.filter((flaw) => flaw.endsWith('-position')),
        [],
        part,
      );
      assert.ok(isSeen);
      assert.equal(await page.evaluate(() => document.querySelectorAll('#legend .pin').length), 2);
    }
  } finally {
    await endSurrounding(page);
  }
});
