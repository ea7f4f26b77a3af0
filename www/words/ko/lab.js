// Every word of the lab and of what all pages share, in Korean.
/** @import { Posture, Run, Statistics } from '../../core/engine.js' */
/** @import { Driver, Restart, Until } from '../common/kinds.js' */
import { isTracking } from '../../core/reference.js';
import {
  clockTime,
  costText,
  fixed,
  grouped,
  postureText,
  sixDigits,
  textBelow,
  textsApart,
  wasText,
} from './numbers.js';
import { arrivedText } from './arrived.js';

export * from '../common/lab.js';
export * from './computing.js';
export * from './numbers.js';

/** Texts of elements with data-text, labels of elements with data-label. */
export const texts = {
  pageTitle: '진화로 찾는 로봇 제어기',
  pageDescription:
    '진화 프로그래밍이 이동 로봇 자세 제어기의 이득을 찾아 가는 과정을 보여 줍니다(Kim과 Shim, 1995).',
  pages: '이 페이지의 구성',
  skip: '본문으로 바로 가기',
  evolutionSection: '진화',
  planeSection: '로봇',
  robotClock: '로봇 재생',
  speed: '로봇 재생 속도',
  scrub: '로봇의 주행 시각',
  curveTitle: '적합도 곡선',
  generationBefore: '',
  generationAfter: '세대',
  evolutionClock: '진화의 시간',
  pauseEvolution: '진화 멈춤',
  oneGeneration: '한 세대 진행',
  oneBack: '한 세대 뒤로',
  timeline: '세대',
  pace: '진화 속도',
  until: '진화를 멈출 때',
  untilValue: '진화를 멈출 세대 또는 J',
  reset: '처음으로',
  newSeed: '새 시드',
  seedWord: '시드',
  gainsTitle: '이득',
};

export const presetLegend = '로봇의 제한';
/** @type {import('../../kit/segmented.js').Choices<import('../../core/engine.js').Preset>} */
export const presets = {
  'velocity-limits': { text: '속도 제한', hint: '논문의 그림 4, 5' },
  'acceleration-limits': { text: '+ 가속도 제한', hint: '논문의 그림 6, 7' },
};

export const driverLegend = '주행에 쓰는 이득';
/** @type {import('../../kit/segmented.js').Choices<Driver>} */
export const drivers = {
  evolved: '진화 결과',
  hand: '직접 조정',
  'paper-ep': { text: '논문: EP', hint: '논문에서 진화 프로그래밍으로 찾은 이득' },
  'paper-arbitrary': {
    text: '논문: 임의',
    hint: '논문이 비교 대상으로 삼은, 진화 없이 정한 이득',
  },
};

export const labName = '실험실';
/** What it is for. @param {number} population How many robots there are. */
export const labPurpose = (population) =>
  `무작위 이득을 세 개씩 가진 로봇 ${population}대가 목표로 주행합니다. 진화는 잘 주행하는 로봇을 남깁니다.`;

export const endTrial = '원래 출발점으로';

/** Gains by hand, by where they are from. @type {Record<import('../common/kinds.js').Found, string>} */
export const foundName = {
  hand: '직접 조정한 이득',
  map: '비용 지형에서 고른 이득',
  training: '“학습”\u2060에서 고른 이득',
  luck: '“운”\u2060에서 고른 이득',
};

/** @param {Driver} driver @param {number} generation @param {import('../common/kinds.js').Found} found */
export const driverName = (driver, generation, found) =>
  ({
    evolved: `${generation}세대 최우수`,
    hand: foundName[found],
    'paper-ep': '논문의 EP 이득',
    'paper-arbitrary': '논문의 임의 이득',
  })[driver];

/** @param {number} starts Of which the first is driven from. */
export const costMeaning = (starts) =>
  starts > 1 ? `출발점 ${starts}개 중 첫 번째의 J, 낮을수록 좋음` : 'J, 낮을수록 좋음';

/** @param {Driver} driver @param {import('../common/kinds.js').Found} found @param {boolean} isLowest Of all generations: some searches forget theirs. */
export const costTitle = (driver, found, isLowest) =>
  ({
    evolved: isLowest ? '최우수 로봇의 비용' : '이 세대 최우수 로봇의 비용',
    hand: found === 'hand' ? `${foundName.hand}의 비용` : '이 이득의 비용',
    'paper-ep': '논문 EP 이득의 비용',
    'paper-arbitrary': '논문 임의 이득의 비용',
  })[driver];

