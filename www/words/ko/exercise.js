// Every word of an exercise: what students see of it, and the panel in which it is made; in Korean.

export const texts = {
  exercise: '과제',
  taskLabel: '이 링크를 만든 사람이 낸 과제',
  leaveExercise: '전체 페이지 열기',
  handles: '출발과 목표',
  keepExerciseTitle: '과제',
  keepExerciseHelp:
    '이 실행에 과제를 붙여 학생에게 줍니다. 방해가 되거나 답을 미리 알려 주는 조작은 잠그거나 숨길 수 있습니다.',
  keepExercise: '과제 만들기',
  makerTitle: '과제 만들기',
  makerHelp:
    '학생이 보게 될 모습이 페이지에 바로 나타납니다. 비밀은 아닙니다. 학생도 전체 페이지를 열 수 있습니다.',
  makerTask: '과제 내용',
  makerLink: '과제 링크',
  makerCopyLink: '링크 복사',
  makerFrame: '다른 페이지에 넣을 프레임',
  makerCopyFrame: '프레임 복사',
  makerClose: '과제 만들기 닫기',
};

/** What is locked or hidden together. @type {Record<import('../common/kinds.js').Group, string>} */
export const groups = {
  gains: '이득',
  drives: '주행에 쓰는 이득',
  paper: '논문의 이득',
  postures: '출발과 목표',
  run: '진화 실행',
  seed: '새 시드',
  clock: '로봇의 시간',
  settings: '설정과 제한',
  parts: '다른 부분',
  lesson: '수업',
  share: '공유',
};

/** @type {readonly import('../../kit/segmented.js').Choice<import('../common/kinds.js').Way>[]} */
export const ways = [
  { value: 'free', text: '사용' },
  { value: 'locked', text: '잠금' },
  { value: 'hidden', text: '숨김' },
];

/** @param {readonly string[]} locked @param {readonly string[]} hidden */
export const locksText = (locked, hidden) =>
  [
    locked.length > 0 ? `이 링크가 잠근 것: ${locked.join(', ')}.` : '',
    hidden.length > 0 ? `이 링크가 숨긴 것: ${hidden.join(', ')}.` : '',
  ]
    .filter((text) => text !== '')
    .join(' ');

/** @param {number} count @param {number} most */
export const countText = (count, most) => `최대 ${most}자 중 ${count}자`;
