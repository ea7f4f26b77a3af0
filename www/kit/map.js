// Maps: shades on a grid, names on them, and a cursor for pointer and keys.
/** @import { Frame } from './chart.js' */
import { fillTextWithHalo } from './canvas.js';
import { isSideways, mayScroll } from './finger.js';
import { take } from './chart.js';
import { strongFont } from './lettering.js';
import { arrowOf, isChord } from './keyboard.js';
import { palette, shades } from './shades.js';
import { once } from './memo.js';

/** What is drawn on shades: the same in both themes, as they are. */
export const [dark, light] = ['#14161a', '#ffffff'];

const cellsOf = once(() => document.createElement('canvas'));

/**
 * A square of shades, the first row at the bottom; nothing where a part is NaN.
 * @param {CanvasRenderingContext2D} context @param {ArrayLike<number>} parts From 0 to 1, row by row. @param {Frame} frame Its edges. @param {boolean} smooth
 */
export function drawShades(context, parts, { left, right, top, bottom }, smooth) {
  const count = Math.sqrt(parts.length);
  const image = new ImageData(count, count);
  for (let cell = 0; cell < parts.length; cell += 1) {
    if (Number.isNaN(parts[cell])) continue;
    const at = 4 * ((count - 1 - Math.floor(cell / count)) * count + (cell % count));
    const shade = Math.round(parts[cell] * (shades - 1));
    image.data.set(palette.subarray(3 * shade, 3 * shade + 3), at);
    image.data[at + 3] = 255;
  }
  const cells = cellsOf();
  [cells.width, cells.height] = [count, count];
  cells.getContext('2d')?.putImageData(image, 0, 0);
  context.imageSmoothingEnabled = smooth;
  context.drawImage(cells, left, top, right - left, bottom - top);
}

/** A hairline around it. @param {CanvasRenderingContext2D} context @param {Frame} frame */
export function drawFrame(context, { left, right, top, bottom }) {
  take(context, { token: '--hairline', width: 1 });
  context.strokeRect(left - 0.5, top - 0.5, right - left + 1, bottom - top + 1);
}

/** A name beside a point, on its left where the map ends. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {string} name @param {number} x @param {number} y @param {number} gap */
export function nameBeside(context, frame, name, x, y, gap) {
  context.font = strongFont;
  const onLeft = x + gap + 3 + context.measureText(name).width > frame.right;
  context.textAlign = onLeft ? 'right' : 'left';
  context.textBaseline = 'middle';
  fillTextWithHalo(context, name, x + (onLeft ? -gap : gap), y, { fill: light, halo: dark, width: 4 });
}

/** Where a pointer is in an element, in pixels. @param {HTMLElement} element @param {MouseEvent} event @returns {[x: number, y: number]} */
export function pointIn(element, { clientX, clientY }) {
  const { left, top } = element.getBoundingClientRect();
  return [clientX - left, clientY - top];
}

/** While a pointer is held on an element. @param {HTMLElement} element @param {(event: PointerEvent) => void} onHeld @param {() => void} [onRelease] */
export function followHeld(element, onHeld, onRelease) {
  let held = false;
  /** @type {number | null} */
  let pointer = null;
  /** A finger that may yet scroll the page. @type {PointerEvent | null} */
  let waiting = null;
  const hold = (/** @type {PointerEvent} */ event) => {
    held = true;
    waiting = null;
    onHeld(event);
  };
  element.addEventListener('pointerdown', (event) => {
    // A palm beside the pen, or another hand.
    const isTaken = held && pointer !== null && element.hasPointerCapture(pointer);
    if (event.button !== 0 || isTaken) return;
    pointer = event.pointerId;
    element.setPointerCapture(pointer);
    if (mayScroll(element, event)) waiting = event;
    else hold(event);
  });
  element.addEventListener('pointermove', (event) => {
    if (event.pointerId !== pointer) return;
    if (held || (waiting && isSideways(waiting, event))) hold(event);
  });
  element.addEventListener('pointerup', (event) => {
    if (waiting && event.pointerId === pointer) hold(event);
  });
  // Lost is what another element takes, or a browser.
  for (const end of /** @type {const} */ (['pointerup', 'pointercancel', 'lostpointercapture']))
    element.addEventListener(end, (event) => {
      if (event.pointerId !== pointer) return;
      if (held) onRelease?.();
      pointer = null;
      held = false;
      waiting = null;
    });
  return () => held;
}

/** What one points at with nothing held; null: nothing any more. @param {HTMLElement} element @param {(event: PointerEvent | null) => void} onPoint @param {() => boolean} [isHeld] */
export function followPointing(element, onPoint, isHeld = () => false) {
  element.addEventListener('pointermove', (event) => {
    if (!isHeld() && event.pointerType !== 'touch') onPoint(event);
  });
  element.addEventListener('pointerleave', () => {
    if (!isHeld()) onPoint(null);
  });
  element.addEventListener('blur', () => onPoint(null));
}

/** How far right one points, with the mouse over a picture, or with a finger or the mouse that drags on it. @param {HTMLElement} element @param {(px: number) => void} onPoint */
export function followPointer(element, onPoint) {
  const point = (/** @type {PointerEvent | null} */ event) => {
    if (event) onPoint(pointIn(element, event)[0]);
  };
  followPointing(element, point, followHeld(element, point));
}

/**
 * What keys do with a cursor.
 * @param {HTMLElement} element
 * @param {{ onStep: (step: readonly [right: number, up: number], isWide: boolean) => void, onEnter?: () => void, onEscape: () => boolean }} on `onEscape`: whether there was anything to take back; else Escape is for others.
 */
export function followKeys(element, { onStep, onEnter, onEscape }) {
  element.addEventListener('keydown', (event) => {
    if (isChord(event)) return;
    const step = arrowOf(event.key);
    if (step) onStep(step, event.shiftKey);
    else if (event.key === 'Escape') {
      if (!onEscape()) return;
    } else if (onEnter && (event.key === 'Enter' || event.key === ' ')) onEnter();
    else return;
    event.preventDefault();
  });
}
