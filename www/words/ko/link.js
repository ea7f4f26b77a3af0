// Every word about links, in Korean.
import { beginningOf } from '../../kit/text.js';
import { grouped } from './numbers.js';

/** @param {string} found @param {readonly string[]} parts */
export const unknownPart = (found, parts) =>
  `링크의 “${found}” 부분은 이 페이지에 없습니다. 있는 부분: ${parts.join(', ')}.`;

/** @param {string} key @param {string} reason */
export const ignored = (key, reason) =>
  `링크의 ${key || '이름 없는'} 항목은 쓰지 않았습니다. ${reason.replace(`${key}: `, '')}`;

/** @param {string} key @param {string} reason */
export const partlyIgnored = (key, reason) =>
  `링크의 ${key} 항목은 일부만 썼습니다. ${reason.replace(`${key}: `, '')}`;

/** @param {number} count */
export const moreIgnored = (count) => `그 밖에 ${count}개 항목도 제외했습니다.`;

/** @param {string} expected @param {string} found */
export const expected = (expected, found) =>
  `필요한 형식은 ${expected}, 적힌 값은 “${beginningOf(found)}”입니다.`;

/** @param {string} found @param {number} own */
export const otherVersion = (found, own) => `링크의 버전은 ${found}, 이 페이지가 읽는 버전은 ${own}입니다.`;

export const unknownField = '이 페이지에 없는 설정입니다.';
export const noGains = 'gains=kx,ky,kθ 항목이 함께 있어야 합니다.';
export const aPin = '이름~kx,ky,kθ와, ~ 뒤에 이어지는 다른 실험 설정';

/** @param {number} most Characters. @param {number} pairs */
export const longLink = (most, pairs) =>
  `링크가 ${grouped(most)}자보다 길거나 키가 ${grouped(pairs)}개보다 많습니다. 나머지는 읽지 않았습니다.`;

export const aNumber = '수';
export const aPosture = '2,2,45deg와 같은 세 값 x,y,θ';
export const threeNumbers = '세 수 kx,ky,kθ';
/** @param {number} most */
export const gainsUpTo = (most) => `0부터 ${most}까지의 세 수 kx,ky,kθ`;
export const otherGain = 'x에 적힌 것과 다른 이득';

/** @param {number} most */
export const wholeNumber = (most) => `0 이상 ${most} 이하의 정수`;

/** @param {number} most @param {number} length */
export const longTask = (most, length) => `${most}자 이하여야 하는데 ${length}자입니다.`;

/** @param {readonly string[]} choices */
export const oneOf = (choices) => `다음 가운데 하나(${choices.join(', ')})`;

/** @param {number} most */
export const namesUpTo = (most) => `이름 ${most}개 이하`;

/** @param {string} step */
export const noStep = (step) => `수업에 ${step} 단계가 없어 가장 가까운 단계를 열었습니다.`;

/** @param {{ starts: number, drives: number }} most */
export const anAim = (most) =>
  `J<수, parks:k/n(n은 ${most.starts} 이하), unseen:비율(1 이하) 가운데 하나, 필요하면 그 뒤에 ;drives<=수(${most.drives} 이하)`;

/** @param {{ points: number }} most */
export const aScale = (most) => `값:점수,다른 값:점수(점수는 0 이상 ${most.points} 이하)`;

export const noAim = 'aim=… 항목이 함께 있어야 합니다.';
export const hiddenPaper = '같은 링크가 논문의 이득을 숨깁니다.';
export const paperInLesson = '수업에는 같은 링크가 숨긴 논문의 이득이 나옵니다.';

export const notLoaded =
  '지금은 다른 언어를 불러올 수 없습니다. 네트워크에 연결되어 있지 않거나 다시 로그인해야 합니다.';
