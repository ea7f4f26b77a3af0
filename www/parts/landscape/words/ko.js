// Every word of the landscape, in Korean.
/** @import { Run } from '../../../core/engine.js' */
import { costText, grouped, tookText } from '../../../words/ko/numbers.js';

export * from './common.js';

export const texts = {
  landscapePicture: 'J의 지형',
  landscapeTitle: 'J의 지형',
  landscapeAcross: '가로축의 이득',
  landscapeUp: '세로축의 이득',
  landscapeFollows: '주행과 같게',
};

export const mapLabel =
  '두 이득에 대한 J의 지형. 화살표 키로 커서를 옮기고, Shift와 함께 더 크게 옮깁니다. Enter를 누르면 커서가 가리키는 이득으로 주행합니다.';

/** @param {string} name */
export const thirdLabel = (name) => `${name}, 모든 점에서 같은 값`;

/** @param {string} gain */
export const onLogAxis = (gain) => `${gain}, 로그`;

/** @param {number} drives @param {number} milliseconds */
export const drivesText = (drives, milliseconds) => `주행 ${grouped(drives)}회, ${tookText(milliseconds)}`;

export const computing = '로봇이 주행하고 있습니다…';

/** @param {string} message @param {boolean} kept */
export const failed = (message, kept) =>
  `${kept ? '마지막으로 계산된 비용 지형입니다' : '계산하지 못했습니다'}: ${message}`;

/** @param {string} who Empty for the cursor. @param {string} gains @param {Run} run @param {string} outcome @param {boolean} isOneOfMany J is from the first start, the map from all. */
export const readout = (who, gains, run, outcome, isOneOfMany) =>
  `${who ? `${who}, ` : ''}${gains}: ${isOneOfMany ? '첫 출발점에서 ' : ''}J ${costText(run.cost.total)}, ${outcome}`;

/** At its mark on the map. */
export const lowest = '최저점';
/** @param {number} points @param {string} gains @param {number} cost */
export const lowestText = (points, gains, cost) =>
  `계산한 점 ${grouped(points)}개 중 가장 낮은 점: J ${costText(cost)}, ${gains}`;

/** @param {number} count */
export const outside = (count) => `개체군의 로봇 ${count}대는 이 범위 밖에 있습니다`;

export const paperEp = '논문 EP';
export const paperArbitrary = '논문 임의';
export const hand = '직접 조정';

/** What is drawn of a method, beside its robots. @type {Readonly<Record<import('../../../core/methods.js').Method, string>>} */
const sketches = {
  ep: '',
  random: '',
  'cma-es': '타원은 이 로봇들을 뽑은 분포이며, 표준편차의 1배와 2배입니다.',
  de: '다른 선은 한 로봇에서 시험한 곳까지이며, 다른 두 로봇의 차이의 절반만큼 갑니다. 실선: 시험한 것이 자리를 차지함. 파선: 그때의 차이.',
  'nelder-mead':
    '다른 선은 심플렉스입니다. 파선은 가장 나쁜 꼭짓점 대신 시험한 곳까지이고, 그곳이 받아들여졌으면 밀려난 꼭짓점까지입니다.',
  'one-plus-one-es': '다른 선은 시험한 걸음입니다.',
  'one-at-a-time': '다른 선은 시험한 걸음입니다.',
  'finite-differences':
    '다른 선은 시험한 걸음입니다. 기울기를 재는 짧은 걸음 셋이거나, 그 기울기를 따라 내려가는 걸음 하나입니다.',
};
/** Marks that are not in the slice. @param {string} name Of the gain that is on no axis. */
export const paler = (name) => `흐린 표시: ${name} 값이 다름.`;

/** @type {Partial<typeof sketches>} */
const crosses = { ep: '십자: 로봇 ±σ.', 'one-plus-one-es': '십자: 로봇 ±σ.' };

/** @param {import('../../../core/methods.js').Method} method @param {boolean} [isStill] No σ is above 0. */
export const methodSketch = (method, isStill = false) =>
  [(!isStill && crosses[method]) || '점: 로봇.', '선: 지금까지의 최우수. 등고선: 같은 J.', sketches[method]]
    .filter(Boolean)
    .join(' ');
