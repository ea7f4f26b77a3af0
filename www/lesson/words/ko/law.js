// The step “law” in Korean.
import { degreesText, fixed } from '../../../words/numbers.js';

/** @typedef {import('../../../core/engine.js').Posture} Posture */

export const law = {
  texts: {
    one: `이 로봇은 목표 아래쪽에서 출발하므로 세 오차가 모두 있습니다. *{kx}만 켰고* 나머지 두 이득은 0입니다. 로봇은 {xe}가 없어질 때까지 달린 다음 그대로 서 있습니다. 목표에서 옆으로 {=side} m 벗어나 있고, 방향은 {=turned} 어긋나 있습니다.

*이득*은 오차 하나에 로봇이 얼마나 강하게 반응할지를 정합니다. 막대 하나는 지금 이 순간 선속도 {v}나 각속도 {w}에 더해지는 항 하나입니다. 모두 더한 것이 *법칙*, 곧 오차에서 {v}와 {w}를 정하는 규칙의 명령입니다. 그림의 막대가 그것입니다. 회색 부분은 바퀴가 낼 수 없는 속도입니다.`,
    written: `재생 시각은 법칙의 명령이 가장 큰 순간에 맞추어져 있습니다. 시각을 옮기면 막대가 로봇을 따라 변하고, 슬라이더를 움직이면 막대도 곧바로 변합니다. 목표가 멈춰 있을 때의 논문의 식 (5)도 같은 것을 말합니다. 항을 가리키면 그 항의 슬라이더와 막대, 곡선, 그 안의 오차가 함께 강조됩니다.`,
    each: `이처럼 이득마다 우선 맡은 오차가 하나씩 있습니다. {kx}는 {xe}를, {kt}는 {te}를, {ky}는 {ye}를 줄입니다. 그런데 {kx}의 항은 {w}의 끝에도 하나 더 있습니다. {xe}가 남아 있는 동안 로봇을 목표 방향으로 그은 직선 쪽으로도 돌립니다. (이 항과 {ky}의 항이 무엇을 소거하는지는 다음 단계에 있습니다.) 이제 두 이득을 함께 써 봅시다.`,
    sideways: `{ky}의 항은 왜 sin {te}로 나눌까요? 로봇은 옆으로 달릴 수 없습니다. 옆으로 자리를 옮기려면 조금 비스듬히 돈 다음 달려야 합니다. 적게 돌수록 더 멀리 달려야 합니다. 거의 돌지 않은 채라면 법칙은 불가능한 속도를 명령합니다. 이 항과 짝을 이루는 {w}의 항은 sin {te}의 제곱으로 나누므로 더욱 커집니다. 이 단계를 열었을 때의 출발점에서 [이득이 3, 8, 5이면](lab&drives=hand&gains=3,8,5&start=1.5,0.5,0) 법칙은 {=at}초에 각속도 {=most} rad/s를 명령하고, 제한은 {=leaves} rad/s까지만 허용합니다.`,
    next: `항이 다섯인데 서로 방해하지 않을까요? 방해하지 않도록 만들었습니다. 이득이 0보다 크고 바퀴가 매 순간 명령대로 움직이는 한, 다섯 항이 줄이기만 하는 양이 하나 있습니다.`,
  },
  pushes: {
    tableLabel: '제어 법칙의 각 항이 지금 더하는 값',
    strip: '주행 전체에서 각 항이 더하는 값과 로봇의 시각',
    stripHint: '옅은 선은 모두 더한 값. 끌면 시각이 바뀜.',
    speed: '단위 m/s',
    turnRate: '단위 rad/s',
    moving: '움직이는 목표의 몫',
    asked: '법칙의 명령',
    left: '제한을 거친 뒤',
    otherLaw: '지금은 Kanayama의 규칙으로 달리므로 식 (5)의 항을 보이지 않습니다.',
  },
  quizzes: {
    beside: {
      question: '{kx}는 3, {kt}는 5, {ky}는 0입니다. {ye}를 맡은 이득이 없습니다. 로봇은 어디에 멈춥니까?',
      choices: ['목표에, 방향도 맞게', '목표 옆에, 방향은 맞게', '목표 가까이에, 방향은 틀리게'],
      /** @param {{ arrived: boolean, error: Posture, time: number }} outcome */
      why: ({ arrived, error, time }) =>
        arrived
          ? `${fixed(time, 2)}초 뒤에 도착합니다.`
          : `목표에서 ${fixed(Math.hypot(error.x, error.y), 2)} m 떨어져 섭니다. {xe}는 ${fixed(error.x, 2)} m, {te}는 ${degreesText(error.theta)}, {ye}는 ${fixed(error.y, 2)} m입니다. {xe}와 sin {te}가 0이면 법칙의 모든 항이 0입니다.`,
    },
    ahead: {
      question:
        '이득은 그대로 두고({ky}는 여전히 0), 논문의 출발점인 (0 m, 0 m, 0°)에서 출발합니다. 이번에는 어떻게 됩니까?',
      choices: ['도착한다', '이번에도 목표 옆에 선다', '목표 가까이 가지만 방향이 틀린다'],
      /** @param {{ arrived: boolean, error: Posture, time: number, farthest: number }} outcome */
      why: ({ arrived, error, time, farthest }) =>
        arrived
          ? `${fixed(time, 2)}초 뒤에 도착하고, 옆으로는 ${fixed(Math.abs(error.y), 2)} m 벗어날 뿐입니다. 이 출발점은 목표 방향으로 그은 직선 위, 목표의 뒤쪽에 있습니다. 도는 동안 그 직선에서 ${fixed(farthest, 2)} m 벗어나는 데 그치고, {w}에 있는 {kx}의 항이 로봇을 되돌립니다. 여기서는 {ky}가 없어도 그만입니다. 이 점을 기억해 두십시오.`
          : `마지막에 {xe}는 ${fixed(error.x, 2)} m, {ye}는 ${fixed(error.y, 2)} m, {te}는 ${degreesText(error.theta)}입니다.`,
    },
  },
  tries: {
    onlyKx: '{kx}만: 3, 0, 0',
    onlyKt: '{kt}만: 0, 0, 5. {v}에는 {kt}의 항이 없어 제자리에서 돈다',
    onlyKy: '{ky}만: 0, 8, 0. {ye}만 줄인다',
    all: '셋 모두: 3, 8, 5',
    stuck: '목표 옆에서 {ky} = 0으로 출발: 움직이지 않는다',
    shuffle: '같은 곳에서 {ky} = 8로 출발: 주차할 때처럼 앞뒤로 오가며 옆으로 간다',
    unlimited:
      '셋 모두, 바퀴에 제한이 없을 때: {w}가 가장 큰 순간에 재생이 멈춘다. 막대를 본 뒤 이어서 달려 보기',
  },
  notice: [
    '{ye}가 0이면 항 둘만 남습니다. {kx}의 항이 로봇을 달리게 하고 {kt}의 항이 돌게 합니다.',
    '화살표가 붙은 막대는 그림 밖까지 뻗습니다. 제한이 있다면 그때 로봇을 움직이는 것은 법칙이 아니라 제한입니다.',
    '{w}에는 이득마다 항이 있지만 {v}에는 {kx}와 {ky}의 항만 있습니다.',
    'sin {te} = 0일 때 어떻게 할지는 논문에 없습니다. 여기서는 sin {te}의 크기가 0.000001보다 작으면 부호를 지킨 채 0.000001로 봅니다.',
  ],
};
