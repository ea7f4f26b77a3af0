// Every word of checking hand-ins, in Korean.
/** @import { Row, Worth } from '../check.js' */
/** @import { Column } from './common.js' */

export * from './common.js';

export const texts = {
  help: '학생들이 낸 것을 붙여 넣거나 파일과 폴더를 여기에 끌어다 놓으십시오. 제출물, 링크, Moodle이나 Canvas의 표 전체 또는 한 열, 온라인 텍스트를 모두 읽습니다. 압축 파일은 먼저 푸십시오. 모든 주행을 여기서 다시 계산하며 아무것도 이 페이지 밖으로 나가지 않습니다.',
  paste: '제출된 내용',
  exercise: '과제 링크(비우면 가장 많은 학생이 푼 과제)',
  files: '파일 고르기',
  folder: '폴더 고르기',
  empty: '다른 반',
  check: '확인',
  cancel: '취소',
  csv: '성적부에 넣을 표(CSV)',
  progress: '확인한 정도',
  open: '열기',
  before: '이전',
  after: '다음',
  table: '제출물 목록',
  histogram: 'J의 분포',
  gains: '제출된 이득',
  costAxis: 'J',
  larger: '그 이상',
  strip: '제출물 목록',
  stripBack: '브라우저의 뒤로 버튼을 누르면 이전에 열려 있던 실험으로 돌아갑니다.',
  countAxis: '제출 수',
};

/** Half have at most the middle one. @param {number} count @param {string} least @param {string} middle @param {string} most */
export const histogramLabel = (count, least, middle, most) =>
  `${texts.histogram}: ${count}건, J ${least}에서 ${most}까지, 절반은 ${middle} 이하`;
/** @param {string} name @param {string} low @param {string} high */
export const reachText = (name, low, high) => `${name} ${low}에서 ${high}까지`;
/** @param {readonly string[]} reaches */
export const gainsLabel = (reaches) => `${texts.gains}: ${reaches.join(', ')}`;

/** @type {Readonly<Record<Column, string>>} */
export const columns = {
  number: '번호',
  pin: '고정',
  name: '이름',
  who: '적은 이름',
  cost: 'J',
  met: '기준',
  points: '점수',
  drives: '주행',
  remark: '비고',
  open: '보기',
};

/** @param {string} column */
export const sortBy = (column) => `정렬: ${column}`;

/** @param {string} name */
export const openLabel = (name) => `${name}의 주행 열기`;

/** @param {string} name */
export const pinLabel = (name) => `${name}의 주행 고정`;

export const met = '달성';
export const notMet = '미달';
/** Of a receipt that did not come whole: it has no points. */
export const cut = '잘림';

/** @param {number} drives @param {boolean} isTold */
export const drivesText = (drives, isTold) => (isTold ? `${drives}(본인 기록)` : String(drives));

/** @type {Readonly<Record<Exclude<Worth, 'holds' | 'otherResult'>, string>>} */
export const worths = {
  broken: '잘렸거나 바뀐 제출물이어서 점수 없음',
  otherProgram: '다른 버전의 프로그램으로 만든 제출물',
  none: '“제출물 만들기”\u2060를 거치지 않은 링크',
};

export const lacksWho = '이름이나 학번이 없어 과제가 정해지지 않았으므로 판정하지 않음';
export const unseen = '이름이나 학번에 보이지 않는 글자가 있음';
export const lacksDrives = '주행 횟수를 알 수 없어 판정하지 않음';

/** @param {number} told */
export const otherResult = (told) => `적힌 값은 J = ${told}, 실제 주행의 값과 다름`;

/** @param {readonly string[]} names */
export const differs = (names) => `과제와 다른 것: ${names.join(', ')}`;

/** @param {string} cost */
export const ownCost = (cost) => `제출한 설정에서는 J = ${cost}`;

/** @param {readonly { number: number, name: string }[]} twins @param {number} more */
export const same = (twins, more) =>
  `같은 답: ${twins.map(({ number, name }) => `${number}번 ${name}`.trim()).join(', ')}${more > 0 ? ` 외 ${more}명` : ''}`;

