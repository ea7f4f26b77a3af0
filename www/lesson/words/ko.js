// Every word that the steps of the lesson share, and the steps.
import { costText, fixed } from '../../words/ko/numbers.js';

export * as steps from './ko/all.js';

export const stepLabel = '수업 단계';
/** @param {number} number @param {number} count */
export const stepOf = (number, count) => `${count}단계 중 ${number}단계`;
/** @param {string} title */
export const nextStep = (title) => `다음: ${title}`;
/** @param {string} title */
export const previousStep = (title) => `이전: ${title}`;
/** What of the figure stays in sight on a telephone. */
export const sights = '읽는 동안 보이는 것';
export const sightOfStage = '그림';
export const sightOfRobot = '로봇';
export const notice = '눈여겨볼 점';
export const tries = '해 볼 것';
export const showNumbers = '지금의 수치를 넣어 보기';
export const hideNumbers = '수치 감추기';
export const formula = '식';
export const right = '실제 결과';
export const yours = '나의 예측';
export const asPredicted = '예측한 대로입니다.';
export const otherwise = '예측과 다릅니다.';
export const computing = '주행하는 중…';
export const watching = '주행을 지켜보십시오. 주행이 끝나면 답이 나타납니다.';
export const besidePath = '수업 밖의 자료';
/** @param {string} title */
export const toPath = (title) => `수업으로: ${title}`;
/** After the last step. */
export const pathEnds =
  '수업은 여기까지입니다. 이제 위의 열린 과제를 풀거나, [로봇을 모두 주차시켜](park) 보십시오. 강의에 쓸 자료는 [강의하는 분께](lesson&step=lecturers)에 있습니다.';
export const stage = '이 단계의 그림';

/** @type {Record<import('./common.js').Mark['name'], string>} */
const markNames = { fives: '5, 5, 5', arbitrary: '논문의 임의 이득', ep: '논문의 진화한 이득' };
/** What one has beaten by hand, said aloud. @param {readonly import('./common.js').Mark[]} marks */
export const beaten = (marks) =>
  marks.length === 0
    ? ''
    : `나의 최소 J는 다음보다 낮습니다: ${marks.map(({ name, cost }) => `${markNames[name]}(${costText(cost)})`).join(', ')}.`;

/** @param {readonly number[]} gains */
const gainsText = (gains) => gains.map((gain) => fixed(gain, gain < 10 ? 2 : 0)).join(', ');
export const swarm = {
  /** @param {string} name @param {number} parked @param {number} starts */
  label: (name, parked, starts) =>
    `${name}: 출발점 ${starts}개에서 로봇이 한 주차 자리로 달립니다. 마지막에 주차한 로봇은 ${parked}대입니다.`,
  parked: '주차',
  /** @param {number} starts */
  ofStarts: (starts) => `/ ${starts}대`,
  mean: '평균 J',
  tooLong: '이 설정에서는 주행이 너무 길어 32대를 한꺼번에 볼 수 없습니다.',
  again: '다시 주행',
  own: gainsText,
  /** @param {readonly number[]} gains */
  evolution: (gains) => `진화: ${gainsText(gains)}`,
};
export const askAgain = '다시 풀기';
export const lapsed = '답이 나오기 전에 조건이 바뀌었습니다. 다시 예측해 보십시오.';
export const saidElsewhere = '설명은 다른 언어로 나왔습니다. 여기서 읽으려면 “다시 풀기”를 누르십시오.';
export const otherWeights = '나머지 가중치';
