// What tests have to know of Training.
import { asked, computed, found, underWay } from '../lasting.js';
import { plane, textOf } from '../pictured.js';

/** @type {import('../samples.js').Sample} */
export const sample = {
  slice: { generations: 50 },
  free: ['training-generations'],
  done: [
    {
      lead: async (page) => {
        await page.click('#training-generations option[value="50"]');
        await page.click('#training-evolve');
        await textOf(page, 'training-evolve', 'Evolve again');
      },
      id: 'training-seeds',
    },
  ],
  controls: {
    run: [['', '#training-evolve']],
  },
  essentials: ['#training-unseen', '#training-evolve'],
  lasting: {
    progress: underWay,
    message: computed,
    evolved: found,
    spread: found,
    given: computed,
    begun: underWay,
    wanted: asked,
    byHand: 'goes with what was found',
  },
  computed: { place: '#training-finding', text: 'The paper’s EP gains arrive from' },
  readout: null,
  pictures: [
    {
      setUp: (page) => textOf(page, 'training-seen-title', 'From the start:'),
      pictures: [
        plane,
        { name: 'The starts of training', key: 'training', texts: ['Filled arrives,'], lines: 1000 },
      ],
    },
  ],
};
