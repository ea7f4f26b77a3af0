// One set of gains from many starts: where does the robot arrive?
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { partKey } from '../../link/keys.js';
import { oneNumberOf, oneOf, wholeNumber } from '../../link/values.js';
import { headings } from './grid.js';
import { halves, quantities, robustnessSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

/** @type {Part} */
export const robustness = {
  name: 'robustness',
  called: {
    en: {
      name: 'Robustness',
      purpose:
        'The same gains from everywhere: where does the robot arrive? Press a place to watch it start there.',
    },
    ko: {
      name: '강인성',
      purpose:
        '같은 이득으로 모든 곳에서 출발합니다. 어디에서 도착하고 어디에서 실패할까요? 누르면 그곳에서 주행합니다.',
    },
  },
  slice,
  keys: [
    partKey('colour', slice, 'quantity', (text) => oneOf(quantities, text)),
    partKey('half', slice, 'half', (text) => oneNumberOf(halves, text)),
    partKey('heading', slice, 'heading', (text) => wholeNumber(text, headings - 1)),
  ],
  places: { postures: { lock: '#robustness-map' } },
  tries: ['start'],
  beside: ['cost', 'driver'],
  room: 'map',
  tells: true,
  figure: [0.64, 620],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
