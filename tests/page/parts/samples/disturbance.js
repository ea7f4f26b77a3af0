// What tests have to know of Disturbance.
import { computed } from '../lasting.js';
import { plane, textOf } from '../pictured.js';

/** @type {import('../samples.js').Sample} */
export const sample = {
  tables: { '': 'disturbance-table' },
  free: ['disturbance-table'],
  controls: {
    paper: [['', '#drives-paper-ep, #drives-paper-arbitrary']],
    settings: [['', '#disturbance-controls input, #disturbance-controls select']],
  },
  essentials: ['#remains', '#disturbance-kind'],
  lasting: { measured: computed, message: computed },
  computed: { place: '#remains-text', text: 'this drive' },
  readout: ['', 'remains-text'],
  pictures: [
    {
      setUp: (page) => textOf(page, 'remains-text', 'In the last'),
      pictures: [
        { ...plane, texts: ['0 m'] },
        {
          name: 'What remains of the error',
          key: 'disturbance',
          texts: ['this drive', 'largest', '|sin', '2 s', 'its set', '≈'],
          lines: 15,
        },
      ],
    },
  ],
};
