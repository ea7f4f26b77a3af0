// What tests have to know of Robustness.
import { computed } from '../lasting.js';
import { plane, textOf } from '../pictured.js';

/** @type {import('../samples.js').Sample} */
export const sample = {
  slice: { quantity: 'time', half: 8, heading: 3 },
  tables: { '': 'robustness-table' },
  free: [
    'robustness-half',
    'robustness-headings-all',
    'robustness-headings-one',
    'robustness-quantity-cost',
    'robustness-quantity-share',
    'robustness-quantity-time',
    'robustness-rose',
    'robustness-table',
  ],
  controls: {
    drives: [['', '#drives-evolved, #drives-hand']],
  },
  essentials: ['#robustness-map', '#robustness-quantity'],
  lasting: { survey: computed, rival: computed, message: computed },
  computed: { place: '#robustness-rival', text: 'with the paper’s arbitrary gains' },
  readout: ['', 'robustness-readout'],
  pictures: [
    {
      setUp: (page) => textOf(page, 'robustness-note', '118 098 starts in'),
      pictures: [
        plane,
        { name: 'The map of starts', key: 'robustness', texts: ['goal', 'none arrives', 'all'], lines: 20 },
      ],
    },
  ],
};
