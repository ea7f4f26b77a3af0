// Every word of the settings, in Korean.
import { namer } from '../common/settings.js';
import { wasText } from './numbers.js';

export * from '../common/settings.js';

export const texts = {
  settingsTitle: '설정',
  closeSettings: '설정 닫기',
  backToPreset: '기본 설정으로',
  undo: '되돌리기',
  redo: '다시 적용',
};

/** @param {number} changed */
export const buttonText = (changed) => (changed === 0 ? '설정' : `설정 · ${changed}`);

/** @param {number} changed */
export const changedText = (changed) => (changed === 0 ? '기본 설정과 같음' : `${changed}개 바뀜`);

export const hint = '항목을 가리키거나 누르면 설명이 나타납니다.';

export const groups = {
  limits: '제한',
  weights: '비용 J',
  task: '출발과 목표',
  arrival: '도착과 시간',
  law: '제어 법칙',
  disturbance: '외란',
  evolution: '진화',
  method: '방법과 구성 요소',
};

/** Names and help, by the path in the experiment. @type {Readonly<Record<string, import('../common/settings.js').SettingWords>>} */
export const settings = {
  'limits.speed': { name: '선속도', help: '앞으로든 뒤로든 로봇은 이보다 빨리 달릴 수 없습니다.' },
  'limits.turnRate': { name: '각속도', help: '로봇은 이보다 빨리 회전할 수 없습니다.' },
  'limits.acceleration': { name: '가속도', help: '선속도는 이보다 빨리 변할 수 없습니다.' },
  'limits.turnAcceleration': { name: '각가속도', help: '각속도는 이보다 빨리 변할 수 없습니다.' },
  'weights.final[0]': { name: '최종 x', help: 'x 방향으로 목표를 벗어나 멈출 때의 비용입니다.' },
  'weights.final[1]': { name: '최종 y', help: 'y 방향으로 목표를 벗어나 멈출 때의 비용입니다.' },
  'weights.final[2]': { name: '최종 방향각', help: '목표와 다른 방향각으로 멈출 때의 비용입니다.' },
  'weights.velocity[0]': {
    name: '빠른 주행',
    help: '선속도의 비용입니다. 클수록 진화는 느린 로봇을 고릅니다.',
  },
  'weights.velocity[1]': {
    name: '빠른 회전',
    help: '회전의 비용입니다. 클수록 진화는 완만한 곡선을 고릅니다.',
  },
  'weights.penalty': { name: '음의 이득', help: '이득이 0보다 1만큼 작을 때마다 더하는 비용입니다.' },
  'starts[0].x': { name: '출발 x', help: '로봇이 출발하는 곳입니다. 평면에서 끌어 옮길 수도 있습니다.' },
  'starts[0].y': { name: '출발 y', help: '로봇이 출발하는 곳입니다. 평면에서 끌어 옮길 수도 있습니다.' },
  'starts[0].theta': {
    name: '출발 방향각',
    help: '출발할 때 로봇이 향하는 방향입니다. 90°는 평면의 위쪽입니다.',
  },
  'goal.x': { name: '목표 x', help: '로봇이 멈추어야 할 곳입니다. 평면에서 끌어 옮길 수도 있습니다.' },
  'goal.y': { name: '목표 y', help: '로봇이 멈추어야 할 곳입니다. 평면에서 끌어 옮길 수도 있습니다.' },
  'goal.theta': { name: '목표 방향각', help: '마지막에 로봇이 향해야 할 방향입니다.' },
  'referenceVelocity.linear': {
    name: '기준 선속도',
    help: '0이면 주차입니다. 0이 아니면 기준 자세가 목표에서 출발하고, 로봇은 제한 시간까지 기준 자세를 따라갑니다.',
  },
  'referenceVelocity.angular': { name: '기준 각속도', help: '움직이는 기준 자세의 각속도입니다.' },
  'tolerance.position': {
    name: '위치 허용 오차',
    help: '방향각도 맞으면서 목표에 이만큼 가까우면 도착으로 봅니다.',
  },
  'tolerance.heading': {
    name: '방향각 허용 오차',
    help: '위치도 맞으면서 목표의 방향각에 이만큼 가까우면 도착으로 봅니다.',
  },
  'tolerance.speed': {
    name: '선속도 허용치',
    help: '이보다 빠른 로봇은 아직 도착한 것으로 보지 않습니다. 끄면 선속도를 보지 않습니다.',
  },
  'tolerance.turnRate': {
    name: '각속도 허용치',
    help: '이보다 빨리 회전하는 로봇은 아직 도착한 것으로 보지 않습니다. 끄면 회전을 보지 않습니다.',
  },
  horizon: { name: '제한 시간', help: '이때까지 도착하지 못한 로봇은 멈춥니다.' },
  sampleTime: { name: '샘플링 주기', help: '제어기는 이 간격마다 명령을 한 번 내립니다.' },
  law: {
    name: '법칙',
    help: '오차를 명령으로 바꾸는 법칙입니다. Kanayama의 규칙으로는 주차하는 로봇을 회전시킬 수 없습니다.',
    choices: { 'shim-kim': 'Shim과 Kim, 1994', kanayama: 'Kanayama 등, 1990' },
  },
  'disturbance.kind': {
    name: '종류',
    help: '진화가 주행시키는 로봇까지 포함하여 모든 로봇의 속도에 더해집니다.',
    choices: { none: '없음', random: '무작위', slip: '일정한 미끄러짐' },
  },
  'disturbance.linear': { name: '선속도 외란', help: '무작위 외란의 상한 또는 미끄러짐의 크기입니다.' },
  'disturbance.angular': { name: '각속도 외란', help: '무작위 외란의 상한 또는 미끄러짐의 크기입니다.' },
  'disturbance.seed': { name: '외란의 시드', help: '시드가 같으면 외란도 같습니다.' },
  'evolution.population': { name: '개체군 크기', help: '세대마다 살아남는 로봇의 수입니다.' },
  'evolution.opponents': {
    name: '상대 수',
    help: '토너먼트에서 로봇 하나가 만나는 상대의 수입니다. 많을수록 선택압이 커집니다.',
  },
  'evolution.seed': { name: '시드', help: '시드가 같으면 어느 기기에서나 진화가 같습니다.' },
  'evolution.initialRange[0]': {
    name: '초기 이득 하한',
    help: '초기 이득을 무작위로 뽑는 범위의 시작입니다.',
  },
  'evolution.initialRange[1]': { name: '초기 이득 상한', help: '초기 이득을 무작위로 뽑는 범위의 끝입니다.' },
  'evolution.initialSigma': {
    name: '초기 σ',
    help: '첫 자손이 부모에게서 벗어나는 폭입니다. 그 뒤로는 진화가 스스로 조절합니다.',
  },
  'evolution.method': {
    name: '방법',
    help: '이득을 찾는 방법입니다. 논문의 진화 프로그래밍이나 다른 방법을 고릅니다.',
    choices: {
      ep: '진화 프로그래밍',
      random: '무작위 탐색',
      de: '차분 진화',
      'cma-es': 'CMA-ES(공분산 행렬 적응)',
      'one-plus-one-es': '(1+1)-ES, 1/5 규칙',
      'nelder-mead': '넬더–미드',
      'one-at-a-time': '이득을 하나씩',
      'finite-differences': '기울기를 따라',
    },
  },
  'evolution.belowZero': {
    name: '0보다 작은 이득',
    help: '벌점을 매기고 그대로 시험하거나, 시험하기 전에 0을 기준으로 뒤집거나 0으로 바꿉니다.',
    choices: { penalty: '벌점', mirror: '뒤집기', clamp: '0으로 바꾸기' },
  },
  'evolution.step': {
    name: '돌연변이의 분포',
    help: '돌연변이가 따르는 분포입니다. 코시 분포에서는 작은 걸음이 더 드물고, 가끔 훨씬 큰 걸음이 나옵니다.',
    choices: { gaussian: '가우스', cauchy: '코시' },
  },
  'evolution.adaptation': {
    name: '자기 적응',
    help: 'σ를 바꾸는 τ와 τ′에 곱하는 수입니다. 0이면 σ가 바뀌지 않습니다.',
  },
  'evolution.sigmaFloor': { name: 'σ의 하한', help: 'σ는 이 값 아래로 내려가지 않습니다.' },
  'evolution.selection': {
    name: '생존 선택',
    help: '살아남는 개체를 정하는 방식입니다. 가장 많이 이긴 개체, 비용이 가장 낮은 개체, 또는 부모와 자손 중 나은 쪽입니다.',
    choices: { tournament: '토너먼트', truncation: '가장 낮은 J', parent: '자손 대 부모' },
  },
  'evolution.crossover': {
    name: '교차',
    help: '돌연변이에 앞서 부모가 다른 부모와 이득을 하나씩 섞을 확률입니다.',
  },
};

/** What the core says, with the names on screen; some of its paths have no row. */
export const named = namer({ ...settings, 'evolution.initialRange': { name: '초기 이득의 하한과 상한' } });

export const noLimit = '제한 없음';

/** @param {string} name */
export const limitLabel = (name) => `제한: ${name}`;
/** @param {string} name @param {string} value */
export const backLabel = (name, value) => `${name}: ${value} 값으로 되돌리기`;

/** @param {{ integer: boolean, from: string, to: string }} range */
export const rangeText = ({ integer, from, to }) => `${from} 이상 ${to} 이하의 ${integer ? '정수' : '수'}`;
/** @param {string} name @param {string} expected @param {string} was */
export const refused = (name, expected, was) => `${name}: 허용되는 값은 ${expected}입니다. ${wasText(was)}`;
/** @param {string} name @param {string} help @param {string} range */
export const helpText = (name, help, range) => `${name}: ${help}${range ? ` 허용 범위: ${range}.` : ''}`;
