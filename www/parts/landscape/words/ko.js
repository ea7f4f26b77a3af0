// Every word of the landscape, in Korean.
/** @import { Run } from '../../../core/engine.js' */
import { costText, fixed, grouped } from '../../../words/ko/numbers.js';

export * from './common.js';

export const texts = {
  landscapePicture: 'J의 비용 지형',
  landscapeTitle: 'J의 비용 지형',
  landscapeAcross: '가로축의 이득',
  landscapeUp: '세로축의 이득',
  landscapeFollows: '주행과 같게',
};

export const mapLabel =
  '두 이득에 대한 J의 비용 지형. 화살표 키로 커서를 옮기고, Shift와 함께 더 크게 옮깁니다. Enter를 누르면 커서가 가리키는 이득으로 주행합니다.';

/** @param {string} name */
export const thirdLabel = (name) => `${name}, 모든 점에서 같은 값`;

/** @param {string} gain */
export const onLogAxis = (gain) => `${gain}, 로그`;

/** @param {number} drives @param {number} milliseconds */
export const drivesText = (drives, milliseconds) => `주행 ${grouped(drives)}회, ${fixed(milliseconds, 0)} ms`;

export const computing = '로봇이 주행하고 있습니다…';

/** @param {string} message */
export const failed = (message) => `마지막으로 계산된 비용 지형입니다: ${message}`;

/** @param {string} gains @param {Run} run @param {string} outcome */
export const readout = (gains, run, outcome) => `${gains}: J ${costText(run.cost.total)}, ${outcome}`;

/** @param {number} count */
export const outside = (count) => `개체군 중 ${count}대는 이 범위 밖에 있습니다`;

export const paperEp = '논문 EP';
export const paperArbitrary = '논문 임의';
export const hand = '직접 조정';
