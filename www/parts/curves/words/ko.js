// Every word of the curves, in Korean.
/** @import { Run } from '../../../core/engine.js' */
import { isTracking } from '../../../core/reference.js';
import { numberColumnsOf } from './common.js';
import { costText, fixed, threeDigits } from '../../../words/ko/numbers.js';

export * from './common.js';

export const texts = {
  curvesPicture: '시간에 따른 주행',
  curvesTitle: '곡선',
  comparisonTable: '고정한 주행의 표',
  numbersTable: '주행의 수치 표',
};

export const viewLegend = '보여 줄 내용';
/** @type {import('../../../kit/segmented.js').Choices<import('../state.js').CurvesView>} */
export const views = {
  time: '시간에 따라',
  stability: { text: '안정성', hint: '리아푸노프 함수 V와 그 변화율' },
  compare: '비교',
  numbers: '수치',
};

export const limit = '제한';

/** @param {string} name @param {Run} run @param {string} outcome @param {string} comparison @param {readonly string[]} pins */
export const pictureLabel = (name, run, outcome, comparison, pins) =>
  `시간에 따른 x와 y, θ, v, ω, J. ${name}: J ${costText(run.cost.total)}, ${outcome}. 점선: ${comparison}.${pins.map((pin) => ` 고정한 주행: ${pin}.`).join('')} “수치”\u2060에서 모두 표로 볼 수 있습니다.`;

/** @param {'5' | '7'} figure */
export const figureNote = (figure) =>
  figure === '5'
    ? '논문의 그림 5가 보여 주는 두 주행입니다. 실선은 EP 이득, 점선은 임의 이득입니다.'
    : '논문의 그림 7이 보여 주는 두 주행이지만 거기서 θ는 60° 미만입니다. 어떤 제한으로도 그렇게 되지 않았습니다.';

/** @param {string} name @param {number} step */
export const numbersCaption = (name, step) =>
  `${name}: ${threeDigits(step)}초마다 한 줄, 그리고 마지막. v와 ω는 그 시각부터의 값입니다.`;

export const numberColumns = numberColumnsOf({
  'command-linear': 'v 명령',
  'command-angular': 'ω 명령',
  paid: '누적 J',
});

export const noPinsText =
  '“이 주행 고정”\u2060으로 주행을 남겨 두고, 진화를 더 진행하거나 시드, 설정, 이득을 바꾸어 보십시오. 무엇이 다른지 여기에 나타납니다.';
/** @param {number} count */
export const pinsText = (count) => `4개 중 ${count}개 고정됨. 이름은 바꿀 수 있습니다.`;
/** @param {number} slot */
export const nameLabel = (slot) => `고정한 주행 ${slot + 1}의 이름`;
/** @param {string} name */
export const unpin = (name) => `고정 해제: ${name}`;
export const nameNeeded = '고정한 주행의 이름은 한 글자 이상이어야 합니다. 이전 이름을 그대로 둡니다.';

export const unpinShort = '해제';

/** @param {string} name */
export const drivingColumn = (name) => `현재: ${name}`;
/** Korean breaks at its spaces. @param {string} name */
export const breakable = (name) => name;

export const outcomeHead = '목표';
/** @param {Run} run */
export const outcomeShort = (run) =>
  isTracking(run) ? '추종' : { arrived: '도착', horizon: '미도착', diverged: '미도착' }[run.outcome];
export const finalTimeHead = '종료';
/** @param {Run} run */
export const finalTimeText = ({ finalTime }) => `${fixed(finalTime, 2)}초`;
export const settingsThatDiffer = '서로 다른 설정';
export const sameSettings = '모든 설정이 같습니다.';
export const startsHead = '진화에 쓴 출발점';
/** @param {number} count */
export const startsText = (count) => `${count}개`;
