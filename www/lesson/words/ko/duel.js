// The step “duel” in Korean.
import { costText, fixed, grouped } from '../../../words/ko/numbers.js';

/** @typedef {import('../common.js').Verdict} Verdict */

export const duel = {
  texts: {
    begin: `로봇도, 출발점도, 목표도 같습니다. 먼저 손으로 좋은 이득을 찾으십시오. 슬라이더나 숫자를 한 번 바꿀 때마다 주행 한 번이고, J만 셈합니다. 만족스러우면 *최고 기록을 확정*하십시오.

그다음 진화가 같은 횟수만큼 주행합니다. 셋째 선수인 *무작위 탐색*도 그만큼 주행합니다. 무작위 탐색은 {=low}~{=high} 범위에서 이득을 균등하게 뽑아 가장 좋은 것을 남길 뿐, 아무것도 배우지 않습니다. 진화는 첫 로봇들에 주행 {=count}번, 그 뒤로 한 세대마다 {=count}번이 필요합니다. 그러니 너무 일찍 멈추지 마십시오.`,
    after: `주행이 적으면 운이 결정합니다. 진화는 무작위 탐색과 똑같은 로봇들로 시작하고, 처음 백 번쯤은 거의 낫지 않습니다. *진화의 힘은 계속 나아진다는 데 있습니다.* 좋았던 곳에서 이어 가기 때문입니다. 누가 이겼는지 말하기 전에 둘을 더 진행해 보고, 다른 시드로도 겨루어 보십시오.`,
    next: `그런데 어떤 출발점에서는 진화가 무작위로 뽑는 것보다 나을 것이 없습니다. 무엇이 문제를 쉽게도 어렵게도 만들까요? 진화가 걷는 땅, 곧 이득 위에 펼쳐진 J의 지형에 달려 있습니다.`,
  },
  duel: {
    drivesLabel: '나의 주행',
    drivesName: '나의 주행 횟수',
    bestName: '나의 최저 J',
    /** @param {number} drives @param {number} population */
    enough: (drives, population) => {
      const generation = Math.floor(drives / population) - 1;
      if (generation < 0) return `진화의 첫 로봇들에 주행 ${population}번이 필요합니다. 계속하십시오.`;
      return generation === 0
        ? `진화의 첫 로봇들에 충분합니다. 이들은 무작위입니다. ${population}번 더 주행하면 한 세대가 됩니다.`
        : `진화가 ${generation}세대에 이르기에 충분합니다. ${population}번 더 주행하면 한 세대가 늘어납니다.`;
    },
    lock: '최고 기록 확정',
    locked: '확정했습니다. 더 몰아 보아도 되지만 셈하지 않습니다.',
    elsewhere:
      '지금 보이는 것과 다른 출발, 목표, 설정에서 확정한 기록입니다. 여기서 겨루려면 처음부터 다시 시작하십시오.',
    startOver: '처음부터 다시',
    resultLabel: '셋의 비교',
    names: { you: '나', evolution: '진화', random: '무작위 탐색' },
    heads: ['누구', '주행', '최저 J'],
    drivesAxis: '주행',
    costSymbol: 'J',
    cost: costText,
    /** @param {Verdict} verdict */
    caption: ({ seed, generation, drives, given }) =>
      `시드 ${seed}. 진화는 ${given <= drives ? `주행 ${grouped(drives)}번에 들어가는 마지막 세대인 ` : ''}${generation}세대.`,
    /** @param {Verdict} verdict */
    sentence: (verdict) => [who(verdict), caution(verdict)].filter(Boolean).join(' '),
    later,
    /** @param {string} sentence */
    plotLabel: (sentence) => `주행 횟수에 따른 셋의 최저 J. ${sentence}`,
    /** @param {number} drives */
    goOn: (drives) => `둘을 ${grouped(drives)}번까지 진행`,
    /** @param {number} drives */
    backTo: (drives) => `내 주행 ${grouped(drives)}번으로 돌아가기`,
    anotherSeed: '다른 시드로 다시',
    /** @param {Verdict} verdict */
    watch: ({ generation }) => `${generation}세대 최우수 로봇 보기`,
    /** @param {number} rounds @param {Record<'you' | 'evolution' | 'random' | 'both', number>} score */
    score: (rounds, { you, evolution, random, both }) =>
      rounds === 1
        ? '시드 하나는 주사위를 한 번 던진 것입니다.'
        : `시드 ${rounds}개 중 나 ${you}승, 진화 ${evolution}승, 무작위 탐색 ${random}승${both > 0 ? `, 둘이 함께 ${both}승` : ''}.`,
  },
  quizzes: {
    ahead: {
      question:
        '지금까지 {=drives}번 주행했고 최저 J는 {=best}입니다. 모두 같은 횟수를 주행하면 누구의 J가 가장 낮겠습니까? (예측하면 최고 기록이 확정됩니다.)',
      choices: ['나', '진화', '무작위 탐색', '진화와 무작위 탐색이 같은 J로'],
      /** @param {Verdict} verdict */
      why: (verdict) => {
        const { costs, drives, given, generation, seed } = verdict;
        const you =
          drives === 0
            ? '아직 주행하지 않았습니다.'
            : `나: 주행 ${grouped(drives)}번에 J ${costText(costs.you)}.`;
        return `${you} 진화: ${generation}세대, 주행 ${grouped(given)}번에 J ${costText(costs.evolution)}. 무작위 탐색: 같은 횟수에 J ${costText(costs.random)}. 시드 ${seed}. ${caution(verdict)}`;
      },
    },
  },
  tries: {
    luck: '운 화면에서 시드 백 개: 무작위 탐색은 얼마나 자주 앞서 있는가?',
    backwards: '목표를 등지고 출발: 또 다른 대결',
    round: '목표 위에서 반대 방향을 보고 출발: 또 다른 대결',
  },
  notice: [
    '사람은 로봇을 보고 생각합니다. 진화는 로봇을 모릅니다. 진화가 보는 것은 J뿐입니다.',
    '진화는 처음 이득을 뽑는 범위를 벗어날 수 있습니다. 이 무작위 탐색은 그럴 수 없습니다.',
  ],
};

