// Every word of an exercise that students see, in Korean.

export const texts = {
  exercise: '과제',
  taskLabel: '이 링크를 만든 사람이 낸 과제',
  leaveExercise: '전체 페이지 열기',
  handles: '출발과 목표',
};

/** What is locked or hidden together. @type {Record<import('../common/kinds.js').Group, string>} */
export const groups = {
  gains: '이득',
  drives: '주행에 쓰는 이득',
  paper: '논문의 이득',
  postures: '출발과 목표',
  run: '진화 실행',
  seed: '새 시드',
  clock: '로봇 재생',
  settings: '설정과 제한',
  parts: '다른 부분',
  lesson: '수업',
  share: '공유',
};

/** @param {readonly string[]} locked @param {readonly string[]} hidden */
export const locksText = (locked, hidden) =>
  [
    locked.length > 0 ? `이 링크가 잠근 것: ${locked.join(', ')}.` : '',
    hidden.length > 0 ? `이 링크가 숨긴 것: ${hidden.join(', ')}.` : '',
  ]
    .filter((text) => text !== '')
    .join(' ');
