// How large elements are: on the screen, and on paper, where what is wider than the sheet is drawn anew, for its letters to be read.

/** @typedef {{ width: number, height: number }} Size */

/** In pixels, as the styles of paper have it. */
const sheetWidth = 640;

let isOnPaper = false;

/** What is followed, as long as anybody else holds it: a step of the lesson makes its pictures anew at every visit. @type {Set<WeakRef<HTMLElement>>} */
const followed = new Set();
/** @type {WeakMap<HTMLElement, { look: () => void, tell: () => void, measure: () => void }>} */
const followers = new WeakMap();

/** As wide as the sheet at most, in its own shape. @param {Size} size */
function shrink({ width, height }) {
  const scale = Math.min(1, sheetWidth / width);
  return { width: Math.floor(width * scale), height: Math.floor(height * scale) };
}

/** The size of an element in pixels, kept up to date. @param {HTMLElement} element @param {(size: Size) => void} onResize @param {(size: Size) => Size} [onPaper] How large it is there. */
export function followSize(element, onResize, onPaper = shrink) {
  let seen = { width: 0, height: 0 };
  let size = seen;
  let density = devicePixelRatio;
  const tell = () => {
    size = isOnPaper ? onPaper(seen) : seen;
    onResize(size);
  };
  const measure = () => {
    seen = { width: element.clientWidth, height: element.clientHeight };
    density = devicePixelRatio;
    tell();
  };
  // In the next frame: what is drawn now might change a size that is being told.
  new ResizeObserver(() => requestAnimationFrame(measure)).observe(element);
  const look = () => {
    if (density !== devicePixelRatio) measure();
  };
  followers.set(element, { look, tell, measure });
  followed.add(new WeakRef(element));
  return () => size;
}

/**
 * How many pixels of the screen an element covers across and down, where the browser tells them: its edges may lie between two, and a
 * picture of one more or less is blurred. None on paper, where a canvas is as high as its pixels make it.
 * @param {Element} element @param {() => void} onChange
 */
export function followPixels(element, onChange) {
  let pixels = [0, 0];
  if ('devicePixelContentBoxSize' in (globalThis.ResizeObserverEntry?.prototype ?? {}))
    new ResizeObserver(([entry]) => {
      const [{ inlineSize, blockSize }] = entry.devicePixelContentBoxSize;
      pixels = [inlineSize, blockSize];
      // In the next frame, as above.
      requestAnimationFrame(onChange);
    }).observe(element, { box: 'device-pixel-content-box' });
  return () => (isOnPaper ? [0, 0] : pixels);
}

/** @param {'look' | 'tell' | 'measure'} what */
function each(what) {
  for (const held of followed) {
    const element = held.deref();
    if (element) followers.get(element)?.[what]();
    else followed.delete(held);
  }
}

// Another density of pixels comes without another size.
globalThis.addEventListener?.('resize', () => each('look'));

/** @type {((prints: boolean) => void)[]} */
const hearers = [];

/** @param {(prints: boolean) => void} hear Whether sizes are those of paper, at each change. */
export const hearOfPaper = (hear) => hearers.push(hear);

/** From now on sizes are those of paper, or of the screen again. @param {boolean} prints */
export function setOnPaper(prints) {
  if (prints === isOnPaper) return;
  isOnPaper = prints;
  for (const hear of hearers) hear(prints);
  each('tell');
}

/** At once: a frame may be narrower on the paper of the page around it. */
export const measureAnew = () => each('measure');
