// The step “landscape” in Korean.
import { costText, fixed, threeDigits } from '../../../words/ko/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */
/** @typedef {import('../common.js').Lowest} Lowest */

export const landscape = {
  texts: {
    map: `이 단계를 열면 나오는 지도에서는 점 하나하나가 로봇입니다. 오른쪽으로 갈수록 {kx}가, 위로 갈수록 {kt}가 커지고, {ky}는 어디서나 같습니다. 색은 그 로봇의 {J}이며 어두울수록 좋습니다. 이 그림을 그리려고 로봇 {=drives}대가 주행했습니다. *아무 곳이나 누르면 그 로봇이 주행합니다.*

하얀 점은 개체군입니다. *“진화 시작”을 누르고* 개체군이 옮겨 가는 것을 보십시오. 선은 최우수 로봇이 지나온 길입니다. 지금은 {=generation}세대이고, 여기까지 {=spent}번 주행했습니다. 그런데 진화는 *이 지도를 보지 못합니다*. 자기 로봇이 서 있는 곳의 {J}만 압니다.`,
    shape: `처음에 나온 지도에서 세 가지에 이름을 붙여 봅시다. *골짜기*는 어두운 곳입니다. 그 지도의 {=floor}%는 계산한 점 중 가장 낮은 점(짧은 선 네 개로 표시한 곳)과의 비용 차이가 5%를 넘지 않습니다. 그러니 아주 다른 이득도 거의 똑같이 좋을 수 있습니다. *벼랑*에서는 어두운 색이 단번에 밝은 노란색으로 바뀝니다. 그 너머의 로봇은 도착하지 못하여 {=horizon}초 내내 비용이 쌓입니다. *잔물결*은 제어 법칙에서 생깁니다. 법칙은 sin {te}로 나누는데, 샘플링하는 바로 그 순간에 {te}가 0을 지나면 바퀴가 그 샘플 동안 제한 속도로 돌아 에너지를 씁니다.

지도를 통째로 그릴 수 있는데 왜 탐색을 할까요? 이 지도에는 이득이 *두 개*뿐이기 때문입니다. 세 이득을 모두 이만큼 촘촘한 격자로 나누면 {=grid}번 주행해야 하고, 이득이 하나 늘 때마다 {=side}배가 됩니다.

기울기를 따라 내려가는 방법은 벼랑과 잔물결에 걸리거나 *국소 최적점(local optimum)*에 멈출 수 있습니다. 둘레의 어느 곳보다 좋지만 가장 좋지는 않은 곳입니다. 진화에는 기울기가 필요 없습니다. 비교만 합니다. 그래서 강인하지만, 언제나 성공하는 것은 아닙니다.`,
    next: `대부분의 시드에서 진화는 출발점 하나와 목표 하나로 정해지는 *한* 지형의 가장 낮은 점 가까이에 이릅니다. 로봇은 주차를 배웠을까요, 아니면 그 한 곳에서 출발하는 주차만 배웠을까요? 이 물음은 12단계에서 다룹니다. 그 전에, 여기까지 온 것은 이 방법의 어느 부분 덕분일까요?`,
  },
  quizzes: {
    turn: {
      question: '목표의 방향만 45°에서 90°로 돌립니다. 다른 것은 그대로입니다. 가장 낮은 점은 어떻게 됩니까?',
      choices: [
        '그대로 있다',
        '옮겨 가지만, 예전의 이득으로도 도착은 한다',
        '옮겨 가고, 예전의 이득으로는 더 이상 도착하지 못한다',
      ],
      /** @param {{ old: Lowest, now: Lowest, left: Run, again: string }} outcome `again` opens the drive with the old gains. */
      why: ({ old, now, left, again }) =>
        `45°일 때: ${place(old)}, {J} ${costText(old.cost)}. 지금: ${place(now)}, {J} ${costText(now.cost)}. [예전의 가장 낮은 점의 이득으로 달려 보기](${again}): {J} ${costText(left.cost.total)}, 로봇은 ${arrival(left)}. 넓던 골짜기가 두 벼랑 사이의 좁은 협곡이 되었습니다. 목표를 끌면서 지형이 바뀌는 것을 보십시오.`,
    },
    ky: {
      question: '다시 45°로 돌아와, 이번에는 위로 {ky}가 커집니다. {ky}를 따라 가장 낮은 점은 어디입니까?',
      choices: [
        '가운데. 법칙에는 세 이득이 다 필요하다',
        '아래 끝. {ky}는 0이 가장 좋다',
        '위 끝. 많이 바로잡을수록 좋다',
      ],
      /** @param {{ lowest: Lowest, middle: Run, wall: Run }} outcome */
      why: ({ lowest, middle, wall }) =>
        `지도에서 가장 낮은 점은 {ky} ${fixed(lowest.gains[1], 2)}에 있고 {J}는 ${costText(lowest.cost)}입니다. 거기서 {ky}만 ${threeDigits(lowest.most / 2)}까지 올리면 {J}가 ${costText(middle.cost.total)}입니다. 그래서 최우수 로봇은 아래 끝까지 내려갑니다. 그 너머에는 벽이 있습니다. {ky} −0.01에서 {J}는 ${costText(wall.cost.total)}이고, 그 가운데 ${costText(wall.cost.penalty)}은 음수 이득의 벌점이며, 로봇은 ${wall.arrived ? '도착합니다' : '도착하지 못합니다'}.`,
    },
  },
  tries: {
    walked: '100세대 뒤',
    smooth: '{ky} = 0인 같은 지도: 잔물결이 없다',
    deep: '위로 {ky}, 로그 축: 선이 지도 아래로 벗어난다. {ky}가 얼마나 작아졌는지는 지도 아래에 있다',
    stuck: '목표 0°, 시드 3: 협곡에 갇힌다',
  },
  notice: [
    '최우수 로봇은 대부분의 세대에 제자리에 있습니다. 가끔 자손 하나가 더 나은 곳에 내려앉으면 선이 건너뜁니다.',
    '점을 지나는 가는 십자는 변이 폭 σ입니다. “해 볼 것”의 마지막에 나오는 협곡에서는 거의 0으로 줄어 있습니다. 왼쪽으로 가면 {J}가 더 낮은데도 로봇은 길을 찾지 못합니다.',
    '점마다 {ky}가 다르므로, 점 밑의 색은 그 로봇의 {J}와 조금 다릅니다.',
    '논문은 가중치를 알려 주지 않지만, 논문의 EP 이득도 이 골짜기 안에 있습니다. 임의 이득은 그렇지 않습니다.',
  ],
};

/** @param {Lowest} lowest */
const place = ({ gains: [kx, , ktheta] }) => `{kx} ${fixed(kx, 2)}, {kt} ${fixed(ktheta, 2)}`;

/** @param {Run} run */
const arrival = (run) =>
  run.arrived
    ? `${fixed(run.finalTime, 2)}초 뒤 도착합니다`
    : `${fixed(run.finalTime, 0)}초 안에 도착하지 못합니다`;
