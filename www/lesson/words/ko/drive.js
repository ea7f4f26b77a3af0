// The step “drive” in Korean.
import { changeText, costText, fixed } from '../../../words/ko/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */

export const drive = {
  texts: {
    begin: `이 로봇은 바퀴 두 개로 달립니다. 오른쪽 위의 화살표에 주차해야 합니다. 바로 그 자리에, 화살표와 같은 방향을 보고 서야 합니다. 달리고 제자리에서 돌 수는 있지만 옆으로는 움직일 수 없는 로봇의 모형을 *유니사이클(unicycle)*이라고 합니다. 숫자 세 개, 곧 *이득*이 주행을 결정합니다.

그림 아래의 슬라이더 세 개를 움직여 보십시오. 숫자를 바꿀 때마다 로봇이 다시 달립니다. 큰 숫자 *J*는 이 주행의 비용입니다. 걸린 *시간*, 가는 동안(*경로*)과 마지막에(*최종*) 목표에서 얼마나 떨어져 있었는지, 얼마나 빨리 달리고 돌았는지(*에너지*)를 모두 더한 값입니다. *낮을수록 좋습니다.*

이 페이지가 따르는 논문은 진화 없이 고른 *임의* 이득(여기서 J는 {=arbitrary})과 진화 프로그래밍(EP)이 찾은 이득({=ep})을 비교합니다. *두 값보다 더 낮출 수 있습니까?*`,
    next: `감에 의지해 숫자를 바꾸고, 지켜보고, 더 나은 것을 남겼습니다. 출발점이 하나이면 어렵지 않습니다. 곧 어려워집니다. 같은 세 숫자로 사방에서 출발하는 로봇을 모두 주차시켜야 합니다. 그때는 방금 손으로 한 일을 진화가 대신합니다. 로봇 스무 대로 한꺼번에 하고, 지치지도 않습니다. 그런데 이 세 숫자는 도대체 무엇일까요?`,
  },
  /** @param {import('../common.js').Drives} tally */
  tally: ({ drives, best }) =>
    best
      ? `지금까지 가장 좋은 결과: J ${costText(best.cost)}, 숫자 ${best.gains.map((gain) => fixed(gain, 2)).join(', ')}. 주행 ${drives}번.`
      : drives > 0
        ? `주행 ${drives}번, 아직 한 번도 도착하지 못했습니다.`
        : '여기서는 아직 슬라이더를 옮기지 않았습니다. 한 번 끌면 주행 한 번입니다.',
  quizzes: {
    bolder: {
      question: '세 숫자를 모두 5로 했다가 모두 10으로 올리면 무엇이 달라집니까?',
      choices: ['더 빨리 도착하고 J도 낮아진다', '더 빨리 도착하지만 J는 높아진다', '더 늦게 도착한다'],
      /** @param {{ gentle: Run, bold: Run }} outcome */
      why: ({ gentle, bold }) =>
        `5로는 ${arrival(gentle)}, J는 ${costText(gentle.cost.total)}입니다. 10으로는 ${arrival(bold)}, J는 ${costText(bold.cost.total)}입니다. 5에서 10으로 바꾸면 J는 시간에서 ${changeText(bold.cost.time - gentle.cost.time)}, 경로에서 ${changeText(bold.cost.path - gentle.cost.path)}, 에너지에서 ${changeText(bold.cost.energy - gentle.cost.energy)}만큼 달라집니다. 두 주행이 모두 그려져 있습니다. 5로 달린 주행은 비교할 수 있게 *고정*해 두었으며, 색이 있는 파선이 그것입니다.`,
    },
  },
  tries: {
    stops: '첫째 숫자만: 3, 0, 0. 어디에 멈추며, 왜 하필 거기인가?',
    onlySecond: '둘째만: 0, 5, 0',
    noDrive: '셋째만: 0, 0, 5',
    negative: '첫째를 0보다 작게: −1, 1, 5. 그러면 {J}에 벌점도 붙는다',
    paper: '논문에서 진화가 찾은 숫자',
  },
  notice: [
    '같은 시각에 도착해도 J는 다를 수 있습니다. 비용이 더 든 주행은 무엇에 비용을 썼을까요? J 아래의 막대가 알려 줍니다.',
    '숫자를 조금 바꾸면 주행도 대개 조금 바뀝니다. 그러다가 어느 순간 갑자기 달라지기도 합니다.',
  ],
};

/** @param {Run} run */
const arrival = (run) =>
  run.arrived ? `${fixed(run.finalTime, 2)}초 뒤에 도착하고` : '끝내 도착하지 못하고';