/** @param {Run} run */
export const outcomeText = (run) =>
  ({
    arrived: `${fixed(run.finalTime, 2)}초 뒤 도착`,
    horizon: isTracking(run)
      ? `${sixDigits(run.finalTime)}초 동안 기준 자세를 추종`
      : `${sixDigits(run.finalTime)}초 안에 도착하지 못함`,
    diverged: '발산',
  })[run.outcome];

/** @param {string} name @param {number} cost */
export const costNote = (name, cost) => `같은 조건, ${name}:\u00a0${costText(cost)}`;

/** @param {number} starts @param {number} cost */
export const meanNote = (starts, cost) => `출발점 ${starts}개 모두의 평균:\u00a0${costText(cost)}`;

/** @param {number} value */
export const partText = (value) => (value < 100 ? fixed(value, 2) : costText(value));

/** @type {readonly (readonly [part: Exclude<keyof import('../../core/engine.js').Cost, 'total'>, name: string])[]} */
export const costParts = [
  ['time', '시간'],
  ['path', '경로'],
  ['energy', '에너지'],
  ['finalError', '최종'],
  ['penalty', '벌점'],
];

/** @param {{ others: number, population: number, arrived: number | null }} drives Null where nobody can arrive. */
export function othersText({ others, population, arrived }) {
  const who =
    others === population - 1 ? `나머지 로봇 ${others}대` : `전체 로봇 ${population}대 중 다음 ${others}대`;
  return arrived === null ? who : `${who}, ${arrivedText(arrived, others)}`;
}

/** @param {string} name @param {Run} run */
export const comparisonText = (name, run) => `${name}, J ${costText(run.cost.total)}`;

export const withoutDisturbance = '같은 주행, 외란 없음';

export const dragHint = '끌어서 옮기거나 돌리기';
export const startName = '출발';
export const goalName = '목표';
export const referenceName = '기준 자세';
export const restorePostures = '논문의 자세로';

/** @param {string} name */
export const positionLabel = (name) =>
  `${name} 위치. 화살표 키로 0.1 m씩, Alt와 함께 0.01 m씩 옮깁니다. Shift와 왼쪽·오른쪽 화살표로 5°씩 돌립니다.`;

/** @param {string} name */
export const headingLabel = (name) => `${name} 방향각. 왼쪽·오른쪽 화살표로 5°씩, Alt와 함께 1°씩 돌립니다.`;

export const planeLabel = '출발점에서 목표로 로봇이 주행하는 평면';

/** `time` is empty while the clock runs. @param {string} name @param {Run} run @param {Posture} start @param {Posture} goal @param {string} time @param {string} others @param {string[]} pins */
export const planeText = (name, run, start, goal, time, others, pins) =>
  `주행: ${name}. 출발 ${postureText(start)}, 목표 ${postureText(goal)}. 결과: ${outcomeText(run)}.${time && ` 표시 시각: ${time}.`} ${others}${pins.length > 0 ? ` 고정한 주행: ${pins.join('; ')}.` : ''}`;

/** @param {number} time @param {number} finalTime */
export const clockText = (time, finalTime) =>
  `${clockTime(time, finalTime)} / ${clockTime(finalTime, finalTime)}초`;

export const play = '로봇 주행 시작';
export const pause = '로봇 멈춤';
export const run = '진화 시작';
export const pauseEvolution = '멈춤';

/** @param {number} pace Generations in a second; with 0 it is one phase at a time. */
export const paceText = (pace) =>
  pace === 0 ? '한 단계씩' : Number.isFinite(pace) ? `${pace}세대/초` : '최대 속도';

/** @type {readonly (readonly [kind: Until['kind'], text: string])[]} */
export const untils = [
  ['every', '100세대마다 멈춤'],
  ['generation', '멈출 세대'],
  ['cost', 'J가 이보다 낮으면'],
];

/** What is wrong with it, if anything. @param {Until['kind']} kind @param {number} value @param {string} text @param {number} next The first generation that is yet to come. @param {number} last */
export const untilRefused = (kind, value, text, next, last) =>
  kind === 'generation'
    ? Number.isInteger(value) && value >= next && value <= last
      ? ''
      : `멈출 세대는 ${next} 이상 ${last} 이하의 정수여야 합니다. ${wasText(text)}`
    : value > 0 && value < Number.POSITIVE_INFINITY
      ? ''
      : `멈출 J는 0보다 큰 수여야 합니다. ${wasText(text)}`;

/** @param {number} generation @param {number} newest */
export const generationText = (generation, newest) => `${newest}세대 중 ${generation}세대`;

