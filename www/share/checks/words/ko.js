// Every word about the page's checks of its own numbers, in Korean.
/** @import { Group, Outcome, Sentences, Task } from '../../../core/checks/check.js' */
/** @import { Preset } from '../../../core/engine.js' */
import { valuesText } from './common.js';

export * from './common.js';

export const texts = {
  checksHelp:
    '알려진 값과 법칙을 이 브라우저에서 다시 계산합니다. 이 프로그램의 테스트도 브라우저 밖에서(네이티브와 Node) 같은 값을 확인합니다.',
  checksCopy: '텍스트로 복사',
  checksProgress: '끝난 검사',
  checksList: '검사 목록',
  checksText: '텍스트로 쓴 검사 결과',
};

/** @type {Readonly<Record<Group, string>>} */
export const groups = {
  motion: '로봇',
  cost: '비용 J',
  evolution: '진화',
  bits: '어느 컴퓨터에서나 같은 비트',
};

/** @type {Readonly<Record<Preset, string>>} */
const limits = {
  'velocity-limits': '속도 제한',
  'acceleration-limits': '속도와 가속도 제한',
};

/** @type {Readonly<Record<Exclude<Task, 'parking'>, string>>} */
const tasks = {
  noise: '무작위 외란',
  tracking: '움직이는 기준 자세',
  unlimited: '제한 없음',
};

/** @type {Sentences} */
export const sentences = {
  command: (number) => [
    `자세 ${number}에서 제어 법칙 (5)의 명령은 독립된 프로그램이 계산한 값과 같습니다.`,
    'v, ω',
  ],
  errorPosture: (count) => [`로봇과 목표 ${count}쌍의 오차 자세는 식 (3)과 같습니다.`, '최대 차이'],
  lyapunovRate: (count) => [
    `제한이 없으면 자세 ${count}개에서 V는 정리 1에 대한 이 페이지의 증명대로 줄어듭니다. V̇ = −kx xₑ² cos² θₑ − ky yₑ⁴ − kθ sin² θₑ.`,
    '최대 상대 차이',
  ],
  halfArcs: (count) => [`호를 반씩 두 번 달려도 한 번에 달린 곳에 이릅니다(${count}회).`, '최대 거리'],
  circle: (count) => [`호 ${count}개는 모두 기구학 (2)의 원 위에서 끝납니다.`, '최대 거리'],
  speeds: (count) => [`주행 ${count}회에서 어떤 속도도 제한을 넘지 않습니다.`, '최대 |v|, |ω|'],
  accelerations: (count) => [
    `주행 ${count}회에서 어떤 가속도도 제한을 넘지 않습니다.`,
    '최대 |dv/dt|, |dω/dt|',
  ],
  limitsTwice: (count) => [
    `주행 ${count}회의 모든 샘플에서 명령을 두 번 제한한 값은 한 번 제한한 값과 같습니다.`,
    '다른 속도의 수',
  ],
  mirror: (count) => [`주차의 좌우를 뒤집어도 로봇 ${count}대의 비용은 같습니다.`, '다른 J의 수'],
  parked: (count) => [
    `주행 ${count}회에서 Kanayama의 규칙은 목표가 멈춰 있으면 로봇을 회전시키지 않습니다.`,
    '최대 |ω|',
  ],
  run: (preset, gains, withPosture) => [
    `이득 ${gains.join(', ')}의 비용은 독립된 프로그램이 계산한 값과 같습니다(${limits[preset]}).`,
    withPosture ? 'J, t_f, x, y, θ' : 'J, t_f',
  ],
  paperOrder: () => [
    '두 실험 모두 논문이 진화로 찾은 이득의 비용이 임의로 고른 이득의 비용보다 낮습니다. 논문과 같습니다.',
    '두 J',
  ],
  parts: (count) => [`주행 ${count}회의 경로에서 다시 더한 J는 식 (9)와 같습니다.`, '최대 상대 차이'],
  lanes: (count, preset) => [
    `한꺼번에 주행한 로봇 ${count}대의 비용은 한 대씩 주행한 비용과 같습니다(${limits[preset]}).`,
    '한 비트라도 다른 J의 수',
  ],
  lanesFromStarts: (count) => [
    `무작위 외란 속에서 출발점 ${count}개에서 주행해도 그렇습니다.`,
    '한 비트라도 다른 J의 수',
  ],
  mapRows: (rows) => [
    `${rows}줄로 나누어 계산한 J 지도는 한 번에 계산한 지도와 같습니다.`,
    '한 비트라도 다른 칸의 수',
  ],
  learningRates: () => ['이득이 n = 3개일 때 τ = 1/√(2√n), τ′ = 1/√(2n)입니다.', 'τ, τ′'],
  offspringGains: (generations) => [
    `${generations}세대 동안 모든 자손의 이득은 부모의 σ로 만든 k′ = k + σ N(0, 1)입니다.`,
    '한 비트라도 다른 이득의 수',
  ],
  offspringSigmas: () => [
    '모든 자손의 변이 폭은 σ′ = σ exp(τ′ N(0, 1) + τ N(0, 1))입니다.',
    '최대 상대 차이',
  ],
  drawMean: () => ['이 난수들의 평균은 0에 가깝습니다.', '평균'],
  drawVariance: () => ['그 분산은 1에 가깝습니다.', '분산'],
  drawCorrelation: () => ['k에 쓴 난수와 σ에 쓴 난수는 서로 상관이 없습니다.', '상관계수'],
  offspringCosts: () => [
    '모든 자손의 J는 그 이득으로 다시 주행한 비용과 같습니다.',
    '한 비트라도 다른 J의 수',
  ],
  strangers: () => ['토너먼트에서 누구도 자기 자신과 겨루지 않습니다.', '그런 대결의 수'],
  wins: () => ['대결마다 다시 세어도 승수는 모두 맞습니다.', '틀린 승수의 수'],
  survivors: () => [
    '승수가 가장 많은 개체가 남고, 승수가 같으면 J가 낮은 개체가 남습니다.',
    '다른 자리의 수',
  ],
  parents: () => [
    '한 세대에서 남은 개체는 σ와 함께 다음 세대의 부모가 됩니다.',
    '한 비트라도 다른 수의 개수',
  ],
  neverWorse: (generations) => [`${generations}세대 동안 최소 J는 한 번도 오르지 않습니다.`, '오른 횟수'],
  optimum: (generations) => [
    `${generations}세대 뒤의 최소 J는 독립된 프로그램이 찾은 가장 낮은 값 7.70에 가깝습니다.`,
    'J',
  ],
  hash: (task, preset, seed, generations) => [
    `시드 ${seed}, ${task === 'parking' ? limits[preset] : tasks[task]}: ${generations}세대를 진화시킨 지문은 알려진 값과 같습니다.`,
    '지문',
  ],
  watched: (generations) => [`진화는 ${generations}세대 동안 들여다보아도 똑같이 진행됩니다.`, '지문'],
  draws: (seed) => [`시드 ${seed}의 첫 난수는 알려진 값과 같습니다.`, '다른 수의 개수'],
  worker: (generations) => [
    `워커가 진화시킨 ${generations}세대는 페이지가 직접 진화시킨 것과 비트까지 같습니다.`,
    '지문',
  ],
};

