// How numbers are written in Korean.
import { beginningOf } from '../../kit/text.js';
import { costTextWith, fixed, groupedBy, isUnsure } from '../numbers.js';

export * from '../numbers.js';

/** Groups of three digits. */
export const grouped = groupedBy(',');

/** J. */
export const costText = costTextWith(grouped);

/** How long it took. @param {number} milliseconds */
export const tookText = (milliseconds) =>
  milliseconds < 1000 ? `${fixed(milliseconds, 0)} ms` : `${fixed(milliseconds / 1000, 1)}초`;

/** What was typed and is no number, or none that can be. @param {string} text */
export const wasText = (text) =>
  `입력값: “${beginningOf(text)}”.${isUnsure(text) ? ' 세 자리 앞의 쉼표는 천 단위로도 읽힙니다. 점을 쓰거나 쉼표를 빼십시오.' : ''}`;
