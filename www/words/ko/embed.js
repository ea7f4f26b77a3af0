// Every word of a figure in another page’s frame, in Korean.

export const openFull = '전체 페이지 열기';
/** It leads out of an exercise. */
export const openFree = '과제 없이 전체 페이지 열기';
export const fullScreen = '전체 화면';
export const leaveFullScreen = '전체 화면 끝내기';

export const givenUp = '준비되기 전에 취소되었습니다';

/** @param {string} found @param {number} own */
export const otherVersion = (found, own) => `메시지 형식의 버전은 ${own}이며, 받은 값은 ${found}입니다`;

/** @param {string} found @param {readonly string[]} known */
export const unknownType = (found, known) =>
  `type은 ${known.join(', ')} 중 하나여야 하며, 받은 값은 ${found}입니다`;

/** @param {string} type @param {string} found @param {readonly string[]} known */
export const unknownField = (type, found, known) =>
  `${type}의 필드는 ${known.join(', ')} 중 하나여야 하며, 받은 값은 ${found}입니다`;

/** @param {number} length */
export const aList = (length) => `길이 ${length}의 배열`;
export const anObject = '객체';

export const linkOrExperiment = 'set에는 문자열인 link나 객체인 experiment 중 하나가 있어야 합니다';

/** @param {string} field @param {number} least @param {number} most @param {string} found */
export const wholeNumber = (field, least, most, found) =>
  `${field}에 허용되는 값은 ${least} 이상 ${most} 이하의 정수이며, 받은 값은 ${found}입니다`;

/** @param {string} found */
export const threeGains = (found) => `gains는 세 수 kx, ky, kθ여야 하며, 받은 값은 ${found}입니다`;
