// The step “sigma” in Korean.
import { costText, fixed } from '../../../words/ko/numbers.js';

/** @import { Ancestor } from '../../views/lineage.js' */
import { gainText, sigmaText } from '../../../parts/generation/words/common.js';

export const sigma = {
  lineage: {
    /** @param {number} generation @param {number} count @param {number} [first] Where the family begins: not at 0 if earlier ancestors are left out. */
    title: (generation, count, first = 0) =>
      generation === 0
        ? '0세대의 최우수 로봇: 부모가 없습니다.'
        : count === 1
          ? first > 0
            ? `${generation}세대의 최우수 로봇은 ${first}세대나 그 전에 태어났으며, 그 조상은 생략했습니다.`
            : `${generation}세대의 최우수 로봇은 처음에 뽑은 로봇 가운데 하나여서 부모가 없습니다.`
          : `${generation}세대의 최우수 로봇과 그 조상 로봇 ${count - 1}대: 물려받은 변이 폭${first > 0 ? `\u2060(${first}세대보다 앞선 조상은 생략)` : ''}`,
    axis: '세대',
    /** @param {number} first @param {number} last */
    sigma: (first, last) => `σ ${sigmaText(first)} → ${sigmaText(last)}`,
    /** @param {string} gain @param {readonly Ancestor[]} family @param {number} i */
    label: (gain, family, i) =>
      `${gain}와 σ: ${family.map(({ born, individual: { gains, sigmas } }) => `${born}세대 ${gainText(gains[i], sigmas[i])}, σ ${sigmaText(sigmas[i])}`).join('; ')}`,
    other: '이 탐색 방법에서는 변이 폭을 부모에게서 물려받지 않습니다.',
  },
  texts: {
    begin: `걸음이 너무 짧으면 나아가지 못하고, 너무 길면 지나칩니다. 처음에 알맞던 걸음도 끝에 가면 너무 깁니다. 그래서 *변이 폭(표준편차)* {s}는 아무도 정해 주지 않습니다. 로봇마다 이득 하나에 {s}를 하나씩 지니고, 거기에 무작위로 정해지는 값을 곱하여 자손에게 물려줍니다. 이를 *자기 적응(self-adaptation)*이라고 합니다.`,
    rates: `{N}은 셋에 공통인 난수여서, 한 자손의 걸음은 모두 함께 커지거나 작아집니다. {N2x}, {N2y}, {N2t}는 변이 폭을 하나씩 따로 바꿉니다. 이득을 옮긴 난수가 아니라 새로 뽑은 난수입니다. {tau2} = {=common}과 {tau} = {=own}은 논문의 값으로, 이득이 n = 3개일 때의 1/√(2n)과 1/√(2√n)입니다. 처음의 {s} = 1도 논문의 값입니다. 새 {s}는 70%의 확률로 이전 값의 절반과 두 배 사이에 있습니다. 곱하는 값은 정규 난수에 지수함수를 취한 것이므로 *로그정규(log-normal)* 분포를 따르고 언제나 0보다 큽니다.

{s} 자체는 아무도 평가하지 않습니다. 알맞은 걸음이 좋은 자손을 낳고, 그 자손이 {s}를 물려받을 뿐입니다. 다만 무작위로 바뀐 값이므로, 좋았던 것에 가깝지만 아직 시험받지 않은 {s}입니다. 그림은 가장 좋은 로봇의 가계입니다. 맨 위의 조상에서 아래로 이어지며, 종 모양 하나하나는 다음 자손의 이득이 놓이기 쉬운 자리를 보여 줍니다. 그래프는 이득마다 모든 로봇의 {s}의 평균을 보여 줍니다. 세로축은 로그 축입니다. {=generation}세대의 평균 {s}는 {kx}에서 {=sx}, {ky}에서 {=sy}, {kt}에서 {=st}입니다.`,
    collapse: `길게 보면 {s}는 작아집니다. 짧은 걸음은 크게 망칠 일이 없어, 그 자손이 더 자주 살아남아 짧은 걸음을 물려줍니다. 이를 막는 것이 없으므로 *변이 폭이 무너집니다*. 시드 1에서는 [300세대에 이르면](lab&generation=300&curve=sigmas) 백만분의 일보다 작아지고, 가장 좋은 자리를 찾았든 못 찾았든 진화는 제자리에 머뭅니다. 얼마나 빨리 무너지는지는 우연에 달려 있습니다. [시드 13에서는](lab&seed=13&generation=300&curve=sigmas) 그때에도 큰 걸음이 남아 있습니다. 흔한 처방은 {s}가 내려갈 수 없는 하한을 두는 것입니다. 논문에 하한이 없으므로 여기에도 없습니다. 하한은 [11단계](lesson&step=contest)에서 써 볼 수 있습니다. 진화 전략에서 흔히 쓰는 처방은 다릅니다. 부모를 하나도 남기지 않아, 한 번 운이 좋았던 로봇이 나쁜 변이 폭을 지닌 채 살아남지 못하게 합니다(*콤마 선택*). EP는 약점이 있는 방법입니다.`,
    next: `지금까지의 문제에서는 가장 좋은 이득이 처음에 뽑은 로봇들에서 멀지 않습니다. 멀면 어떨까요? 먼저 직접 해 보십시오.`,
  },
  quizzes: {
    small: {
      question:
        '모든 로봇이 {s} = 1이 아니라 {s} = 0.01로 시작하면 어떻습니까? 로봇도 시드도 같습니다. 60세대 뒤 최소 J는 어떻게 됩니까?',
      choices: [
        '더 낮다: 작은 걸음은 조심스럽다',
        '같다: {s}는 어차피 스스로 맞추어진다',
        '더 높다: 그런 걸음으로는 거의 벗어나지 못한다',
      ],
      /** @param {{ own: number, usual: number, generation: number, sigma: number, falls: boolean }} outcome */
      why: ({ own, usual, generation, sigma, falls }) =>
        `${generation}세대 뒤 최소 J는 ${costText(own)}이고, σ = 1로 시작하면 ${costText(usual)}입니다. 새 σ가 이전 값의 두 배를 넘는 것은 일곱 번에 한 번쯤${falls ? '입니다. 게다가 여기서는 σ가 커지기는커녕 작아집니다(곡선이 내려갑니다). 이렇게 짧은 걸음 가운데서는 가장 짧은 걸음이 가장 덜 망치므로 살아남습니다. 자세한 이야기는 이 단계의 끝에 나옵니다.' : `이어서, ${sigma}에서 커지려면 여러 세대가 걸립니다.`}`,
    },
    further: {
      question:
        '시드 1의 진화를 150세대에서 300세대까지 계속합니다. 지금까지 한 만큼 다시 주행하는 셈입니다. 최소 J는 얼마나 더 내려갑니까?',
      choices: ['지금까지와 비슷하게', '그보다 적지만 눈에 띄게', '0.01도 내려가지 않는다'],
      /** @param {{ before: number, after: number, half: number, generation: number, sigmas: string[] }} outcome */
      why: ({ before, after, half, generation, sigmas }) =>
        `처음 ${half}세대 동안 ${fixed(before, 3)}, 다음 ${generation - half}세대 동안 ${fixed(after, 5)}만큼 내려갔습니다. 마지막의 평균 σ는 ${sigmas.join(', ')}입니다.`,
    },
  },
  tries: {
    stuck: '시드 7의 300세대: {s}는 얼마나 큰가? 다른 시드에서는 J가 더 낮다',
    none: '걸음이 없다: {s} = 0. 토너먼트만 남는다',
    large: '지나치게 크다: {s} = 100',
    late: '300세대의 돌연변이: 이득이 바뀌는 것이 보이는가?',
  },
  notice: [
    '{s}가 두 배가 되는 일과 절반이 되는 일은 똑같이 잦은데도, 처음에는 곡선이 올라갑니다. 두 배가 될 때 평균에 더해지는 몫이 절반이 될 때 빠지는 몫보다 크기 때문입니다.',
    '시드 1에서는 {ky}의 변이 폭이 가장 먼저 줄어듭니다. 왜 {ky}인지는 10단계에서 볼 수 있습니다.',
  ],
};
