// What tests have to know of the lab.
import { plane, textOf } from '../pictured.js';

/** @type {import('../samples.js').Sample} */
export const sample = {
  slice: { curve: 'sigmas' },
  tables: { '': 'fitness-table' },
  essentials: ['#plane', '#run'],
  readout: null,
  pictures: [
    {
      setUp: async (page) => {
        await page.click('#pin');
        for (let i = 0; i < 3; i += 1) await page.click('#one-generation');
        await textOf(page, 'generation', '3');
      },
      pictures: [
        { ...plane, texts: ['best of generation 3', ...plane.texts], lines: 20 },
        {
          name: 'The fitness curve',
          key: 'fitness',
          texts: ['best', 'median', 'paper’s EP', 'generation', '10', '20'],
          lines: 5,
        },
      ],
    },
    {
      setUp: (page) => page.click('#curve-choice label:last-of-type'),
      pictures: [
        plane,
        { name: 'The mean step sizes σ', key: 'sigmas', texts: ['σ of', 'θ', 'generation'], lines: 4 },
      ],
    },
  ],
};