/** What must come out. @param {Outcome} outcome */
export function expectedText(outcome) {
  const values = valuesText(outcome.expected, outcome);
  switch (outcome.bound) {
    case 'atMost':
      return `${values} 이하`;
    case 'below':
      return `${values} 미만`;
    case 'between':
      return values.replace(', ', '~');
    default:
      return values;
  }
}

export const expectedWord = '기대한 값';
export const foundWord = '나온 값';

/** @param {boolean} passed */
export const verdict = (passed) => (passed ? '통과' : '실패');

export const checking = '검사하는 중…';

/** @param {number} failed @param {number} count @param {number} milliseconds */
export function summary(failed, count, milliseconds) {
  const time = `${(milliseconds / 1000).toFixed(2)}초`;
  return failed === 0
    ? `검사 ${count}개를 모두 통과했습니다(${time}).`
    : `검사 ${count}개 중 ${failed}개가 실패했습니다(${time}). 이 환경에서는 계산 결과를 믿을 수 없습니다.`;
}

/** @param {string} reason */
export const unfinished = (reason) => `검사를 끝내지 못했습니다: ${reason}`;

export const copied = '텍스트를 복사했습니다.';
export const notCopied =
  '이 브라우저는 페이지의 복사를 허용하지 않습니다. 텍스트를 선택해 두었으니 키보드로 복사하십시오.';
