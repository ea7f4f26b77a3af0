// One generation, phase by phase.
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { partKey } from '../../link/keys.js';
import { oneOf, wholeNumber } from '../../link/values.js';
import { generationSlice as slice, phases } from './state.js';
import { load as loadWords } from './words/load.js';

/** @type {Part} */
export const generation = {
  name: 'generation',
  called: {
    en: {
      name: 'Generation',
      purpose:
        'One generation, step by step: who is whose offspring, how each drove, whom each met, who stays.',
    },
    ko: {
      name: '세대',
      purpose:
        '한 세대를 단계별로 봅니다: 누가 누구의 자손인지, 어떻게 주행했는지, 누구를 만났는지, 누가 남는지.',
    },
  },
  slice,
  keys: [
    partKey('phase', slice, 'phase', (text) => oneOf(phases, text)),
    partKey('individual', slice, 'chosen', (text) => wholeNumber(text, 3999)),
  ],
  places: {
    run: {
      lock: '#generation-step, #generation-begin',
      hide: '#generation-step button, #generation-begin',
    },
  },
  phases: true,
  beside: ['evolution'],
  room: 'plane',
  figure: [0.72, 620],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
