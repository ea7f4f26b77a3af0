// What tests have to know of Generation.
import { plane } from '../pictured.js';

/** @type {import('../samples.js').Sample} */
export const sample = {
  more: ['mutation', 'drive', 'tournament', 'ranking', 'survivors'].map((phase) => `phase=${phase}`),
  slice: { phase: 'ranking', chosen: 3 },
  tables: { '': 'generation-table' },
  free: [
    'generation-phases-drive',
    'generation-phases-mutation',
    'generation-phases-parents',
    'generation-phases-ranking',
    'generation-phases-survivors',
    'generation-phases-tournament',
    'generation-picture',
    'generation-table',
  ],
  controls: {
    run: [['', '#generation-step button, #generation-begin, #run']],
  },
  essentials: ['#generation-picture', '#generation-next'],
  readout: null,
  pictures: [
    {
      setUp: async (page) => {
        await page.click('#one-generation');
        await page.click('#generation-phases label:nth-of-type(3)');
      },
      pictures: [
        plane,
        {
          name: 'The generation',
          key: 'generation',
          texts: ['parent', 'offspring', 'J', 'pair'],
          lines: 40,
          apart: true,
        },
      ],
    },
  ],
};
