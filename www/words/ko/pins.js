// Every word of the pinned drives, in Korean.
/** @import { Run, Triple } from '../../core/engine.js' */
/** @import { Driver } from '../common/kinds.js' */
import { comparisonText, foundName } from './lab.js';
import { fixed } from './numbers.js';

export * from '../common/pins.js';

export const pinThis = '이 주행 고정';
export const unpinThis = '이 주행 고정 해제';
/** @param {string} name */
export const pinnedAs = (name) => `고정됨: “${name}”`;
export const noRoom = '네 개가 고정되어 있습니다. 먼저 하나를 해제하십시오.';

/** Beside its J. @type {Record<import('../common/kinds.js').Difference, string>} */
const others = {
  limits: '다른 제한',
  goal: '다른 목표',
  start: '다른 출발점',
  weights: '다른 가중치',
  settings: '다른 설정',
};
/** @param {string} name @param {Run} run @param {import('../common/kinds.js').Difference | null} difference Of its settings from those that drive now. */
export const pinText = (name, run, difference) =>
  comparisonText(name, run) + (difference ? `(${others[difference]})` : '');

/** @param {Driver} driver @param {{ generation: number, seed: number, gains: Triple, found: import('../common/kinds.js').Found }} of */
export const pinName = (driver, { generation, seed, gains, found }) =>
  ({
    evolved: `${generation}세대 최우수, 시드 ${seed}`,
    hand: `${found === 'hand' ? '직접' : foundName[found]} ${gains.map((gain) => fixed(gain, 1)).join(', ')}`,
    'paper-ep': '논문 EP',
    'paper-arbitrary': '논문 임의',
  })[driver];
