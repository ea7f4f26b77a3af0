// What tests have to know of Curves.
import { plane } from '../pictured.js';

/** @type {import('../samples.js').Sample} */
export const sample = {
  views: ['view=stability', 'view=compare', 'view=numbers'],
  slice: { view: 'stability', scale: 'log' },
  tables: { 'view=stability': 'stability-table' },
  free: [
    'curves-numbers',
    'curves-view-compare',
    'curves-view-numbers',
    'curves-view-stability',
    'curves-view-time',
    'stability-log',
    'stability-table',
  ],
  controls: {
    gains: [['view=stability', '#slider-kx, #gain-ktheta']],
    run: [['', '#pause-evolution']],
    clock: [['', '#play, #robot-clock input']],
  },
  essentials: ['#curves-picture', '#play'],
  readout: ['view=stability', 'stability-note'],
  pictures: [
    {
      pictures: [
        plane,
        {
          name: 'The drive against time',
          key: 'curves',
          texts: ['θ', 'rad/s', 'energy', '0.2 s'],
          lines: 15,
        },
      ],
    },
    {
      setUp: (page) => page.click('#curves-view-stability'),
      pictures: [
        plane,
        {
          name: 'V and its rate against time',
          key: 'stability',
          texts: ['V = ½ xₑ²', 'V̇ robot', 'sin² θ', '0.2 s'],
          lines: 12,
        },
      ],
    },
  ],
};
