// What tests have to know of Luck.
import { runContest } from '../contest-page.js';
import { asked, found, underWay } from '../lasting.js';
import { plane, textOf } from '../pictured.js';

/** @typedef {import('../samples.js').Page} Page */

/** @param {Page} page */
async function runSeeds(page) {
  await page.click('#luck-count option[value="20"]');
  await page.click('#luck-generations option[value="50"]');
  await page.click('#luck-run');
  await textOf(page, 'luck-finding', 'After 50 generations');
}

/** @param {Page} page */
async function runSmallContest(page) {
  await page.click('#luck-view label:last-child');
  await page.click('#contest-seeds option[value="15"]');
  await page.click('#contest-budget option[value="1000"]');
  await runContest(page);
}

/** @type {import('../samples.js').Sample} */
export const sample = {
  more: ['luck=contest'],
  slice: {
    view: 'contest',
    others: ['cauchy', 'de'],
    seeds: 15,
    budget: 1000,
    target: 7.75,
    reading: 'ends',
    until: 500,
    only: 5,
    draw: 2,
    count: 500,
    generations: 50,
  },
  free: [
    'contest-budget',
    'contest-reading-course',
    'contest-reading-ends',
    'contest-reading-targets',
    'contest-seeds',
    'contest-target',
    'contest-target-line',
    'contest-until-line',
    'contest-usual',
    'contestant-2',
    'contestant-3',
    'contestant-4',
    'luck-count',
    'luck-generations',
    'luck-view-contest',
    'luck-view-seeds',
  ],
  done: [
    { lead: runSeeds, id: 'luck-log' },
    { lead: runSmallContest, id: 'contest-only' },
  ],
  controls: {
    run: [
      ['', '#luck-run'],
      ['luck=contest', '#contest-run'],
    ],
    seed: [['', '#luck-open']],
  },
  essentials: ['#luck-curve', '#luck-run'],
  lasting: {
    contest: found,
    contestRuns: underWay,
    wanted: asked,
    seedsWanted: asked,
    log: 'how what was found is drawn',
    asked: underWay,
    progress: underWay,
    soFar: underWay,
    result: found,
    chosen: 'one of what was found',
    pointed: 'under the pointer',
  },
  readout: null,
  pictures: [
    {
      setUp: runSeeds,
      pictures: [
        plane,
        {
          name: 'The fitness curve of all seeds',
          key: 'luck-curve',
          texts: ['random search', 'evolution', 'seed 1', '50'],
          lines: 40,
        },
        { name: 'The gains of all seeds', key: 'luck-gains', texts: ['k', 'θ', 'median'], lines: 60 },
      ],
    },
    {
      setUp: runSmallContest,
      pictures: [
        plane,
        { name: 'The contest', key: 'contest', texts: ['target', 'drives', '100 %'], lines: 12, apart: true },
      ],
    },
  ],
};
