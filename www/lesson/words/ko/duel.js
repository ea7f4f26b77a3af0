// The step “duel” in Korean.
import { costText, fixed, grouped } from '../../../words/ko/numbers.js';

/** @typedef {import('../common.js').Verdict} Verdict */

/** @param {number} count */
const trialsText = (count) => `시도 ${grouped(count)}번`;

export const duel = {
  texts: {
    begin: `출발점 하나에서 주차하기는 쉬웠습니다. 이제는 같은 이득 세 개로 *출발점 32개*에서 주차해야 합니다. 출발점은 목표를 둘러싸고 있고 방향도 제각각입니다. {J}는 주행 32번의 평균이며, 회전의 비용에 곱하는 {Rw}는 {=turning}입니다({=before}).

먼저 손으로 찾아보십시오. 그림 아래의 슬라이더를 움직이거나 숫자를 입력합니다. 슬라이더를 놓을 때마다 로봇 32대가 달립니다. 얼마나 멀리 끌었든 이것이 *시도 한 번*입니다. 만족스러우면 *최고 기록을 확정*하십시오.

그다음은 진화의 차례입니다. 로봇 {=count}대로 {=generations}세대, 처음 {=count}번을 더해 {=given}번 시도하며, 직접 시도한 횟수가 더 많으면 그만큼 시도합니다. 셋째 선수인 *무작위 탐색*도 같은 횟수를 씁니다. {=low}~{=high} 범위에서 이득을 균등하게 뽑아 가장 좋은 것을 남길 뿐, 아무것도 배우지 않습니다.`,
    beyond: `진화의 로봇들이 달리는 모습을 지켜보고, 그림 위에 적힌 이득을 보십시오. {ky}는 슬라이더의 끝을 넘어, 손으로는 좀처럼 찾지 않을 곳이자 무작위 탐색은 갈 수 없는 곳에 있습니다. 그곳을 찾으라고 알려 준 사람은 없습니다.`,
    within: `진화의 로봇들이 달리는 모습을 지켜보고, 그림 위에 적힌 이득을 보십시오. 이번에는 {ky}가 손으로도 닿을 수 있는 곳에 있습니다.`,
    after: `*선택은 좋았던 곳에서 이어집니다.* 각 세대는 앞 세대가 끝난 곳에서 시작합니다. 그래도 {=generations}세대 안에 얼마나 찾는지는 운에 달려 있습니다. 누가 이겼는지 말하기 전에 다른 시드로도 겨루고, 진화와 무작위 탐색을 더 진행해 보십시오.`,
    next: `어떤 탐색은 왜 쉽고 어떤 탐색은 왜 어려울까요? 탐색이 지나는 곳, 곧 이득 위에 펼쳐진 J의 지형에 달려 있습니다.`,
  },
  duel: {
    /** @param {number} now @param {number} before */
    before: (now, before) => (now === before ? '앞 단계와 같음' : `앞 단계에서는 ${before}`),
    drivesLabel: '나의 시도',
    drivesName: '나의 시도 횟수',
    bestName: '나의 최소 평균 J',
    /** @param {number} drives @returns {string} */
    enough: (drives) =>
      drives === 0 ? '슬라이더를 움직이면 로봇 32대가 달립니다.' : '계속하거나, 최고 기록을 확정하십시오.',
    none: '아직 없음',
    lock: '최고 기록 확정',
    /** @param {boolean} predicted @returns {string} */
    locked: (predicted) =>
      predicted
        ? '확정했습니다. 더 몰아 보아도 되지만 기록에는 들어가지 않습니다.'
        : '확정했습니다. 아래에서 예측하면 진화가 시작됩니다. 더 몰아 보아도 되지만 기록에는 들어가지 않습니다.',
    elsewhere:
      '지금 보이는 것과 다른 목표나 설정에서 확정한 기록입니다. 여기서 겨루려면 처음부터 다시 시작하십시오.',
    startOver: '처음부터 다시',
    resultLabel: '셋의 비교',
    names: { you: '나', evolution: '진화', random: '무작위 탐색' },
    heads: ['선수', '시도', '주차', '평균 J'],
    drivesAxis: '시도',
    costSymbol: 'J',
    /** @param {Verdict} verdict */
    caption: ({ seed, generation, given }) =>
      `시드 ${seed}. 승부는 진화의 ${generation}세대, ${trialsText(given)}에서 가립니다.`,
    sentence: who,
    later,
    /** @param {string} sentence */
    plotLabel: (sentence) => `시도 횟수에 따른 셋의 최소 평균 J. ${sentence}`,
    /** @param {number} drives @returns {string} */
    goOn: (drives) => `둘을 ${trialsText(drives)}까지 진행`,
    /** @param {Verdict} verdict */
    backTo: ({ given }) => `${trialsText(given)}으로 돌아가기`,
    anotherSeed: '다른 시드로 다시',
    watch: { evolution: '진화의 로봇 보기', you: '나의 로봇 보기' },
    /** @param {number} rounds @param {Record<'you' | 'evolution' | 'random' | 'both', number>} score */
    score: (rounds, { you, evolution, random, both }) =>
      rounds === 1
        ? '시드 하나는 주사위를 한 번 던진 것입니다.'
        : `시드 ${rounds}개 중 나 ${you}승, 진화 ${evolution}승, 무작위 탐색 ${random}승${both > 0 ? `, 진화와 무작위 탐색 공동 ${both}승` : ''}.`,
  },
  quizzes: {
    ahead: {
      question:
        '지금까지 시도한 횟수: {=drives}. 최소 평균 J: {=best}. 마지막에 누구의 평균 {J}가 가장 낮겠습니까? (예측하면 최고 기록이 확정됩니다.)',
      choices: ['나', '진화', '무작위 탐색', '진화와 무작위 탐색이 같은 J로'],
      first: '먼저 슬라이더를 움직여 보십시오. 한 번이라도 시도해야 예측할 수 있습니다.',
      /** @param {Verdict} verdict */
      why: ({ costs, drives, given, generation, seed }) => {
        const you = `나: ${trialsText(drives)}에 ${costText(costs.you)}.`;
        return `${you} 진화: ${generation}세대, ${trialsText(given)}에 ${costText(costs.evolution)}. 무작위 탐색: 같은 횟수에 ${costText(costs.random)}. 시드 ${seed}.`;
      },
    },
  },
  tries: {
    luck: '쉬운 문제로 시드 백 개(“운” 화면): 무작위 탐색은 얼마나 자주 앞서 있는가?',
    dear: '같은 대결, 회전의 비용을 주행과 같게: {Rw} = 1',
    sharp: '슬라이더 안에서 거의 가장 좋은 12, 12, 6에서 시작',
  },
  notice: [
    '사람은 로봇을 보고 생각합니다. 진화는 로봇을 모릅니다. 진화가 보는 것은 J뿐입니다.',
    '진화는 초기 이득을 뽑는 범위를 벗어날 수 있습니다. 이 무작위 탐색은 그럴 수 없습니다.',
    '사람은 몇 번, 진화는 수백 번 시도합니다. 진화는 생각하지 않는 대신 지치지 않습니다.',
  ],
};

