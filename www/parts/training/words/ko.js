// Every word of the training part, in Korean.
/** @import { Evolved, Result, RowName } from '../request.js' */
import { cost, isEvolved, shareOf } from './common.js';
import { fixed, grouped, postureText, tookText } from '../../../words/ko/numbers.js';

export * from './common.js';

export const texts = {
  trainingPicture: '학습 출발점',
  trainingTitle: '학습',
  trainingGenerations: '각 진화의 세대 수',
  trainingProgress: '세 가지 출발점 집합에 대한 진화',
  trainingTable: '진화가 본 출발점과 한 번도 보지 않은 출발점에서 각 로봇의 이득이 내는 성적',
};

export const evolveAll = '세 가지 모두 진화';
export const evolveAgain = '다시 진화';
/** @param {number} count */
export const seedsButton = (count) => `시드 ${count}개`;
/** @param {number} count */
export const seedsHint = (count) =>
  `다른 시드로 세 가지를 다시 진화시켜 시드 ${count}개를 하나씩 점으로 표시합니다`;
export const cancel = '취소';
/** @param {number} generations */
export const generationsChoice = (generations) => `${generations}세대`;

/** @param {number} part @param {number} count */
export const percent = (part, count) => `${shareOf(part, count)}%`;

/** @param {RowName} name @param {number} count The number of starts that it was evolved on. */
export const rowName = (name, count) =>
  ({
    one: `출발점 ${count}개`,
    circle: `원 위의 ${count}개`,
    grid: `격자의 ${count}개`,
    'paper-ep': '논문: EP',
    'paper-arbitrary': '논문: 임의',
    hand: '직접 조정',
  })[name];

/** @param {number} unseen @param {number} own The starts of the experiment. */
export const columnsOf = (unseen, own) => [
  '진화에 쓴 출발점',
  '학습한 곳에서 도착',
  `처음 보는 ${grouped(unseen)}개 중 도착`,
  '평균 J',
  own === 1 ? '출발점\u00a0J' : `출발점 ${own}개\u00a0J`,
];

/** @param {number} part @param {number} count */
export const of = (part, count) => `${grouped(part)} / ${grouped(count)}`;

/** @param {RowName} name @param {Result | null} result @param {number} count */
export function trainingTitle(name, result, count) {
  if (!result) return `학습할 출발점 ${count}개`;
  const arrives = of(result.training.count, result.training.starts.length);
  return isEvolved(name) ? `학습한 곳: ${arrives}` : `출발점: ${arrives}`;
}

/** @param {Result | null} result @param {number} count */
export const unseenTitle = (result, count) =>
  result ? `처음 보는 곳: ${of(result.unseen.count, count)}` : `처음 보는 출발점 ${grouped(count)}개`;

/** @param {string} title */
export const pictureLabel = (title) =>
  `${title}. 왼쪽·오른쪽 화살표로 출발점을 차례로 옮겨 가며, 고른 곳에서 로봇이 주행합니다.`;

/** @param {import('../../../core/engine.js').Posture} start @param {string} outcome */
export const readout = (start, outcome) => `${postureText(start)}에서 출발: ${outcome}.`;

export const signs = { arrives: '채운 화살표는 도착,', misses: '작고 옅은 빈 화살표는 미도착.' };

export const pressOne = '누르면 그곳에서 주행합니다.';

/** What the pictures and the columns mean. @param {number} count @param {number} radius @param {number} horizon */
export const key = (count, radius, horizon) =>
  `처음 보는 곳: 목표에서 ${fixed(radius, 0)}\u00a0m 안의 출발점 ${grouped(count)}개, 방향각은 임의. 평균 J는 이들 전체의 평균이며, 각 주행은 늦어도 ${Number(horizon.toFixed(3))}초에 멈춥니다.`;

/** @param {Evolved} evolved */
export const evolvedNote = ({ experiment, generations, drives, milliseconds }) =>
  `시드 ${experiment.evolution.seed}, ${generations}세대: 주행 ${grouped(drives)}회, ${tookText(milliseconds)}`;

export const driving = '로봇이 주행하고 있습니다…';

/** @param {number} count The starts of the experiment. */
export const invitation = (count) =>
  `${count === 1 ? '출발점 하나로, 그리고 여러 개로' : '세 가지 출발점 집합으로'} 진화시켜 보십시오. 어느 로봇이 더 많이 도착할까요?`;

