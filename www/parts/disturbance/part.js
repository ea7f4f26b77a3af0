// The error that remains under a disturbance.
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { disturbanceSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

/** @type {Part} */
export const disturbance = {
  name: 'disturbance',
  called: {
    en: {
      name: 'Disturbance',
      purpose:
        'The ground pushes, the wheels slip: how far off does the robot stay, and what does Theorem 2 promise?',
    },
    ko: {
      name: '외란',
      purpose:
        '바닥이 밀고 바퀴가 미끄러집니다. 로봇은 목표에서 얼마나 벗어나고, 정리 2는 무엇을 보장할까요?',
    },
  },
  slice,
  places: { settings: { lock: '#disturbance-controls', hide: '#disturbance-controls' } },
  tries: ['start', 'disturbance'],
  beside: ['driver'],
  room: 'plane',
  figure: [0.75, 680],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
