// The colours of the theme in style.css, read once for all that is drawn with them.

const tokens = [
  ...['paper', 'panel', 'hairline', 'ink', 'muted', 'unreached', 'on-unreached', 'error'],
  ...['x', 'y', 'theta', 'energy', 'omega', 'path', 'final'],
  ...['pin-1', 'pin-2', 'pin-3', 'pin-4'],
].map((name) => `--${name}`);

/** What tells lines in these colours apart where colours do not: their gaps are narrow, so that wide ones are for others. @type {Readonly<Record<string, readonly number[]>>} */
export const dashes = { '--x': [], '--y': [10, 2], '--theta': [4, 2] };

/** How strongly what stands back is drawn. */
export const pale = 0.5;

/** @type {Map<string, string> | null} */
let colours = null;

function readColours() {
  const style = getComputedStyle(document.documentElement);
  const read = new Map(tokens.map((token) => [token, style.getPropertyValue(token).trim()]));
  // No word of the reader's own colours, which a saved picture would not know.
  return read.set('--paper', getComputedStyle(document.body).backgroundColor);
}

/** @param {string} token */
export function colour(token) {
  colours ??= readColours();
  return /** @type {string} */ (colours.get(token));
}

/** To be called when the theme is another one. */
export const forgetColours = () => {
  colours = null;
};
