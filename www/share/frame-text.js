// What is on screen, as a frame for another page.
/** @import { State } from '../run/state.js' */
import { addressOf } from '../kit/host.js';
import { sizes } from '../embed/frame.js';
import { frameText } from '../embed/frame-line.js';
import { stepNames } from '../lesson/path.js';
import { named } from '../parts/parts.js';
import { lesson as lessonWords } from '../words/index.js';
import words from './words/index.js';

/** The sizes that are offered, as choices. */
export const frames = sizes.map((size) => ({
  value: size.join('x'),
  text: words.sizeText(size[0], size[1]),
  size,
}));

export const isOnDisk = () => location.protocol === 'file:';

/** As it stands in what is handed on: a path on this disk is none on another, and is nobody's business. @param {string} link @param {boolean} [embed] */
export function handedAddress(link, embed = false) {
  const address = addressOf(location.href, link, embed);
  return isOnDisk() ? address.slice(address.split(/[?#]/)[0].lastIndexOf('/') + 1) : address;
}

/** @param {State} state @param {string} link @param {readonly [width: number, height: number]} size */
export function frameOf({ page, lesson }, link, [width, height] = sizes[1]) {
  const part = lesson > 0 ? lessonWords.titles[stepNames[lesson - 1]] : named[page].name;
  return frameText({
    address: handedAddress(link, true),
    title: words.frameTitle(part),
    width,
    height,
  });
}
