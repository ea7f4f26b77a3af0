// J over two gains.
/** @import { Part } from '../part.js' */
/** @import { AxisChoice } from './request.js' */
/** @import { LandscapeState } from './state.js' */
import { makerFrom } from '../load.js';
import { partKey } from '../../link/keys.js';
import { number, numberText, oneOf } from '../../link/values.js';
import { link as words } from '../../words/index.js';
import { gainNames, landscapeSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

/** @param {AxisChoice} axis */
const axisText = ({ gain, log }) => (log ? `${gain}-log` : gain);

/** @param {string} text @returns {AxisChoice} */
const axisOf = (text) => ({
  gain: oneOf(gainNames, text.replace(/-log$/, '')),
  log: text.endsWith('-log'),
});

/** @type {Part} */
export const landscape = {
  name: 'landscape',
  called: {
    en: {
      name: 'Landscape',
      purpose:
        'Every point is a robot with gains of its own, its colour the cost of its drive. Drag the goal: the valley moves.',
    },
    ko: {
      name: '비용 지형',
      purpose:
        '점 하나하나가 서로 다른 이득을 가진 로봇이고, 색은 그 주행의 비용입니다. 목표를 끌면 골짜기가 움직입니다.',
    },
  },
  slice,
  keys: [
    partKey('x', slice, 'x', axisOf, axisText),
    partKey('y', slice, 'y', axisOf, axisText),
    partKey('third', slice, 'third', number, numberText),
  ],
  mend(opened, refuse) {
    const asked = /** @type {LandscapeState} */ (opened.parts[slice.name]);
    if (asked.x.gain !== asked.y.gain) return opened;
    refuse('y', words.expected(words.otherGain, asked.y.gain));
    const y = axisOf(asked.x.gain === 'ktheta' ? 'kx' : 'ktheta');
    return { ...opened, parts: { ...opened.parts, [slice.name]: { ...asked, y } } };
  },
  places: { gains: { lock: '#landscape-map' } },
  beside: ['cost', 'evolution', 'driver'],
  room: 'map',
  tells: true,
  figure: [0.64, 620],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
