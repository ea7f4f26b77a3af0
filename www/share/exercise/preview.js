// What students will see: the page itself, or the very figure that they get in a frame.
import { byId, create } from '../../kit/elements.js';
import { segmentedOf } from '../../kit/fields.js';
import { frames } from '../frame-text.js';
import words from '../words/index.js';

/** A figure is opened anew when nothing has been typed for so many milliseconds. */
const pause = 400;

const choices = [{ value: 'page', text: words.texts.makerPage, size: null }, ...frames];

/** @param {() => void} redraw */
export function createPreview(redraw) {
  const box = create('div', { id: 'maker-preview', class: 'maker-preview', hidden: '' });
  byId('instrument').append(box);
  let chosen = choices[0];
  /** @type {HTMLIFrameElement | null} */
  let frame = null;
  let shown = '';
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let waiting;

  const hide = () => {
    clearTimeout(waiting);
    box.hidden = true;
    box.replaceChildren();
    document.body.removeAttribute('data-preview');
    frame = null;
    shown = '';
  };

  /** @param {string} address */
  const begin = (address) => {
    const attributes = { id: 'maker-figure', title: words.texts.makerPreview, src: address };
    frame = /** @type {HTMLIFrameElement} */ (create('iframe', attributes));
    box.replaceChildren(frame);
    box.hidden = false;
    document.body.toggleAttribute('data-preview', true);
    shown = address;
  };

  return {
    chosen: () => chosen.size,

    choice: () =>
      segmentedOf(
        'maker-preview-size',
        words.texts.makerPreview,
        choices,
        chosen.value,
        (value) => {
          chosen = choices.find((one) => one.value === value) ?? chosen;
          redraw();
        },
        'small maker-sizes',
      ),

    /** @param {string | null} address Of the figure; null: nothing is made now. */
    draw(address) {
      const { size } = chosen;
      if (!size || address === null) {
        if (frame) hide();
        return;
      }
      if (!frame) begin(address);
      if (frame) [frame.width, frame.height] = [String(size[0]), String(size[1])];
      if (address === shown) return;
      shown = address;
      clearTimeout(waiting);
      // In its place, so that "back" leads where it led before.
      waiting = setTimeout(() => frame?.contentWindow?.location.replace(address), pause);
    },
  };
}
