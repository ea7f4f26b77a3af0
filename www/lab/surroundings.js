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
  followSize(plane, actions.setSize);
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
