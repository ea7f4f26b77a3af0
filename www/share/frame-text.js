// The part of the dialog that writes what is on screen as a frame for another page.
import { byId } from '../kit/elements.js';
import { copy } from '../kit/copy.js';
import { createSegmented } from '../kit/segmented.js';
import { embed as words, lab, lesson as lessonWords } from '../words/index.js';
import { addressOf } from '../kit/host.js';
import { frameText, sizes } from '../embed/frame.js';
import { stepNames } from '../lesson/path.js';

/** @typedef {import('../run/state.js').State} State */

const isOnDisk = () => location.protocol === 'file:';

/** The frame of what is on screen. @param {State} state @param {string} link @param {readonly [width: number, height: number]} size */
export function frameOf({ page, lesson }, link, [width, height] = sizes[1]) {
  const part = lesson > 0 ? lessonWords.titles[stepNames[lesson - 1]] : lab.pages[page];
  const address = addressOf(location.href, link, true);
  return frameText({
    // A path on this disk is none on another.
    address: isOnDisk() ? address.slice(address.split('?')[0].lastIndexOf('/') + 1) : address,
    title: words.frameTitle(part),
    width,
    height,
  });
}

/** @param {() => State} stateOf @param {() => string} linkNow */
export function createEmbedDialog(stateOf, linkNow) {
  /** @type {HTMLTextAreaElement} */
  const field = byId('embed-text');
  const named = sizes.map(([width, height]) => ({ value: `${width}x${height}`, width, height }));
  let chosen = named[1];

  const choice = createSegmented(
    byId('embed-size'),
    words.sizeLegend,
    named.map(({ value, width, height }) => ({ value, text: words.sizeText(width, height) })),
    (value) => {
      chosen = named.find((one) => one.value === value) ?? chosen;
      draw();
    },
  );

  const draw = () => {
    choice.draw(chosen.value);
    field.value = frameOf(stateOf(), linkNow(), [chosen.width, chosen.height]);
    byId('embed-disk').hidden = !isOnDisk();
  };

  field.addEventListener('focus', () => field.select());
  byId('embed-copy').addEventListener('click', () => copy(field, byId('keep-status'), words));
  return { draw };
}
