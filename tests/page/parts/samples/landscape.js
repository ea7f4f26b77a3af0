// What tests have to know of Landscape.
import { computed } from '../lasting.js';
import { plane, textOf } from '../pictured.js';

/** @type {import('../samples.js').Sample} */
export const sample = {
  slice: { x: { gain: 'ky', log: true }, y: { gain: 'kx', log: false }, third: 0.25 },
  tables: { '': 'landscape-table' },
  free: ['landscape-follows', 'landscape-table', 'landscape-third', 'landscape-x', 'landscape-y'],
  controls: {
    seed: [['', '#new-seed']],
  },
  essentials: ['#landscape-map', '#run'],
  lasting: { result: computed, message: computed },
  computed: { place: '#landscape-note', text: 'drives in' },
  readout: ['', 'landscape-readout'],
  pictures: [
    {
      setUp: (page) => textOf(page, 'landscape-note', '16 384 drives'),
      pictures: [
        plane,
        { name: 'The landscape of J', key: 'landscape', texts: ['paper’s EP', '10', 'k', 'θ'], lines: 30 },
      ],
    },
  ],
};
