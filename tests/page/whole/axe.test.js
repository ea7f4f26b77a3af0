// Nothing is in the way of assistive technology, also where other tests do not look: every part and every step of the lesson
// in the dark on a small screen, and some of them in the reader's own colours on large ones and in a frame, in one language
// or the other. Light and in English each is looked at in every engine where it is tested.
import assert from 'node:assert/strict';
import { languageNames } from '../../../www/words/language.js';
import { pageTest } from '../harness/browsers.js';
import { endSurrounding, follow, surround } from './surround.js';
import { lessonViews, partViews } from './views.js';

/** @typedef {import('./surround.js').Size} Size */

const pin = 'pin1=a~5,1,5';
const views = [
  ...partViews.map((view) => `${view}&${pin}`),
  ...lessonViews,
  'luck&v=1&luck=contest',
  'landscape&v=1&evolution.method=cma-es&generation=3',
];

/** @typedef {{ size: Size, media?: Record<string, string>, search?: string, isDue: (view: number) => boolean }} Surroundings */

/** @type {Record<import('../../../www/words/language.js').Language, readonly Surroundings[]>} */
const surroundings = {
  en: [
    { size: [390, 844], media: { 'prefers-color-scheme': 'dark' }, isDue: (view) => view % 2 === 0 },
    { size: [1440, 900], media: { 'forced-colors': 'active' }, isDue: (view) => view % 6 === 3 },
    { size: [400, 300], search: '?embed', isDue: (view) => view % 6 === 1 },
  ],
  ko: [
    { size: [390, 844], media: { 'prefers-color-scheme': 'dark' }, isDue: (view) => view % 2 === 1 },
    { size: [1024, 768], media: { 'forced-colors': 'active' }, isDue: (view) => view % 6 === 0 },
    { size: [400, 300], search: '?embed', isDue: (view) => view % 6 === 4 },
  ],
};

pageTest('nothing is in the way of assistive technology, wherever the page is', async (page) => {
  if (page.engine !== 'chromium') return;
  /** @type {Record<string, string[]>} */
  const found = {};
  try {
    for (const language of languageNames)
      for (const { size, media = {}, search = '', isDue } of surroundings[language]) {
        await surround(page, size, media);
        await page.open(`${search}#lab&v=1&lang=${language}`);
        for (const view of views.filter((_, i) => isDue(i))) {
          await follow(page, `${view}&lang=${language}`);
          // What stands around a step of the lesson is looked at as a part.
          const obstacles = await page.obstacles(view.includes('lesson=') ? '#lesson' : undefined);
          if (obstacles.length > 0) found[`${view}, ${language}, ${size.join(' × ')}`] = obstacles;
        }
      }
  } finally {
    await endSurrounding(page);
  }
  assert.deepEqual(found, {});
});
