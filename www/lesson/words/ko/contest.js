// The step “contest” in Korean.
import { fixed } from '../../../words/numbers.js';
import { grouped } from '../../../words/ko/numbers.js';

/** @typedef {import('../../steps/contest.js').Row} Row */

/** @param {Row} row */
const ertText = ({ ert }) => (Number.isFinite(ert) ? `${grouped(Math.round(ert))}회` : '∞');
/** @param {Row} row */
const reachedText = ({ reached, count }) => `${count}번 중 ${reached}번`;
/** @param {number} p */
const pText = (p) => (p < 0.001 ? 'p < 0.001' : `p = ${fixed(p, 3)}`);

/** What the ranks say of the other one. @param {Row} row @param {string} name */
function rankText({ comparison, count }, name) {
  if (!comparison) return '';
  const { a12, p } = comparison;
  if (p >= 0.05) return `실행 ${count}번으로는 둘의 차이를 알 수 없습니다(${pText(p)}).`;
  const part = Math.round(100 * Math.max(a12, 1 - a12));
  return `양쪽에서 실행을 하나씩 골라 짝지으면 100번 중 ${part}번은 ${name} 쪽이 더 ${a12 > 0.5 ? '낫습니다' : '못합니다'}(${pText(p)}).`;
}

export const contest = {
  texts: {
    begin: `이 방법에는 여러 부분이 있습니다. 토너먼트, 스스로 적응하는 변이 폭, 개체군. *그중 어느 부분이 효과를 낼까요?* 하나를 빼 보면 알 수 있습니다. 다만 대결에서 보았듯이 실행 한 번만으로는 거의 아무것도 알 수 없습니다. 그래서 여기에서는 모든 참가자가 같은 시드로 *51번씩* 실행하고, 한 번에 *4,000회까지* 주행합니다. 세대는 세지 않습니다. 한 세대에 드는 주행 횟수가 방법에 따라 열 배까지도 차이 날 수 있기 때문입니다.

실행에서 알아볼 수 있는 것은 두 가지입니다. 주행을 다 썼을 때 {J}가 얼마나 낮은가, 그리고 {J}가 *목푯값보다 낮아지기까지 몇 번 주행하는가*. 여기서는 뒤의 것을 봅니다. 목푯값 7.72는 알려진 가장 낮은 값보다 0.25% 높습니다.`,
    read: `이런 결과도 결과입니다. 실행의 가운데 절반이 들어 있는 색띠가 서로 겹칩니다. 표에서 *도달*은 목푯값에 이른 실행의 수, *ERT*는 실패한 실행을 다른 시드로 다시 시작한다고 할 때 목푯값까지 드는 평균 주행 횟수, *A12*는 이 참가자의 실행이 첫 참가자의 실행을 이기는 비율, *p*는 우연만으로도 이만큼 차이 날 확률입니다. 7단계에서는 더 나은 로봇이 토너먼트에서 떨어지는 것을 보았습니다. 여기서 잴 수 있는 한 그것은 해가 되지도 도움이 되지도 않습니다.`,
    drag: `*이제 목푯값을 끌어 보십시오.* 점선 왼쪽 끝의 점을 8.09에서 7.72까지 천천히 내립니다. 위쪽에서는 두 곡선이 겹치고, 내려갈수록 갈라지며, 한쪽은 거의 내려가지 않게 됩니다. 폭 1의 걸음은 골짜기를 찾기에는 좋지만 가장 낮은 점을 찾는 데는 쓸모가 없습니다. 8단계의 변이 폭은 *분명히 효과가 있습니다*. 다만 어느 정도 정밀해진 다음부터입니다. 8.09만 보았다면 쓸데없는 장치라고 했을 것입니다.`,
    slide: `그림 아래의 *다른 시드로*를 여러 번 눌러 보십시오. 바뀐 것은 시드뿐인데, 문장은 “뚜렷한 차이”와 “알 수 없음” 사이를 오갑니다. 이어서 “시드를 더 적게 썼다면”의 슬라이더를 3, 10, 20으로 옮겨 보십시오. 이렇게 적은 실행은 대개 답을 정하지 못하는데, 우리가 거기서 답을 읽어 내려 합니다. 때로는 있지도 않은 차이를 보여 주기까지 합니다.`,
    budget: `*세로* 점선은 읽는 시점의 주행 횟수입니다. 4,000회에서 끝까지 끌어 보십시오. 스무 대는 일찍 내려오고 그다음에는 멈춰 섭니다. 그때까지 이르지 못한 실행은 대부분 끝내 이르지 못합니다. 백 대는 느리지만 끝내 이르지 못하는 실행이 적습니다. *목푯값과 주행 한도와 실행 횟수를 정하지 않으면 승자도 없습니다.* 있는 것은 일화뿐입니다.`,
    ellipse: `유명한 CMA-ES가 왜 졌을까요? [비용 지형에서 열어 보십시오](landscape&x=kx&y=ky&evolution.method=cma-es&population=7&generation=55). 타원은 이 방법이 새 로봇을 뽑는 분포입니다. 거의 한 점으로 줄었는데, 그 점이 가장 낮은 곳은 아닙니다. 한 세대에 일곱 번 시험하고 그중 좋은 셋을 따르는 것은, 이득이 셋이고 지형이 매끄러울 때 그 방법을 만든 이들이 권하는 수입니다. 여기의 지형에는 잔물결이 있고, {ky}가 0보다 작아지는 곳에는 벌점의 벽이 있습니다.

처방은 있습니다. [0보다 작은 값을 0을 기준으로 뒤집거나](landscape&x=kx&y=ky&evolution.method=cma-es&population=7&evolution.belowZero=mirror&generation=55), 결정하기 전에 [스무 번 시험하게](landscape&x=kx&y=ky&evolution.method=cma-es&generation=19) 합니다. 어느 쪽이 더 나을까요? 아래 “해 볼 것”의 마지막에서 겨루게 할 수 있습니다. 그러면 진 것은 방법일까요, 그것을 설정한 사람일까요?`,
    next: `문제 하나, 출발점 하나, 이득 셋입니다. 여기서 이긴 방법이 다른 데서도 이기라는 법은 없습니다. 겨루기는 비용이 요구하는 것을 얼마나 *빨리* 찾는지를 잽니다. 비용이 옳은 것을 요구하는지는 어떤 겨루기도 말해 주지 않습니다.`,
  },
  quizzes: {
    tournament: {
      question:
        '토너먼트를 없앱니다. 언제나 {J}가 가장 낮은 로봇 스무 대가 살아남습니다. 51번씩 실행하면 어떻습니까?',
      choices: [
        '분명히 더 못하다: 토너먼트의 운이 다양성을 지켜 준다',
        '분명히 더 낫다: 좋은 것을 하나도 잃지 않는다',
        '차이가 있다고 말할 수 없다',
      ],
      /** @param {{ first: Row, other: Row, target: number }} outcome */
      why: ({ first, other, target }) =>
        `${target}보다 낮아진 실행은 토너먼트가 있을 때 ${reachedText(first)}, 없을 때 ${reachedText(other)}입니다. 목푯값까지 기대되는 주행은 ${ertText(first)}, ${ertText(other)}입니다. ${rankText(other, '토너먼트가 없는')}`,
    },
    sigma: {
      question:
        '이번에는 {s}를 끝까지 1로 둡니다. 아무것도 적응하지 않습니다. 쉬운 목푯값 {J} = 8.09에는 어느 쪽이 먼저 이르고, 7.72에는 어느 쪽이 먼저 이릅니까?',
      choices: [
        '두 목푯값 모두 자기 적응이 먼저',
        '자기 적응이 8.09에서는 먼저가 아니지만 7.72에서는 훨씬 앞선다',
        '자기 적응은 어느 쪽에서도 먼저가 아니다: 1이 알맞은 폭이다',
      ],
      /** @param {{ early: Row[], late: Row[], far: number, near: number }} outcome */
      why: ({ early, late, far, near }) =>
        `${far}까지 드는 주행은 자기 적응으로 ${ertText(early[0])}, σ = 1로 ${ertText(early[1])}입니다. ${rankText(early[1], 'σ = 1')} ${near}보다 낮아진 실행은 자기 적응으로 ${reachedText(late[0])}, σ = 1로 ${reachedText(late[1])}입니다.`,
    },
    fewer: {
      question:
        '7.72에서의 차이는 더 클 수 없을 만큼 큽니다. 시드를 *다섯 개씩만* 썼다면 그 차이를 알 수 있었던 경우(p가 0.05 미만)가 얼마나 됩니까?',
      choices: ['거의 언제나', '절반쯤', '거의 없다'],
      /** @param {{ told: number, few: number }} outcome */
      why: ({ told, few }) =>
        `시드 51개에서 ${few}개를 뽑는 일을 100번 하면 ${told}번입니다. 게다가 이만큼 큰 차이는 드뭅니다.`,
    },
    crowd: {
      question:
        '로봇은 스무 대 대신 백 대, 주행 횟수는 그대로입니다. 7.72보다 낮아지는 실행은 어느 쪽이 더 많습니까?',
      choices: [
        '4,000회 뒤에도 20,000회 뒤에도 스무 대',
        '4,000회 뒤에는 스무 대, 20,000회 뒤에는 백 대',
        '두 번 모두 백 대',
      ],
      /** @param {{ early: Row[], late: Row[], drives: number[] }} outcome */
      why: ({ early, late, drives }) =>
        `주행 ${grouped(drives[0])}회 뒤: 스무 대 ${reachedText(early[0])}, 백 대 ${reachedText(early[1])}. ${grouped(drives[1])}회 뒤: 스무 대 ${reachedText(late[0])}, 백 대 ${reachedText(late[1])}.`,
    },
    rivals: {
      question:
        '주행 횟수가 같은 경쟁자 둘이 있습니다. 로봇들 사이의 차이에서 걸음을 얻는 *차분 진화(DE)*, 그리고 골짜기의 모양을 배우는 가장 유명한 방법 *CMA-ES*(만든 이들이 권하는 대로 한 세대에 일곱 번 시험). 7.72까지 주행이 가장 적게 드는 것(ERT)은 어느 방법입니까?',
      choices: ['논문의 EP', 'DE', 'CMA-ES'],
      /** @param {{ lines: Row[] }} outcome */
      why: ({ lines: [ep, de, cma] }) =>
        `ERT는 EP ${ertText(ep)}, DE ${ertText(de)}, CMA-ES ${ertText(cma)}입니다. 목푯값보다 낮아진 실행은 차례로 ${reachedText(ep)}, ${reachedText(de)}, ${reachedText(cma)}입니다.`,
    },
  },
  tries: {
    floor: '8단계의 처방: {s}의 하한 0.1, 주행 20,000회',
    crossover: '다른 부분 셋: 교차, 코시 돌연변이, 자손 대 부모',
    robots: '로봇 여섯 대, 스무 대, 백 대: {J} = 7.8까지',
    hand: '손으로 하듯 0에서 끝나는 슬라이더를 하나씩, 0에서 끝나지 않게 한 같은 방법, 그리고 심플렉스법(넬더–미드)',
    remedies: 'CMA-ES와 그 처방',
  },
  notice: [
    '다른 부분 셋 가운데 *51번의 실행*으로 더 낫다고 말할 수 있는 것은 교차뿐입니다. 교차에서는 로봇들이 이득과 *변이 폭*을 함께 주고받습니다. 논문에는 교차가 없습니다.',
    '코시 돌연변이로는 34번이 아니라 41번 목푯값에 이릅니다. 51번의 실행으로는 이것을 우연과 구별할 수 없지만, 그렇다고 우연이라는 뜻은 아닙니다. 자손이 자기 부모하고만 겨루게 하면 치명적입니다.',
    '하한을 두면 끝내 이르지 못하는 실행이 훨씬 적지만, 목푯값보다 훨씬 낮아지는 실행도 없습니다. 그때는 걸음이 너무 깁니다.',
    '여섯 대가 스무 대보다 빨리 7.8에 이르는지는 51번의 실행으로 알 수 없습니다. 백 대는 두 배로 주행해야 합니다.',
    '슬라이더를 하나씩 움직이는 손은 세 쌍 가운데 두 쌍에서 진화를 이깁니다. 가장 좋은 {ky}가 그런 슬라이더의 끝인 0에 있기 때문입니다. 그러나 더 자주 갇혀서, 49번이 아니라 37번 목푯값에 이릅니다. 그 끝을 없애면 길을 잃습니다.',
  ],
};
