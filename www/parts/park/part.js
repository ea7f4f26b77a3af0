// The first thing to do: robots at many starts around one parking place, three sliders, and evolution, which does better.
/** @import { Part } from '../part.js' */
import { partKey } from '../../link/keys.js';
import { gainsUpTo, numberText } from '../../link/values.js';
import { makerFrom } from '../load.js';
import { mostGain, parkSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

const gainsKey = partKey(
  'park',
  slice,
  'gains',
  (text) => gainsUpTo(text, mostGain),
  (gains) => gains.map(numberText).join(','),
);

/** @type {Part} */
export const park = {
  name: 'park',
  called: {
    en: {
      name: 'Park',
      purpose: 'Robots at 32 starts, one parking place, three numbers: park them all, or let evolution try.',
    },
    ko: {
      name: '주차',
      purpose: '출발점 32곳의 로봇, 주차 자리 하나, 숫자 세 개. 모두 주차시켜 보거나 진화에 맡겨 보십시오.',
    },
  },
  slice,
  // Elsewhere nobody sees them, and they stay.
  keys: [
    {
      ...gainsKey,
      stays: true,
      text: (state, usual) => (state.page === 'park' ? gainsKey.text(state, usual) : null),
    },
  ],
  places: {
    gains: { lock: '#park-gains, .park-walk', hide: '#park-gains, .park-walk' },
    run: { lock: '#park-evolve', hide: '#park-evolve' },
  },
  alone: true,
  figure: [0.75, 640],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
