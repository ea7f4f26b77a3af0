// Every word of the luck part, in Korean.
/** @import { SeedSurvey } from '../request.js' */
/** @import { Change } from './common.js' */
import { gainNames, isRandom } from './common.js';
import { costText, fixed, grouped, tookText } from '../../../words/ko/numbers.js';

export * from './common.js';
export * from './contest-ko.js';
export { percent } from './contest-ko.js';

export const texts = {
  luckGainsPicture: '모든 시드의 이득',
  luckCurvePicture: '모든 시드의 적합도 곡선',
  luckTitle: '시드의 운',
  luckCount: '시드 수',
  luckGenerations: '세대 수',
  luckTable: '표와 CSV',
  luckProgress: '끝난 시드',
  luckCurve: '세대별 지금까지의 최소 J: 중앙값과 사분위수',
  luckLog: '로그',
  luckGainsTitle: '마지막 이득: 점 하나가 시드 하나',
  luckMedian: '중앙값',
  luckLuckiest: '최고의 운',
  luckUnluckiest: '최악의 운',
  luckRank: '가장 운 좋은 시드부터 가장 운 나쁜 시드까지 하나 고르기',
};

/** @param {number} count */
export const runText = (count) => `시드 ${count}개 실행`;
export const cancel = '취소';

/** @param {number} count */
export const countChoice = (count) => `시드 ${count}개`;
/** @param {number} generations */
export const generationsChoice = (generations) => `${generations}세대`;

/** @param {SeedSurvey} survey */
export const surveyNote = ({ experiment, runs, drives, milliseconds }) =>
  `${countChoice(runs.length)}${drives === null ? '' : `, 각각 주행 ${isRandom(experiment) ? '' : '2 × '}${grouped(drives)}회`}, ${tookText(milliseconds)}`;

/** @param {number} seed @param {number} generation */
export const labNote = (seed, generation) => `실험실: 시드 ${seed}, ${generation}세대`;

/** What a press will do. @param {SeedSurvey['experiment']} experiment @param {number} count @param {number} generations @param {number | null} drives */
export const invitation = (experiment, count, generations, drives) =>
  `한 번의 실행은 주사위를 한 번 던진 것과 같습니다. 시드 ${count}개를 실행해 보십시오. ${isRandom(experiment) ? `시드마다 무작위 탐색이 ${generations}세대 동안 다른 로봇을 뽑습니다` : `시드마다 다른 무작위 로봇이 ${generations}세대 동안 진화하고, 무작위 탐색도 같은 수의 이득을 시험합니다`}${drives === null ? '' : `(각각 주행 ${grouped(drives)}회)`}.`;

/** @param {number} done @param {number} count */
export const seedsOf = (done, count) => `시드 ${count}개 중 ${done}개`;

/** @param {boolean} hasResult */
export const cancelled = (hasResult) =>
  hasResult
    ? '취소했습니다. 마지막으로 완성된 결과를 보여 줍니다.'
    : '완성된 결과가 나오기 전에 취소했습니다.';

/** @param {string} message @param {boolean} hasResult */
export const failed = (message, hasResult) =>
  hasResult ? `마지막으로 계산된 결과를 보여 줍니다: ${message}` : message;

/** @param {readonly Change[]} changes */
export const outOfDate = (changes) =>
  `지금과 다른 조건에서 얻은 결과입니다. 바뀐 조건: ${changes.map((change) => earlier[change]).join(', ')}.`;

/** @type {Readonly<Record<Change, string>>} */
const earlier = { start: '출발', goal: '목표', limits: '제한', settings: '설정' };

/** What was found, true for whatever comes out. @param {SeedSurvey} survey */
export function finding({ experiment, runs, generations, summary }) {
  const { final, finalRandom, randomWins, overtakes } = summary;
  const evolution = `${generations}세대 뒤, 시드 ${runs.length}개 중 절반의 J는 ${costText(final.median)} 이하이고, 가장 운 나쁜 시드의 J는 ${costText(final.most)}입니다.`;
  // It is what is beside it.
  if (isRandom(experiment)) return evolution;
  const isThere = overtakes > 0 && overtakes < generations;
  const overtaken = isThere
    ? ` 진화의 중앙값은 ${overtakes}세대에 이미 무작위 탐색의 중앙값에 이릅니다.`
    : '';
  const wins =
    randomWins === 0
      ? '무작위 탐색이 더 나은 시드는 없습니다.'
      : `무작위 탐색이 더 나은 시드는 ${randomWins}개입니다.`;
  return `${evolution} 같은 횟수를 주행한 무작위 탐색의 중앙값은 ${costText(finalRandom.median)}이며, ${wins}${overtaken}`;
}

export const evolutionLine = '진화';
export const randomLine = '무작위 탐색';
export const paperLine = '논문 EP';
/** After the title of the gains. */
export const paperSign = ', ◇ 논문의 EP';
export const evolutionHead = '진화';
export const randomHead = '무작위';
/** Where no seed has run yet. */
export const expectedText = '여기에 모든 시드의 중앙값이 나타나고, 그 옆에 시드마다 점이 하나씩 놓입니다.';
export const generationAxis = '세대';
/** @param {number} lowest */
export const distanceAxis = (lowest) => `J − ${costText(lowest)}(전체 최소)`;
/** @param {number} seed */
export const labLine = (seed) => `실험실의 시드 ${seed}`;
/** @param {number} seed */
export const seedLine = (seed) => `시드 ${seed}`;

/** @param {SeedSurvey} survey @param {string} found */
export const curveLabel = ({ generations, paper }, found) =>
  `${generations}세대에 걸친 최소 J. ${found}${Number.isFinite(paper.cost) ? ` 논문의 EP 이득은 여기에서 J ${costText(paper.cost)}입니다.` : ''}`;
export const emptyCurveLabel =
  '실험실에서 실행한 진화의 세대별 최소 J. 다른 시드는 아직 실행하지 않았습니다.';

/** @param {SeedSurvey} survey */
export const gainsLabel = ({ summary }) =>
  `마지막 이득. ${summary.gains
    .map(
      ({ low, median, high }, i) =>
        `${gainNames[i]}: 중앙값 ${fixed(median, 3)}, 시드의 절반은 ${fixed(low, 3)}~${fixed(high, 3)}`,
    )
    .join('; ')}.`;
export const emptyGainsLabel = '마지막 이득. 아직 실행한 시드가 없습니다.';

/** @param {SeedSurvey} survey @param {number} index @param {number} rank */
export function readout({ first, runs }, index, rank) {
  const { champion } = runs[index];
  const gains = champion.gains.map((gain, i) => `${gainNames[i]} ${fixed(gain, 3)}`).join(', ');
  return `시드 ${first + index}, ${runs.length}개 중 ${rank}위: J ${costText(champion.cost)}\n${gains}`;
}

/** @param {number} seed */
export const openSeed = (seed) => `실험실에서 시드 ${seed} 열기`;

/** @param {number} seeds @param {number} generations */
export const tableCaption = (seeds, generations) =>
  `시드 ${seeds}개, ${generations}세대: 최우수 로봇의 J, 마지막 이득, 같은 횟수를 주행한 무작위 탐색`;
export const seedColumn = '시드';
/** @param {number} generation */
export const costColumn = (generation) => `${generation}세대의 J`;
export const randomColumn = '무작위 탐색의 J';
export const quartiles = {
  least: '최소',
  low: '제1사분위수',
  median: '중앙값',
  high: '제3사분위수',
  most: '최대',
};