/** @param {Result} ep */
export const question = (ep) =>
  `논문의 EP 이득은 목표 주변 출발점 ${grouped(ep.unseen.starts.length)}개 중 ${percentOf(ep)}에서 도착합니다. ${invitation(ep.training.starts.length)}`;

/** @param {Result} result */
const percentOf = ({ unseen }) => percent(unseen.count, unseen.starts.length);

/** What the three evolutions have found. @param {Evolved} evolved */
export function lesson({ results: { one, circle, grid } }) {
  const found = `처음 보는 출발점 ${grouped(one.unseen.starts.length)}개 중 도착 비율: 출발점 ${one.training.starts.length}개로 진화하면 ${percentOf(one)}, 원 위의 ${circle.training.starts.length}개로는 ${percentOf(circle)}, 격자의 ${grid.training.starts.length}개로는 ${percentOf(grid)}입니다.`;
  const best = circle.unseen.count >= grid.unseen.count ? circle : grid;
  return `${found} ${moral(one, best, best === circle ? '원' : '격자')}`.trim();
}

export const tracking =
  '기준 자세가 움직이므로 로봇은 이를 추종할 뿐 도착하지 않습니다. 출발점 집합마다 진화시켜 평균 J를 비교해 보십시오.';

/** The same where the reference moved. @param {Evolved} evolved */
export const followed = ({ results: { one, circle, grid } }) =>
  `기준 자세가 움직이므로 도착하는 로봇은 없습니다. 처음 보는 출발점 ${grouped(one.unseen.starts.length)}개의 평균 J로 비교하면, 출발점 ${one.training.starts.length}개로 진화한 로봇은 ${cost(one.unseen.cost)}, 원 위의 ${circle.training.starts.length}개로는 ${cost(circle.unseen.cost)}, 격자의 ${grid.training.starts.length}개로는 ${cost(grid.unseen.cost)}입니다.`;

/** How far luck reaches. @param {Record<import('../sets.js').SetName, import('../spread.js').Range>} ranges @param {number} unseen @param {number} own The starts of the experiment. */
export function spreadText({ one, circle, grid }, unseen, own) {
  const told = (/** @type {import('../spread.js').Range} */ { least, median, most }) =>
    `${percent(median, unseen)}(${shareOf(least, unseen)}~${percent(most, unseen)})`;
  return `시드 하나로는 운이 크게 작용합니다. 시드 ${one.seeds}개로 진화시키면 처음 보는 출발점에서 도착하는 비율의 중앙값(최소~최대)은 출발점 ${own === 1 ? '하나' : `${own}개`}로 진화한 로봇이 ${told(one)}, 원으로 진화한 로봇이 ${told(circle)}, 격자로 진화한 로봇이 ${told(grid)}\u2060입니다.`;
}

/** What more arrivals cost, or why there are no more. Nothing where neither is so. @param {Result} one @param {Result} many @param {string} where */
function moral(one, many, where) {
  const arrivesMore = many.unseen.count > one.unseen.count;
  if (arrivesMore && many.own > one.own)
    return `그 대가로 ${where}로 진화한 로봇은 실험의 출발점에서 J가 ${cost(one.own)}에서 ${cost(many.own)}까지 올라갑니다.`;
  if (!arrivesMore && many.unseen.cost < one.unseen.cost)
    return `그래도 평균 J는 ${cost(one.unseen.cost)}에서 ${cost(many.unseen.cost)}까지 내려갑니다. J가 요구하는 것은 도착이 아니라 비용이 낮은 주행입니다.`;
  return '';
}

/** @param {('start' | 'goal' | 'limits' | 'seed' | 'settings')[]} changes */
export function outOfDate(changes) {
  const names = { start: '출발', goal: '목표', limits: '제한', seed: '시드', settings: '설정' };
  return `바뀐 조건: ${changes.map((change) => names[change]).join(', ')}. 다시 진화시키십시오.`;
}

/** @param {boolean} kept */
export const cancelled = (kept) =>
  kept ? '취소했습니다. 이전 결과를 보여 줍니다.' : '결과가 나오기 전에 취소했습니다.';

/** @param {string} message @param {boolean} kept */
export const failed = (message, kept) =>
  `${kept ? '마지막으로 계산된 결과를 보여 줍니다' : '계산하지 못했습니다'}: ${message}`;

/** @param {string} name */
export const chooseHint = (name) => `이 이득으로 주행: ${name}`;
