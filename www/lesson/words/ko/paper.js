// The step “paper” in Korean.
import { costText } from '../../../words/numbers.js';

export const paper = {
  texts: {
    same: `지금까지 본 것은 모두 1995년에 김종환과 심현식이 쓴 논문을 따릅니다. 논문에는 주행 네 개의 이득과 J가 실려 있습니다. 가르치는 페이지라면 그 주행을 다시 보일 수 있어야 합니다. 정말 그럴 수 있을까요?`,
    order: `*순서*는 논문과 같습니다. 두 가지 제한 모두에서 진화한 이득이 임의 이득보다 낫습니다. 속도 제한에서 임의 이득의 비용은 여기서 {=velocity}배, 논문에서 {=paperVelocity}배입니다. 가속도 제한에서는 논문에서 {=paperAcceleration}배, 여기서는 아예 도착하지 못해 {=acceleration}배입니다. 이 페이지의 진화도 논문과 비슷한 크기의 {kx}와 {kt}를 찾고, 논문에서처럼 {ky}를 0 가까이 보냅니다.

*수치 자체*는 논문과 다릅니다. 정직한 프로그램이라면 같게 만들 수 없습니다. J는 논문에 없는 가중치와 규칙에 따라 달라지기 때문입니다. 이 페이지는 맞을 때까지 고치지 않았습니다. 논문에 있는 것과, 논문에 없어 이 페이지가 고른 것은 다음과 같습니다.`,
    figure7: `다시 그릴 수 없는 그림이 하나 있습니다. 그림 7에서 임의 이득 30, 30, 30의 방향각은 60°를 넘지 않습니다. 여기서는 {=swing}까지 흔들립니다. 가속도 제한을 어떻게 읽어도 논문의 그림이 나오지 않았습니다.`,
  },
  quizzes: {
    lower: {
      question:
        '그림 4(a)의 주행에 대해 논문은 J = 12.4685라고 합니다. 똑같은 이득으로 여기서는 J가 얼마가 됩니까?',
      choices: ['같다', '더 크다', '더 작다'],
      /** @param {{ here: number, there: number }} outcome */
      why: ({ here, there }) =>
        `여기서는 ${costText(here)}, 논문에서는 ${there}입니다. 이득은 논문에 있지만 J의 가중치와 도착의 기준은 없습니다. 그래서 합이 같을 수 없습니다.`,
    },
  },
  tries: {
    horizon: '도착할 때까지가 아니라 언제나 3초 동안 달리게 하고 다시 진화시키기',
    weights: '에너지를 두 배로 셈하기: J는 커지고 주행은 그대로',
    figure7: '그림 7의 임의 이득: 방향각 θ에 주목',
  },
  notice: [
    '시간을 3초로 고정하면 진화는 논문과 거리가 먼 kx를 찾습니다. 그러므로 논문의 주행은 도착할 때 끝났을 것입니다.',
    '이득과 두 주행의 순서는 서로 다른 프로그램 사이에서도 비교할 수 있습니다. J 하나만으로는 모든 가중치를 밝히지 않는 한 비교할 수 없습니다.',
  ],
  /** @param {string} figure @param {'ep' | 'arbitrary'} method */
  row: (figure, method) => `그림 ${figure}, ${method === 'ep' ? 'EP' : '임의'}`,
  /** @param {number} generations */
  ours: (generations) => `이 페이지의 EP, ${generations}세대, 시드 1`,
  head: ['주행', 'kx, ky, kθ', '논문의 J', '이 페이지의 J'],
  choicesTitle: '논문에 있는 것과 이 페이지가 고른 것',
  choicesHead: ['', '논문', '이 페이지'],
  /** @param {import('../common.js').Choices} e */
  choices: (e) => [
    ['출발', '언급 없음. 그래프는 0에서 시작', e.start],
    ['목표', '2 m, 2 m, 45°', e.goal],
    ['최대 선속도', '2 m/s', `${e.speed} m/s`],
    ['최대 각속도', '“2(rad/s)”. 그리스 문자가 빠졌고 그림은 5를 넘음', `${e.turnRate}π rad/s`],
    ['최대 가속도', '5와 “5”', `${e.acceleration} m/s², ${e.turnAcceleration}π rad/s²`],
    ['가중치 W, R', '양수라고만 함', `${e.weights}; ${e.velocityWeights}`],
    ['벌점 κ', '양수라고만 함', e.penalty],
    ['주행의 끝', '“최종 또는 도착 시각”', `${e.position} cm와 ${e.heading} 안, 또는 ${e.horizon}초 뒤`],
    ['로봇 수 N', '언급 없음', e.population],
    ['상대 수', e.opponents, e.opponents],
    ['초기 이득, 초기 σ', '0.01~10; 1', `${e.range.join('~')}; ${e.sigma}`],
    ['샘플 사이', '0.01초. 그 사이의 운동은 언급 없음', `${e.sampleTime}초, 원호를 따라 정확히 계산`],
  ],
};
