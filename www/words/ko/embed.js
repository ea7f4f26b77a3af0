// Every word of a figure in another page's frame, and of the dialog that writes the frame; in Korean.

export * from '../common/embed.js';

export const texts = {
  embedTitle: '삽입',
  embedHelp:
    '지금 보이는 화면을 강의 페이지, 블로그, 슬라이드 같은 다른 페이지에 넣습니다. 조작하기 전까지는 움직이지 않습니다.',
  embedText: '붙여 넣을 코드',
  embedCopy: '복사',
  embedDisk: '이 페이지는 디스크에서 열었습니다. 코드를 붙여 넣을 페이지와 같은 폴더에 이 파일을 두십시오.',
};

export const sizeLegend = '프레임 크기';

export const copied = '코드를 복사했습니다.';
export const notCopied =
  '이 브라우저는 페이지의 복사를 허용하지 않습니다. 코드를 선택해 두었으니 키보드로 복사하십시오.';

/** What a screen reader says of the frame. @param {string} part */
export const frameTitle = (part) => `로봇 제어기의 진화: ${part}`;

export const openFull = '전체 페이지 열기';
export const fullScreen = '전체 화면';
export const leaveFullScreen = '전체 화면 끝내기';

/** @param {string} found @param {number} own */
export const otherVersion = (found, own) => `메시지 형식의 버전은 ${own}이며, 받은 값은 ${found}입니다`;

/** @param {string} found @param {readonly string[]} known */
export const unknownType = (found, known) =>
  `type은 ${known.join(', ')} 중 하나여야 하며, 받은 값은 ${found}입니다`;

export const linkOrExperiment = 'set에는 문자열인 link나 객체인 experiment 중 하나가 있어야 합니다';

/** @param {string} field @param {number} least @param {number} most @param {string} found */
export const wholeNumber = (field, least, most, found) =>
  `${field}에 허용되는 값은 ${least} 이상 ${most} 이하의 정수이며, 받은 값은 ${found}입니다`;

/** @param {string} found */
export const threeGains = (found) => `gains는 세 수 kx, ky, kθ여야 하며, 받은 값은 ${found}입니다`;