/** @param {readonly number[]} numbers @param {number} more */
export const also = (numbers, more) =>
  `같은 학생의 다른 제출: ${numbers.map((number) => `${number}번`).join(', ')}${more > 0 ? ` 외 ${more}개` : ''}`;

/** @param {string} text @param {Row['problem']} problem @param {number} most Of one student. */
export function problemText(text, problem, most) {
  const began = text ? ` “${text}”` : '';
  if (problem === 'none') return `제출물이 없음:${began || ' 비어 있음'}`;
  if (problem === 'long') return `제출물이라고 하기에는 너무 김${began}`;
  if (problem === 'more') return `이 파일에서는 제출물만, 그것도 마지막 ${most}개까지만 확인함`;
  if (problem === 'bytes')
    return '글이 아니라 문서나 압축 파일이나 그림임: 압축 파일이면 풀고, 아니면 제출물의 텍스트를 다시 받아야 함';
  if (problem === 'heavy') return '계산하기에 너무 오래 걸림';
  return problem === '' ? '' : `읽을 수 없음: ${problem.said}`;
}

/** @param {number} all @param {number} met @param {number} unread @param {number} marked @param {number} milliseconds */
export const summary = (all, met, unread, marked, milliseconds) =>
  `제출물 ${all}개(${(milliseconds / 1000).toFixed(1)}초): 기준 달성 ${met}개, 읽을 수 없는 것 ${unread}개, 그 밖에 비고가 있는 것 ${marked}개.`;

/** @param {string} exercise @param {string} task */
export const judgedBy = (exercise, task) => `기준이 된 과제 ${exercise}${task ? `: ${task}` : ''}`;

/** @param {number} checked @param {number} all */
export const onlyFirst = (checked, all) =>
  `${all}개 중 처음 ${checked}개만 확인했습니다. 나머지는 따로 확인하십시오.`;
/** @param {number} read @param {number} all */
export const cutText = (read, all) => `붙여 넣은 ${all}자 중 처음 ${read}자만 읽었습니다.`;

/** The marks in the pictures. @type {Readonly<Record<string, string>>} */
export const legend = {
  met: '기준 달성',
  not: '기준 미달',
  unjudged: '판정하지 않음',
  aim: '기준값',
  far: '이 방향으로 더 멀리 있음',
};

/** @param {string} cost */
export const costText = (cost) => `J = ${cost}`;
/** @param {string} met */
export const aimText = (met) => `기준: ${met}`;
/** @param {number} points */
export const pointsText = (points) => `${points}점`;
/** @param {number} place @param {number} count */
export const placeText = (place, count) => `${count}개 중 ${place}번째`;

export const noLink = '이 주소에는 과제가 없습니다. # 뒤까지 링크 전체를 복사하십시오.';
export const nothing = '아직 확인할 것이 없습니다.';
export const cancelled = '취소했습니다.';
/** @param {string} reason */
export const failed = (reason) => `확인하지 못했습니다: ${reason}`;
/** @param {string} reason */
export const noExercise = (reason) => `과제 링크를 읽을 수 없습니다: ${reason}`;
/** @param {number} files */
export const filesText = (files) => (files === 0 ? '' : `파일 ${files}개와 함께`);
/** @param {string} name */
export const pinned = (name) => `고정함: ${name}. 평면과 “곡선” 화면에 나타납니다.`;
/** @param {string} name */
export const unpinned = (name) => `고정을 풂: ${name}.`;
/** @param {string} name @param {number} most */
export const notPinned = (name, most) =>
  `고정하지 못함: ${name}. 이미 ${most}개가 고정되어 있어 더는 고정할 수 없습니다. 먼저 여기나 페이지에서 하나를 푸십시오.`;
/** @param {number} first @param {number} last @param {number} count */
export const rowsText = (first, last, count) => `${count}개 중 ${first}~${last}`;
export const csvHead = {
  points: '점수',
  aim: '기준',
  drives: '주행',
  minutes: '분',
  how: '찾은 방법',
  answers: '답',
  remarks: '비고',
  link: '링크',
  reached: '도달한 값',
};
