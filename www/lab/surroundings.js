// What around the page changes how it is drawn: its size, the pixels of the screen, the theme, and paper.
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { State } from '../run/state.js' */
import { forgetColours } from '../kit/palette.js';
import { byId, isSeen } from '../kit/elements.js';
import { isEmbedded } from '../kit/host.js';
import { followSize, measureAnew, setOnPaper } from '../kit/size.js';

/** The plane on paper, in pixels, within its border: what stands above it has room on the first sheet. */
const most = { width: 638, height: 420 };

/** @param {Actions} actions @param {() => void} show Draws at once. */
export function followSurroundings(actions, show) {
  const redraw = () => {
    forgetColours();
    actions.changeTheme();
    show();
  };
  const plane = byId('plane');
  const measured = (/** @type {State['size']} */ size) => {
    plane.style.setProperty('--own-width', `${size.width}px`);
    plane.style.setProperty('--own-height', `${size.height}px`);
    actions.setSize(size);
  };
  followSize(plane, measured, ({ width, height }) => ({
    width: Math.min(width, most.width),
    height: Math.min(height, most.height),
  }));
  // At once, because a printer does not wait for the next frame.
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redraw);
  const turn = (/** @type {boolean} */ prints) => {
    if (isEmbedded) measureAnew();
    else setOnPaper(prints);
    redraw();
  };
  matchMedia('print').addEventListener('change', ({ matches }) => turn(matches));
  // Not every browser tells the page itself that its media is paper.
  for (const [name, prints] of /** @type {const} */ ([
    ['beforeprint', true],
    ['afterprint', false],
  ]))
    addEventListener(name, () => {
      document.documentElement.toggleAttribute('data-printing', prints);
      // What is not on the screen was not drawn, or long ago; a figure shows on paper what it shows there.
      for (const picture of document.querySelectorAll('canvas, .picture > svg'))
        picture.toggleAttribute('data-unseen', prints && !isEmbedded && !isSeen(picture));
      turn(prints);
    });
}
