// The step “task” in Korean.
import { shareText } from '../../../parts/robustness/words/common.js';
import { costText, fixed, grouped } from '../../../words/ko/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */
/** @typedef {import('../common.js').Share} Share */
/** How gains fare: from how many starts they arrive. @typedef {{ gains: readonly number[], training: Fares, unseen: Fares, own: number }} Result */
/** @typedef {{ starts: readonly unknown[], arrived: Uint8Array, count: number, cost: number }} Fares */

export const task = {
  texts: {
    good: `7, 8, 10단계의 로봇은 출발점 *하나*로 진화했습니다. {=generation}세대의 최우수 로봇은 {=time}초 뒤 도착하고 J는 {=cost}입니다. 논문의 이득으로는 여기서 {=paper}입니다. 더 나아질 여지가 거의 없습니다. *그렇다면 이 로봇은 주차를 배운 것일까요?*

시험해 봅시다. 이득은 그대로 두고 출발점만 바꿉니다. 목표를 둘러싼 한 변 {=side} m의 정사각형에서 {=places}곳, 한 곳마다 방향각 {=headings}개, 모두 {=starts}개의 출발점입니다.`,
    beside: `실패하는 로봇을 여기서 보십시오. [지도](robustness&generation=100)에서 빗금 친 곳을 눌러도 됩니다. 로봇은 다가와서 방향을 맞추고 멈춥니다. 그런데 목표의 *옆*입니다. {xe}와 {te}는 없어지고 {ye}가 남습니다. {ye}를 줄이는 이득은 {ky}인데, 진화는 이것을 {=ky}까지 줄여 놓았습니다.`,
    asked: `왜 이렇게 작을까요? 진화가 받은 단 하나의 출발점은 목표의 정확히 뒤쪽, 곧 목표 화살표의 연장선 위에 있습니다. 거기서 {ye}는 {=ye} m입니다. 이 주행에서 {ky}는 할 일이 거의 없고 비용만 듭니다. 그래서 진화가 없앴습니다. 진화가 실수한 것이 아닙니다. 우리가 요구한 것은 주행 *하나*였고, 진화는 그 주행의 비용을 낮추었습니다. 요구받은 것에만 꼭 맞아 다른 곳에서 실패하는 것을 *과적합(overfitting)*, 요구받지 않은 곳에서도 잘하는 것을 *일반화(generalisation)*라고 합니다.

*최적화는 우리의 뜻이 아니라 비용을 따릅니다.*`,
    many: `그러니 더 많은 것을 요구해 봅시다. {J}를 *여러 출발점의 평균*으로 바꾸어 다시 진화시킵니다. [학습](training&generation=100)에서는 출발점 하나로, 원 위의 32개로, 격자의 36개로 세 번 진화시킨 다음, 셋 모두 한 번도 보지 못한 출발점 1,000개로 시험합니다. 이 출발점들은 위의 정사각형과 달리 목표를 둘러싼 원 안에 있습니다. 예측하면 진화가 시작됩니다.`,
    half: `나아졌지만 처음 보는 출발점 모두에서 주차하기에는 아직 멉니다. 출발점만 늘려서는 해결되지 않으니, 비용이 *무엇을 요구하는지* 봅시다. 목표 옆에서 출발한 로봇은 돌아서, 달리고, 다시 돌아야 하며, 회전에는 에너지가 듭니다. 그런 출발점 하나만을 위해 찾은 이득은 그곳에서 주차하며, 기다릴 때보다 비용이 적습니다. 그러나 이득 *한 벌*로 32곳 모두에서 주차해야 하고, 그런 이득은 어디에서나 세게 회전합니다. 그래서 {Rw} = 1에서는 로봇 몇 대를 목표 옆에 세워 둔 채 시간을 보내게 하는 이득의 평균 비용이 더 낮습니다. (가만히 있는 편이 비용이 덜 들 수 있다는 것은 6단계에서 보았습니다.) 회전의 비용은 이 페이지가 정한 값입니다. 바로 여기 있습니다. *10분의 1로*, 곧 1 대신 0.1로 바꾸십시오.`,
    whole: `그림에서 아무 출발점이나 누르면 그 주행이 그려집니다. 로봇도, 법칙도, 출발점도, 진화도 그대로입니다. *요구한 것이 바뀌었습니다.* 9단계에서 겨룬 문제가 바로 이것입니다. 0.1과 1 사이에서는 어떨까요? 회전의 비용을 다르게 정하고 *“다시 진화”*를 눌러, 로봇이 언제부터 주차하지 못하는지 찾아보십시오.`,
    next: `로봇에만 해당하는 이야기가 아닙니다. 비용이 *요구하지 않는 것*을 살펴보십시오. 이 페이지의 비용은 바닥이 미는 경우를 한 번도 다루지 않았습니다.`,
  },
  quizzes: {
    share: {
      question: '이 출발점 가운데 몇 곳에서 도착합니까?',
      choices: ['거의 모든 곳에서', '약 4분의 3에서', '약 절반에서', '4분의 1이나 그 이하에서'],
      /** @param {Share} outcome */
      why: ({ count, starts, share }) =>
        `${grouped(starts)}개 중 ${grouped(count)}개, 곧 ${percent(share)}입니다. 이 단계를 열 때의 그림에 있는 것은 9단계에서 쓴 다른 출발점 32개입니다.`,
    },
    arbitrary: {
      question:
        '논문의 임의 이득 10, 10, 10은 논문의 출발점에서 비용이 더 큽니다. 얼마나 많은 출발점에서 도착합니까?',
      choices: ['더 적은 곳에서', '비슷한 만큼', '더 많은 곳에서'],
      /** @param {{ own: Share, other: Share, best: Run, dear: Run }} outcome */
      why: ({ own, other, best, dear }) =>
        `임의 이득은 출발점의 ${percent(other.share)}에서, 진화한 이득은 ${percent(own.share)}에서 도착합니다. 논문의 출발점에서 J는 임의 이득이 ${costText(dear.cost.total)}, 진화한 이득이 ${costText(best.cost.total)}입니다. 한 곳에서 가장 좋다고 다른 곳에서도 좋은 것은 아닙니다.`,
    },
    price: {
      question: '출발점 하나 대신 32개로 진화시키면, 논문의 그 출발점에서 {J}는 어떻게 됩니까?',
      choices: ['낮아진다', '그대로이다', '높아진다'],
      /** @param {{ one: Result, many: Result }} outcome */
      why: ({ one, many }) =>
        `J ${costText(one.own)} → ${costText(many.own)}. 그 대신 한 번도 보지 못한 출발점 ${grouped(many.unseen.starts.length)}개 가운데 도착하는 곳이 ${grouped(one.unseen.count)}개 → ${grouped(many.unseen.count)}개입니다. {ky}는 ${fixed(one.gains[1], 4)} → ${fixed(many.gains[1], 2)}입니다. 요구하니 되살아났습니다. 표에서 셋을 모두 볼 수 있습니다.`,
    },
    turning: {
      question:
        '회전의 비용을 10분의 1로 하고 같은 출발점 32개로 다시 진화시킵니다. 처음 보는 출발점 1,000개 가운데 몇 곳에서 주차합니까?',
      choices: ['더 적은 곳에서', '절반보다 조금 많은 곳에서', '거의 모든 곳에서'],
      /** @param {{ before: Result, after: Result }} outcome */
      why: ({ before, after }) =>
        `${grouped(after.unseen.starts.length)}개 가운데 ${grouped(before.unseen.count)}개 → ${grouped(after.unseen.count)}개입니다. 이득은 ${gainsText(before.gains)} → ${gainsText(after.gains)}입니다.`,
    },
  },
  tries: {
    beside: '실패하는 출발점: 어디에서 끝나는가',
    withKy: '같은 출발점, {ky} = 10',
    training: '세 가지 모두 진화: 출발점 1개, 32개, 36개, 시험은 다른 1,000개',
    cheap: '시드 3으로 다시 진화: 격자의 결과에 주목',
    both: '주행의 비용도 10분의 1로: {R} = 0.1, 0.1. 그래도 모두 주차하는가?',
  },
  notice: [
    '지도에는 축이 있습니다. 목표가 보는 방향입니다. 로봇은 뒤와 앞에서는 도착하지만, 옆에서는 거의 도착하지 못합니다.',
    '여러 출발점으로 진화시켜도 일부는 놓칩니다. {Rw} = 1이면 {J}는 도착이 아니라 비용이 낮은 주행을 요구하기 때문입니다. 시드 3에서 격자의 이득은 임의 이득보다 도착하는 곳이 적지만 평균 {J}는 훨씬 낮습니다.',
    '이득은 진화시킨 곳에서 가장 좋아 보입니다. “학습한 곳”과 “처음 보는 곳”을 비교해 보십시오.',
  ],
};

/** @param {number} share */
const percent = (share) => `${shareText(share)}%`;

/** @param {readonly number[]} gains */
const gainsText = (gains) => gains.map((gain) => fixed(gain, gain < 10 ? 2 : 0)).join(', ');
