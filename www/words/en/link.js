// Every word about links.
import { beginningOf } from '../../kit/text.js';
import { grouped } from './numbers.js';

/** @param {string} found @param {readonly string[]} parts */
export const unknownPart = (found, parts) =>
  `The link asks for “${found}”, which this page does not have. What it has: ${parts.join(', ')}.`;

/** @param {string} key @param {string} reason */
export const ignored = (key, reason) =>
  `In the link, ${key || 'what has no name'} was left out: ${reason}${/[.…]$/.test(reason) ? '' : '.'}`;

/** @param {string} key @param {string} reason */
export const partlyIgnored = (key, reason) =>
  `In the link, ${key} was used in part: ${reason}${/[.…]$/.test(reason) ? '' : '.'}`;

/** @param {number} count */
export const moreIgnored = (count) =>
  count === 1 ? 'One more entry was left out.' : `${count} more entries were left out.`;

/** @param {string} expected @param {string} found */
export const expected = (expected, found) => `it must be ${expected}, but was “${beginningOf(found)}”.`;

/** @param {string} found @param {number} own */
export const otherVersion = (found, own) =>
  `the link was written by version ${found}, this page reads version ${own}.`;

export const unknownField = 'this page knows no such setting.';
export const noGains = 'it needs gains=kx,ky,kθ beside it.';
export const aPin = 'name~kx,ky,kθ, and after further ~ what its experiment has different';

/** @param {number} most Characters. @param {number} pairs */
export const longLink = (most, pairs) =>
  `The link is longer than ${grouped(most)} characters, or has more than ${grouped(pairs)} keys: the rest of it was left out.`;

export const aNumber = 'a number';
export const aPosture = 'three values x,y,θ, such as 2,2,45deg';
export const threeNumbers = 'three numbers kx,ky,kθ';
/** @param {number} most */
export const gainsUpTo = (most) => `three numbers kx,ky,kθ from 0 to ${most}`;
export const otherGain = 'another gain than on x';

/** @param {number} most */
export const wholeNumber = (most) => `a whole number from 0 to ${most}`;

/** @param {number} most @param {number} length */
export const longTask = (most, length) => `it must have at most ${most} characters, but has ${length}.`;

/** @param {readonly string[]} choices */
export const oneOf = (choices) => `one of ${choices.join(', ')}`;

/** @param {number} most */
export const namesUpTo = (most) => `at most ${most} names`;

/** @param {string} step */
export const noStep = (step) => `The lesson has no step ${step}, so the nearest one is open.`;

/** @param {{ starts: number, drives: number }} most */
export const anAim = (most) =>
  `J<number, parks:k/n with n up to ${most.starts}, or unseen:share up to 1; after ; it may say drives<=number up to ${most.drives}`;

/** @param {{ points: number }} most */
export const aScale = (most) => `value:points,other value:points, with 0 to ${most.points} points`;

export const noAim = 'it needs aim=… beside it.';
export const hiddenPaper = 'the paper’s gains are hidden by the same link.';
export const paperInLesson = 'the lesson tells the paper’s gains, which the same link hides.';

export const notLoaded =
  'The other language cannot be loaded now: there is no network, or one must log in again.';
