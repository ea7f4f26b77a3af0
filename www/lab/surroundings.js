// What around the page changes how it is drawn: its size, the pixels of the screen, the theme, and paper.
import { forgetColours } from '../kit/palette.js';
import { byId, followSize } from '../kit/elements.js';

/** @param {import('../run/actions/actions.js').Actions} actions @param {() => void} show Draws at once. */
export function followSurroundings(actions, show) {
  const redraw = () => {
    forgetColours();
    actions.changeTheme();
    show();
  };
  const plane = byId('plane');
  followSize(plane, (size) => {
    setOnPaper(plane, size);
    actions.setSize(size);
  });
  // At once, because a printer does not wait for the next frame.
  for (const media of ['(prefers-color-scheme: dark)', 'print'])
    matchMedia(media).addEventListener('change', redraw);
  // Not every browser tells the page itself that its media is paper.
  for (const [name, prints] of /** @type {const} */ ([
    ['beforeprint', true],
    ['afterprint', false],
  ]))
    addEventListener(name, () => {
      document.documentElement.toggleAttribute('data-printing', prints);
      // What is not on the screen was not drawn, or long ago.
      for (const picture of document.querySelectorAll('canvas, .picture > svg'))
        picture.toggleAttribute('data-unseen', prints && !picture.checkVisibility());
      redraw();
    });
}

/** On paper, in pixels, it is no wider than the sheet, and leaves room on the first one for what stands above it. */
const paper = { width: 638, height: 420 };

/** All that lies on the plane shrinks with it where it is larger. @param {HTMLElement} plane @param {{ width: number, height: number }} size */
function setOnPaper({ style }, { width, height }) {
  style.setProperty('--own-width', `${width}px`);
  style.setProperty('--own-height', `${height}px`);
  style.setProperty('--on-paper', String(Math.min(1, paper.width / width, paper.height / height)));
}
