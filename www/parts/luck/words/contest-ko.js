// Every word of the contest, in Korean.
/** @import { Factor, Lowest, Verdict } from '../contest-summary.js' */
/** @import { Contestant } from '../contestants.js' */
import { leastRuns } from '../contest-numbers.js';
import { costText, grouped, wasText } from '../../../words/ko/numbers.js';
import { probability, targetText, timesText, wholePercent } from './common.js';

/** @param {number} part */
export const percent = (part) => `${wholePercent(part)}%`;
/** @param {Factor} factor */
const timesBetween = ({ times, between: [low, high] }) =>
  `${timesText(times)}배(${timesText(low)}~${timesText(high)}배)`;

export const viewLegend = '무엇을 알아볼지';
/** @type {import('../../../kit/segmented.js').Choices<'seeds' | 'contest'>} */
export const views = {
  seeds: { text: '시드', hint: '한 가지 탐색을 여러 시드로' },
  contest: { text: '겨루기', hint: '여러 탐색을 같은 시드와 같은 주행 횟수로 나란히' },
};

export const contestTexts = {
  title: '겨루기',
  csv: 'CSV',
  picture: '겨루기',
  seeds: '시드 수',
  budget: '주행 횟수(각각)',
  progress: '끝난 실행',
  nobody: '–',
  ingredients: '구성 요소 하나 바꾸기',
  rivals: '경쟁 방법',
  target: '목푯값 J',
  until: '읽는 시점의 주행 횟수',
  reading: '어떤 그림',
  fewer: '시드를 더 적게 썼다면',
  otherSeeds: '다른 시드로',
  usualTarget: '기본 목푯값으로',
  caption: '주행 횟수로 본 결과: 누가 언제 목푯값에 이르는가',
};

/** @type {import('../../../kit/segmented.js').Choices<import('../state.js').LuckState['reading']>} */
export const readings = {
  course: { text: '주행에 따른 J', hint: '주행 횟수에 따른 최소 J와 목푯값에 이른 비율' },
  targets: {
    text: '목푯값 51개',
    hint: '최소 J보다 10% 높은 값부터 0.1% 높은 값까지 목푯값 51개 가운데 이른 비율',
  },
  ends: { text: '마지막 J', hint: '실행마다 끝난 곳, 시드 하나에 점 하나' },
  table: { text: '표', hint: '누가 언제 목푯값에 이르는가' },
};

export const asInLab = '실험실 그대로';
/** @type {Readonly<Record<Contestant, string>>} */
const names = {
  cauchy: '코시 돌연변이',
  fixed: 'σ 고정(적응 없음)',
  'floor-0.01': 'σ 하한 0.01',
  'floor-0.1': 'σ 하한 0.1',
  truncation: '토너먼트 없음: 가장 낮은 J가 생존',
  parent: '자손 대 부모',
  crossover: '교차 0.5',
  'n-6': 'N = 6',
  'n-100': 'N = 100',
  mirror: '0에서 뒤집기',
  random: '무작위 탐색',
  de: 'DE(차분 진화)',
  'cma-es': 'CMA-ES',
  'cma-es-7': 'CMA-ES, 세대마다 7번',
  'cma-es-7-mirror': 'CMA-ES, 세대마다 7번, 0에서 뒤집기',
  'one-plus-one-es': '(1+1)-ES',
  'nelder-mead': '넬더–미드',
  'one-at-a-time': '이득을 하나씩',
  hand: '손으로 하듯 하나씩, 0에서 멈춤',
  'finite-differences': '유한 차분',
};
/** At a line, where there is little room. @type {Readonly<Partial<Record<Contestant, string>>>} */
const shortNames = {
  fixed: 'σ 고정',
  truncation: '토너먼트 없음',
  hand: '손으로 하듯',
  random: '무작위',
  de: 'DE',
  'cma-es-7': 'CMA-ES(7번)',
  'cma-es-7-mirror': 'CMA-ES(뒤집기)',
};

/** @param {Contestant | null} name */
export const contestantName = (name) => (name ? names[name] : asInLab);
/** @param {Contestant | null} name */
export const shortName = (name) => (name ? (shortNames[name] ?? names[name]) : asInLab);

