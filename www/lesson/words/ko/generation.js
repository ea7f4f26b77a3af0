// The step “generation” in Korean.
import { costText } from '../../../words/ko/numbers.js';

/** @typedef {{ stays: boolean, cost: number, wins: number, place: number }} Fate */

export const generation = {
  newborn: {
    /** @param {number} better @param {number} count */
    title: (better, count) =>
      `자손 로봇 ${count}대의 주행(옅은 선: 부모). 아래: J. 초록색, 굵은 J: 부모보다 나은 로봇 ${better}대.`,
    /** @param {number} count */
    alone: (count) => `자손 로봇 ${count}대의 주행. 아래: J.`,
    /** @param {number} count */
    parents: (count) => `부모 로봇 ${count}대의 주행. 아래: J.`,
    /** @param {number} number @param {boolean} _isParent */
    name: (number, _isParent) => String(number),
  },
  texts: {
    begin: `지금까지는 로봇의 세 숫자인 이득을 한 벌씩 시험했습니다. *진화 프로그래밍(EP)*은 {=count}벌, 곧 로봇 {=count}대를 한꺼번에 다룹니다. 이 로봇들을 *개체군*, 하나하나를 *개체*라고 합니다. 처음의 로봇들이 *0세대*입니다. 이득은 각각 {=low}~{=high} 범위에서 무작위로 뽑고, 로봇마다 한 번씩 주행하여 비용 {J}로 *평가*를 받습니다(낮을수록 좋음). (로봇을 비교하는 데 쓰는 수를 *적합도*라고 합니다. 여기서는 {J}가 적합도이므로, {J}가 가장 낮은 로봇이 가장 적합합니다. 무작위는 모두 *시드*라는 수 하나에서 나옵니다. 시드가 같으면 모든 일이 똑같이 되풀이되고, 시드가 다르면 운도 다릅니다.) 그다음에는 네 단계를 되풀이하며, 한 번 되풀이할 때마다 다음 *세대*가 만들어집니다. 글 속의 수치는 그림에서 고른 로봇의 것입니다. 다른 로봇을 골라도 됩니다.`,
    mutate: `*1. [돌연변이](generation&generation=1&phase=mutation&individual=26).* 부모마다 *자손*을 하나씩 만듭니다. 자손의 이득은 각각 부모의 이득에서 무작위로 한 걸음 옮긴 값입니다. 한 걸음은 부모의 *변이 폭*(*전략 매개변수*) {s}에 난수 {N}을 곱한 것입니다. {N}은 표준정규분포(종 모양)에서 뽑으며, −2와 2 사이를 벗어나는 일이 드뭅니다. (그림에는 새 변이 폭도 나오며, 이는 8단계에서 다룹니다.)`,
    drive: `*2. [주행](generation&generation=1&phase=drive&individual=26).* 자손이 모두 달립니다(그림 위). {=child}의 J는 {=childCost}, 그 부모의 J는 {=parentCost}입니다. 자손 로봇 {=count}대 가운데 부모보다 잘 주행하는 것은 {=better}대입니다. 자손은 대개 부모보다 못합니다. 무작위 걸음은 좋을 때보다 나쁠 때가 많기 때문입니다.`,
    rule: `*3. 토너먼트.* 부모와 자손을 합친 로봇 {=all}대가 각각 무작위로 *복원 추출*한 로봇 {=bouts}대와 겨룹니다. 같은 상대를 두 번 만날 수 있지만 자기 자신과는 만나지 않습니다. 자기 J가 상대의 J보다 높지 않으면 이깁니다.

*4. 생존.* 승수가 많은 로봇 {=count}대가 이득과 변이 폭과 J를 그대로 지닌 채 다음 세대의 부모가 됩니다. 토너먼트와 생존을 합쳐 *선택*이라고 합니다. 누르기 전에 먼저 문제를 하나 풀어 봅시다.`,
    select: `*3. [토너먼트](generation&generation=1&phase=tournament&individual=26).* {=chosen}의 성적은 {=bouts}전 {=wins}승입니다. 그림의 *기대*는 {J}가 그만한 로봇이 평균하여 거두는 승수이고, 나머지는 운입니다. *순위*는 승수가 많은 순서입니다. *4. [생존](generation&generation=1&phase=survivors&individual=26).* {=fate} 네 단계를 차례로 눌러 보고, 다른 로봇도 골라 보십시오.`,
    next: `이 네 단계가 논문의 EP입니다. 1960년대에 L.\u00a0J.\u00a0Fogel이 생각해 냈고, 수를 다루며 토너먼트를 하는 이 형태는 1990년 무렵 D.\u00a0B.\u00a0Fogel이, 8단계의 변이 폭 규칙은 Schwefel이 만들었습니다. 교차는 없으며, 자손의 부모는 하나뿐입니다. 로봇이 스무 대라는 것과, 상대를 복원 추출한다는 것과, 승수가 같으면 J가 낮은 쪽이 앞선다는 것은 이 페이지가 정했습니다. 언제 멈출지도 정하기 나름입니다. 원하는 만큼 세대를 거친 다음 가장 좋은 로봇을 고릅니다. 그런데 한 걸음은 얼마나 커야 할까요? 모든 로봇이 {s} = 1로 시작하고, 그 뒤로는 아무도 정해 주지 않습니다.`,
  },
  /** @param {string} name @param {string} fate */
  fate: (name, fate) => `${name}: ${fate}.`,
  quizzes: {
    luck: {
      question: '1세대에서 자손 11은 자손 9보다 잘 주행합니다. 둘 가운데 누가 남습니까?',
      choices: ['자손 11만', '자손 9만', '둘 다', '둘 다 탈락'],
      /** @param {{ better: Fate, worse: Fate, bouts: number }} outcome */
      why: ({ better, worse, bouts }) =>
        `자손 11의 J는 ${costText(better.cost)}, 성적은 ${bouts}전 ${better.wins}승으로 ${fateOf(better)}입니다. 자손 9의 J는 ${costText(worse.cost)}, 성적은 ${worse.wins}승으로 ${fateOf(worse)}입니다. J로는 ${better.place}위와 ${worse.place}위입니다. 그러나 생존은 승수로 정하고, 승수는 누구를 만나느냐에 달려 있습니다.`,
    },
    best: {
      question: '그렇다면 가장 좋은 로봇은 어떻습니까? 세대가 바뀌면서 최소 J가 나빠질 수 있습니까?',
      choices: ['그렇다, 토너먼트에서 운이 나쁘면', '그렇다, 자손이 더 나쁘게 주행하면', '아니다, 절대로'],
      /** @param {{ rose: number, fell: number, generations: number }} outcome */
      why: ({ rose, fell, generations }) =>
        `*적합도 곡선*은 세대마다 최소 J를 보여 줍니다. 이 ${generations}세대 동안 최소 J는 ${fell}번 내려가고 ${rose === 0 ? '한 번도 올라가지 않았습니다' : `${rose}번 올라갔습니다`}. 최우수 로봇보다 J가 낮은 로봇은 없으므로, 최우수 로봇은 누구를 만나도 이기고, 승수가 같은 로봇 가운데서는 J가 낮은 쪽이 앞섭니다. 자손에게 자리를 내주지도 않습니다. 부모와 자손은 같은 토너먼트에 나갑니다. 이렇게 가장 좋은 것이 언제나 살아남는 것을 *엘리트주의(elitism)*라고 합니다.`,
    },
  },
  tries: {
    lucky: '시드 3: 부모 13은 J가 높은데도 남는다. 누구를 만났는가?',
    below: '자손 15는 한 걸음 너무 멀리 갔다: J는 무엇에 벌점을 매기는가?',
    bouts: '10전 대신 각각 200전: 그래도 운이 남는가?',
    late: '60세대: 이제 부모보다 잘 주행하는 자손은 몇 대인가?',
  },
  notice: [
    '한 세대에 드는 주행은 40번이 아니라 20번입니다. 부모는 이미 주행했습니다.',
    '자손은 부모의 변이 폭으로 만들어집니다. 새 변이 폭도 받지만, 자기 자손을 만들 때에야 씁니다. 스스로 적응하는 *진화 전략(ES)*에서는 거꾸로, 변이 폭을 먼저 바꾸고 그 새 변이 폭으로 걸음을 옮깁니다.',
  ],
};

/** @param {Fate} fate */
const fateOf = ({ stays }) => (stays ? '생존' : '탈락');