/** @param {Verdict} verdict */
function who({ winner, costs }) {
  const { you, evolution, random } = costs;
  const by = (/** @type {number} */ less, /** @type {number} */ more) => fixed(more - less, 3);
  const rivals = Math.min(evolution, random);
  return {
    you: Number.isFinite(you) ? `내가 이겼습니다. J가 2위보다 ${by(you, rivals)} 낮습니다.` : '',
    evolution: `진화가 이겼습니다. J가 2위보다 ${by(evolution, Math.min(you, random))} 낮습니다.`,
    random: `무작위 탐색이 이겼습니다. J가 2위보다 ${by(random, Math.min(you, evolution))} 낮습니다.`,
    both: '진화와 무작위 탐색이 같은 J로 이겼습니다.',
  }[winner];
}

/** @param {Verdict} verdict */
function later({ costs, longest, later: { evolution, random }, passed }) {
  const ends = `${trialsText(longest)} 뒤 진화는 ${costText(evolution)}, 무작위 탐색은 ${costText(random)}입니다.`;
  if (!Number.isFinite(costs.you)) return ends;
  return `${ends} ${passed === null ? `진화는 아직 나의 ${costText(costs.you)}보다 낮아지지 못했습니다.` : `진화는 ${trialsText(passed)}째부터 나의 ${costText(costs.you)}보다 낮았습니다.`}`;
}