/** @param {number} place */
export const contestantLabel = (place) => `참가자 ${place}`;
/** @param {number} count @param {number} seeds */
export const contestRunText = (count, seeds) => `${count} × 시드 ${seeds}개 실행`;
/** @param {number} drives */
export const drivesChoice = (drives) => `주행 ${grouped(drives)}회`;
/** How the contest counts a drive from many starts. @param {number} starts */
export const asOne = (starts) => (starts > 1 ? `(출발점 ${starts}개를 한 번으로 셈)` : '');
export const wholeNumber = grouped;
/** @param {number} low @param {number} high */
export const intervalText = (low, high) => `${grouped(low)}~${Number.isFinite(high) ? grouped(high) : '∞'}`;

/** @param {number} done @param {number} all */
export const contestProgress = (done, all) => `실행 ${all}회 중 ${done}회`;
/** @param {number} drives */
export const tooLong = (drives) =>
  `주행이 ${grouped(drives)}회나 되어 너무 오래 걸립니다. 시드, 주행 횟수, 출발점, 참가자 가운데 하나를 줄이십시오.`;
/** @param {number} budget @param {number} most */
export const runTooLong = (budget, most) =>
  `여기서는 주행 ${grouped(budget)}회짜리 실행 하나도 너무 오래 걸립니다. 많아도 ${grouped(most)}회까지입니다. 주행 횟수나 출발점이나 제한 시간을 줄이거나, 샘플링 주기를 늘리십시오.`;
/** @param {number} done @param {number} all */
export const contestCancelled = (done, all) =>
  `실행 ${all}회 중 ${done}회를 마치고 취소했습니다. 그때까지의 결과를 보여 줍니다.`;
export const otherContest = '지금 고른 것이 아니라 이전 겨루기의 결과입니다. 고른 대로 다시 실행하십시오.';
/** @param {{ seeds: number, budget: number }} asked @param {number} starts */
export const contestInvitation = ({ seeds, budget }, starts) =>
  `어느 부분이 효과를 낼까요? 참가자마다 같은 시드 ${seeds}개로 ${grouped(budget)}회씩${asOne(starts)} 주행합니다. 세대가 아니라 주행 횟수로 비교해 보십시오.`;

/** @param {Lowest} lowest */
export const usualTargetText = ({ cost, name, seed }) =>
  `최소 J ${targetText(cost)}보다 0.2% 높은 값(${shortName(name)}, 시드 ${seed})`;
/** @param {string} was */
export const targetRefused = (was) => `목푯값은 수여야 합니다. ${wasText(was)}`;

export const drivesAxis = '주행 횟수';
/** What comes where no contest has run. */
export const emptyCosts = '참가자마다 J의 중앙값';
export const shareAxis = '목푯값에 이른 비율';
export const targetsAxis = '목푯값 51개 가운데 이른 비율';
/** @param {number} drives */
export const untilText = (drives) => `주행 ${grouped(drives)}회까지 읽음, 끝까지 보기`;
/** @param {number} count @param {number} seeds */
export const seedsText = (count, seeds) => `시드 ${seeds}개 가운데 ${count}개`;
/** @param {number} told @param {number} count */
export const toldText = (told, count) =>
  `시드 ${count}개를 100번 뽑을 때 차이를 알 수 있는 것은 ${told}번입니다.`;
/** @param {number} target */
export const targetLine = (target) => `목푯값 ${targetText(target)}`;

export const contestColumns = [
  { text: '도달', hint: '목푯값에 이른 실행의 수. 첫 참가자와의 비교는 피셔의 정확 검정' },
  {
    text: 'ERT',
    hint: `기대 실행 시간: 모든 실행이 목푯값이나 한도까지 쓴 주행 횟수를 목푯값에 이른 실행의 수로 나눈 값. 실행이 ${leastRuns}번 이상이면 옆에 95% 신뢰구간(부트스트랩). 배수 뒤의 괄호는 그 배수의 신뢰구간`,
  },
  { text: 'J 중앙값', hint: '주행 한도에서 J의 중앙값' },
  {
    text: 'A12',
    hint: '이 참가자의 실행이 첫 참가자의 실행보다 나을 확률: 목푯값에 더 일찍 이르거나, 둘 다 이르지 못했다면 J가 더 낮은 쪽',
  },
  {
    text: 'p',
    hint: 'A12와 같은 우열 기준으로 계산한 만–휘트니 양측 검정, 줄 수에 대한 홀름 보정. 같은 시드를 쓴다는 것을 고려하지 않으므로, 일찍 이르는 목푯값에서는 보수적인 값',
  },
];
/** The columns in a line; their hints have it in full. */
export const columnsText =
  'ERT: 성공 하나당 주행 횟수. A12: 이긴 쌍의 비율. p: 둘이 같아도 이만큼 이상 다를 확률.';
