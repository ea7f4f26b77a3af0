// Beside the words on a low laptop all that a step’s words name is in sight without scrolling the figure, and nothing lies on it.
import assert from 'node:assert/strict';
import { linkOfStep, stepNames } from '../../../www/lesson/path.js';
import { pageTest } from '../harness/browsers.js';
import { endSurrounding, follow, overlapping, surround } from '../whole/surround.js';

/** @import { StepName } from '../../../www/lesson/path.js' */
/** @import { Page } from '../harness/browsers.js' */

/** What the words name, or go by. @type {Partial<Record<StepName, string>>} */
const named = {
  drive: '#plane, #play, #gains input, .cost-value',
  error: '#plane',
  law: '#plane, #play, #gains input, .push-value',
  stability: '#plane, #play, #gains input, .bowl svg, #stability-picture',
  limits: '#plane, #play, #asked, #curves-picture',
  cost: '.standing-name, .standing-total, #gains input',
  generation: '.newborn li, #generation-phases input',
  sigma: '.lineage-columns svg, #sigmas, #run',
  duel: '.swarm-picture, #gains input',
  landscape: '#landscape-map, #run, #timeline',
  contest: '#contest-run, #contest-chart',
  task: '#run',
};

/** What lies on nothing else. */
const pieces = '#plane, #robot-clock, .swarm-picture, .picture, .readings > *';

/** Full HD at 150 %, the same with a browser that takes more, and the laptop of 1366 × 768. */
const sizes = /** @type {const} */ ([
  [1280, 585],
  [1366, 650],
  [1097, 530],
  [1024, 560],
]);

/** In the page: what of it is not all in the figure’s sight, or in its own box, once nothing moves. @param {string} selector */
async function flaws(selector) {
  const figure = /** @type {HTMLElement} */ (document.querySelector('.figure'));
  let found = [''];
  for (let i = 0, still = 0; i < 120 && still < 4; i += 1) {
    await pageFrames.settled();
    const isComputing = document.querySelector('[aria-busy="true"], .part-waits') !== null;
    const now = [...outOfSight(), ...(isComputing ? [`still, ${i}`] : [])];
    still = String(now) === String(found) ? still + 1 : 0;
    found = now;
  }
  return found;

  function outOfSight() {
    const sight = figure.getBoundingClientRect();
    const all = [...figure.querySelectorAll(selector)].filter((one) => !one.closest('[hidden]'));
    const missing = selector.split(', ').filter((one) => !figure.querySelector(one));
    const cut = all.filter((one) => {
      const box = one.getBoundingClientRect();
      const bottom = Math.min(sight.bottom, one.closest('.standing')?.getBoundingClientRect().bottom ?? 1e9);
      return (
        !one.checkVisibility() ||
        box.bottom > bottom + 1 ||
        box.right > sight.right + 1 ||
        box.left < sight.left - 1
      );
    });
    const isWide = figure.scrollWidth > figure.clientWidth;
    return [
      ...missing.map((one) => `no ${one}`),
      ...cut.map(({ id, className, tagName }) => id || className || tagName),
      ...(isWide ? ['it scrolls sideways'] : []),
    ];
  }
}

/** @param {Page} page @param {string} selector @param {string} where @param {Record<string, string[]>} found */
async function lookAtEach(page, selector, where, found) {
  for (const size of sizes) {
    await surround(page, size);
    const cut = await page.evaluate(flaws, selector);
    const all = [...cut, ...(await page.evaluate(overlapping, pieces))];
    if (all.length > 0) found[`${where}, ${size.join(' × ')}`] = all;
  }
}

for (const language of ['en', 'ko'])
  pageTest(`on a low laptop what a step names is in sight, in ${language}`, async (page) => {
    if (page.engine !== 'chromium') return;
    /** @type {Record<string, string[]>} */
    const found = {};
    // Without its language the page would be loaded again, in another.
    const linkOf = (/** @type {number} */ step) => linkOfStep(step).replace('v=1', `v=1&lang=${language}`);
    try {
      await page.open(`#${linkOf(1)}`);
      for (const [i, name] of stepNames.entries()) {
        const selector = named[name];
        if (!selector) continue;
        await follow(page, linkOf(i + 1));
        assert.equal(await page.evaluate(() => document.documentElement.lang), language);
        await lookAtEach(page, selector, name, found);
      }
      // Once its first question is answered the 32 robots stand over the curve.
      await page.open(`#${linkOf(stepNames.indexOf('task') + 1)}`);
      await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('.quiz .choice')).click());
      await page.until('the robots are there', () => document.querySelector('.swarm-picture canvas'));
      await lookAtEach(page, '#run', 'task, answered', found);
    } finally {
      await endSurrounding(page);
    }
    assert.deepEqual(found, {});
  });

pageTest('scroll bars that take room take it from no number', async (page) => {
  if (page.engine !== 'chromium') return;
  try {
    await page.open(`#${linkOfStep(stepNames.indexOf('law') + 1)}`);
    await surround(page, [1280, 585]);
    for (const bars of [15, 30]) {
      await page.evaluate((px) => {
        /** @type {HTMLElement} */ (document.querySelector('main')).style.paddingRight = `${32 + px}px`;
      }, bars);
      assert.deepEqual(await page.evaluate(flaws, named.law ?? ''), [], `${bars} px`);
    }
  } finally {
    await endSurrounding(page);
  }
});

pageTest('where the figure beside the words scrolls, it says so at its edge', async (page) => {
  await page.open('#lesson&step=7');
  await page.resize(1280, 585);
  const shown = await page.evaluate(() => {
    const figure = /** @type {HTMLElement} */ (document.querySelector('.figure'));
    const { backgroundImage, backgroundAttachment } = getComputedStyle(figure);
    return {
      hidden: figure.scrollHeight - figure.clientHeight,
      shades: backgroundImage.match(/linear-gradient/g)?.length,
      backgroundAttachment,
    };
  });
  assert.ok(shown.hidden > 0, 'otherwise this asks nothing');
  assert.equal(shown.shades, 4);
  assert.match(shown.backgroundAttachment, /local.*scroll/);
});

pageTest('the program is all in sight beside its figure', async (page) => {
  await page.open(`#${linkOfStep(stepNames.indexOf('build') + 1)}`);
  for (const [width, height] of /** @type {const} */ ([
    [1024, 768],
    [1097, 530],
    [1280, 720],
  ])) {
    await page.resize(width, height);
    const beyond = await page.until('the program', () => {
      const program = document.getElementById('program');
      return program && { px: program.scrollWidth - program.clientWidth };
    });
    assert.equal(beyond.px, 0, `${width}`);
  }
});