/** @param {number} generation @param {number} newest */
export const recordedText = (generation, newest) =>
  `전체 ${newest}세대 중 ${generation}세대로 돌아왔습니다. 모두 그때 그대로입니다.`;

/** @param {Restart} restart @param {number} population @param {boolean} isPapers Whether it is the paper's evolution. */
export const restartText = (restart, population, isPapers) =>
  ({
    begin: isPapers
      ? population === 1
        ? '무작위 로봇 1대: 자손을 하나 만들고, 토너먼트로 둘 중 하나가 남습니다.'
        : `무작위 로봇 ${population}대: 각각 자손을 하나씩 만들고, 토너먼트로 ${population}대가 남습니다.`
      : '논문과 다른 탐색의 0세대입니다.',
    moved: '출발 또는 목표가 바뀌어 진화를 0세대부터 다시 시작합니다.',
    limits: '제한이 바뀌어 진화를 0세대부터 다시 시작합니다.',
    seed: `새 시드입니다. 0세대의 다른 로봇 ${population}대로 시작합니다.`,
    setting: '설정이 바뀌어 진화를 0세대부터 다시 시작합니다.',
    undone: '한 단계 되돌렸습니다. 진화를 0세대부터 다시 시작합니다.',
    redone: '한 단계 다시 적용했습니다. 진화를 0세대부터 시작합니다.',
    given: '주어진 과제대로 되돌려 진화를 0세대부터 다시 시작합니다.',
    reset: '다시 0세대입니다. 같은 시드에서는 같은 진화가 일어납니다.',
  })[restart];

/** @param {Statistics} first @param {Statistics} newest */
export function progressText(first, newest) {
  const drives = `지금까지 주행 ${grouped(newest.evaluations)}회`;
  const [from, to] = textsApart(first.best.cost, newest.best.cost, costText);
  return from === to ? `${drives}, 최소 J 변화 없음: ${to}` : `${drives}, 최소 J: ${from} → ${to}`;
}

/** @param {number} generation */
export const restText = (generation) =>
  `${generation}세대에서 멈추었습니다. “진화 시작”\u2060을 누르면 이어집니다.`;

/** @param {number} value Below which J was to come. @param {Statistics} statistics */
export const reachedText = (value, { generation, best }) =>
  `${generation}세대에서 멈추었습니다. 최소 J ${textBelow(best.cost, value, costText)} < ${sixDigits(value)}`;

/** @param {Statistics} statistics */
export const announcement = (statistics) =>
  `${statistics.generation}세대: 최소 J ${costText(statistics.best.cost)}`;

export const bestLine = '최소';
export const medianLine = '중앙값';
export const paperLine = '논문 EP';
/** @param {number} metres */
export const outside = (metres) => `${fixed(metres, 1)} m 밖`;

/** @param {Statistics} first @param {Statistics} newest */
export const curveLabel = (first, newest) =>
  `${newest.generation}세대에 걸친 적합도 곡선. 최소 J: ${costText(first.best.cost)} → ${costText(newest.best.cost)}, 중앙값: ${costText(first.median)} → ${costText(newest.median)}.`;

export const generationAxis = '세대';

/** @param {Driver} driver @param {boolean} isPapers Whether a hand is compared with the paper's evolution. @param {number | null} cost Of what it is compared with, if it is of the same drive. */
export const gainsNote = (driver, isPapers, cost) =>
  ({
    evolved: '움직이면 직접 조정으로 바뀝니다',
    hand: `도전: ${isPapers ? '논문의 J' : '진화의 최소 J'}${cost === null ? '' : ` ${costText(cost)}`}보다 낮게`,
    'paper-ep': '논문에서 진화로 찾은 이득',
    'paper-arbitrary': '진화 없이 정한 이득',
  })[driver];

/** Where starts around it are asked for. */
export const goalAtEdge = '목표가 평면의 끝(±1000 m)에 너무 가까워, 그 둘레의 출발점이 평면을 벗어납니다';

export const gainsReplaced = '되돌리기(Ctrl+Z)로 내 이득 되찾기';

/** @param {string} name */
export const gainInputLabel = (name) => `${name}, 값`;

/** @param {string} name @param {string} was */
export const notANumber = (name, was) => `${name}: 수를 입력해야 합니다(예: 3.5). ${wasText(was)}`;
/** @param {string} name @param {string} message */
export const gainRefused = (name, message) => `${name}: 이 값은 쓸 수 없습니다. ${message}`;