/** @param {number} reached @param {number} count */
export const reachedText = (reached, count) => `${reached}/${count}`;

/** More than half of them. @param {number} part */
const ofPairs = (part) => (part < 1 && part >= 0.995 ? '99%가 넘는 쌍' : `${percent(part)}의 쌍`);

/** @param {Verdict} verdict @param {Contestant | null} name */
export function verdictText(verdict, name) {
  const who = shortName(name);
  switch (verdict.kind) {
    case 'same':
      return `모든 실행이 첫 참가자와 똑같습니다. 이 주행 횟수 안에서는 이것을 바꾸어도 달라지는 것이 없습니다.${verdict.isBefore ? ' (처음의 무작위 로봇만 주행하는 동안에는 어떤 방법도 다르지 않습니다.)' : ''}`;
    case 'undecided':
      return `${verdict.runs}번의 실행으로는 둘의 차이를 알 수 없습니다${verdict.alone === null ? '' : `(비교 ${1 + verdict.others}개에 대한 보정 없이 이것만 비교했다면 p는 ${probability(verdict.alone)})`}.`;
    case 'sooner':
      return `${who}: 목푯값에 ${timesBetween(verdict)} 빨리 이릅니다.`;
    case 'later':
      return `${who}: 목푯값에 이르는 데 주행이 ${timesBetween(verdict)} 필요합니다.`;
    case 'mostly':
      return `${who}: 실행 ${verdict.runs}번 중 ${verdict.reached}번 목푯값에 이르지만, 첫 참가자는 ${verdict.first}번만 이릅니다.`;
    case 'hardly':
      return `${who}: 실행 ${verdict.runs}번 중 ${verdict.reached}번만 목푯값에 이르고, 첫 참가자는 ${verdict.first}번 이릅니다.`;
    case 'only-this':
      return `${who}: 실행 ${verdict.runs}번 중 ${verdict.reached}번 목푯값에 이르지만, 첫 참가자는 한 번도 이르지 못합니다.`;
    case 'only-first':
      return `${who}: 목푯값에 한 번도 이르지 못합니다. 첫 참가자는 실행 ${verdict.runs}번 중 ${verdict.reached}번 이릅니다.`;
    case 'surer':
      return `${who}: 두 실행을 짝지으면 ${ofPairs(1 - verdict.a12)}에서 뒤지지만 ${verdict.factor ? `실패가 적어서, 평균으로는 목푯값에 ${timesBetween(verdict.factor)} 빨리 이릅니다` : '실패가 적습니다'}.`;
    case 'riskier':
      return `${who}: 두 실행을 짝지으면 ${ofPairs(verdict.a12)}에서 앞서지만 ${verdict.factor ? `실패가 많아서, 평균으로는 주행이 ${timesBetween(verdict.factor)} 필요합니다` : '실패가 많습니다'}.`;
    default:
      return `${who}: 두 실행을 짝지으면 ${ofPairs(verdict.kind === 'better' ? verdict.a12 : 1 - verdict.a12)}에서 ${verdict.kind === 'better' ? '더 낫습니다' : '더 못합니다'}.`;
  }
}

/** @param {readonly string[]} sentences */
export const contestLabel = (sentences) =>
  `주행 횟수에 따른 최소 J와 목푯값에 이른 실행의 비율. ${sentences.join(' ')}`;
/** @param {number} cost */
export const medianText = (cost) => (Number.isFinite(cost) ? targetText(cost) : costText(cost));