/** @param {Verdict} verdict */
function who({ winner, costs }) {
  const { you, evolution, random } = costs;
  const by = (/** @type {number} */ less, /** @type {number} */ more) => fixed(more - less, 3);
  return {
    you: `내가 이겼습니다. 2위보다 ${by(you, Math.min(evolution, random))} 낮습니다.`,
    evolution: `진화가 이겼습니다. 2위보다 ${by(evolution, Math.min(you, random))} 낮습니다.`,
    random: `무작위 탐색이 이겼습니다. 2위보다 ${by(random, Math.min(you, evolution))} 낮습니다.`,
    both: '진화와 무작위 탐색이 같은 J로 이겼습니다.',
  }[winner];
}

/** What makes it less than a fair contest. @param {Verdict} verdict */
function caution({ drives, population, generation }) {
  if (drives < population)
    return `다만 이보다 적으면 진화를 시작할 수 없어 둘은 ${population}번씩 주행했고, 나는 ${drives}번 주행했습니다.`;
  return generation === 0 ? '아직 아무것도 진화하지 않았습니다. 둘 다 첫 로봇들뿐입니다.' : '';
}

/** @param {Verdict} verdict */
function later({ costs, longest, later: { evolution, random }, passed }) {
  const ends = `주행 ${grouped(longest)}번 뒤 진화의 J는 ${costText(evolution)}, 무작위 탐색의 J는 ${costText(random)}입니다.`;
  return `${ends} ${passed === null ? `진화는 나의 ${costText(costs.you)}보다 낮아지지 못했습니다.` : `진화는 주행 ${grouped(passed)}번 만에 나의 ${costText(costs.you)}보다 낮아졌습니다.`}`;
}
