// The drive against time, its stability, and runs beside each other.
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { labCurves, labSlice } from '../../lab/state.js';
import { partKey } from '../../link/keys.js';
import { oneOf } from '../../link/values.js';
import { curvesSlice as slice, scales, views } from './state.js';
import { load as loadStability } from './stability/words/load.js';
import { load as loadWords } from './words/load.js';

/** @type {Part} */
export const curves = {
  name: 'curves',
  called: {
    en: {
      name: 'Curves',
      purpose:
        'The drive against time, as in the paper’s Figures 5 and 7, J as it is paid, and the Lyapunov function.',
    },
    ko: {
      name: '곡선',
      purpose: '논문의 그림 5, 7처럼 시간에 따라 그린 주행, 그동안 쌓이는 J, 그리고 리아푸노프 함수입니다.',
    },
  },
  slice,
  keys: [
    partKey('view', slice, 'view', (text) => oneOf(views, text)),
    // The lab's own, which stands here in every link that was ever written.
    partKey('curve', labSlice, 'curve', (text) => oneOf(labCurves, text)),
    partKey('scale', slice, 'scale', (text) => oneOf(scales, text)),
  ],
  // What a gain does to V̇ is seen while it is moved. The lesson needs the height.
  gains: (state) => slice.of(state).view === 'stability' || (state.driver === 'hand' && state.lesson === 0),
  pays: true,
  beside: ['driver'],
  figure: [0.72, 700],
  load: () => makerFrom([loadWords, loadStability], () => import('./page.js')),
};
