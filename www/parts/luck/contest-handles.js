// The lines of the contest that can be moved: by mouse, by finger, and by keys.
import { create, tellValue } from '../../kit/elements.js';
import { arrowOf, isChord } from '../../kit/keyboard.js';
import { pointIn } from '../../kit/map.js';

/**
 * Where a line can be held, in pixels of the chart, and what it then says.
 * @typedef {object} Grip
 * @property {number} x
 * @property {number} y
 * @property {'x' | 'y'} along In which direction it moves.
 * @property {number} from Of the pixels in which it moves, the first.
 * @property {number} to
 * @property {(pixel: number) => number} valueAt
 * @property {readonly [number, number]} range
 * @property {number} value
 * @property {string} text
 */

/** What an arrow moves, in pixels. */
const [step, wideStep] = [3, 24];

/**
 * One line's handle, over the chart.
 * @param {HTMLElement} root @param {string} id @param {string} label @param {(value: number) => void} onMove
 */
export function createHandle(root, id, label, onMove) {
  const attributes = { id, class: 'contest-handle', tabindex: 0, role: 'slider', 'aria-label': label };
  const element = create('div', { ...attributes, hidden: '' });
  root.append(element);
  /** @type {Grip | null} */
  let grip = null;
  const moveTo = (/** @type {number} */ pixel) => {
    if (!grip) return;
    const there = Math.min(Math.max(pixel, grip.from), grip.to);
    // Keys can be quicker than frames.
    grip = { ...grip, [grip.along]: there };
    onMove(grip.valueAt(there));
  };
  const follow = (/** @type {PointerEvent} */ event) => {
    const [x, y] = pointIn(root, event);
    moveTo(grip?.along === 'x' ? x : y);
  };
  let pointer = Number.NaN;
  element.addEventListener('pointerdown', (event) => {
    // Another finger holds nothing that is held.
    if (event.button !== 0 || element.hasPointerCapture(pointer)) return;
    pointer = event.pointerId;
    element.setPointerCapture(pointer);
    event.preventDefault();
    element.focus();
  });
  element.addEventListener('pointermove', (event) => {
    if (event.pointerId === pointer && element.hasPointerCapture(pointer)) follow(event);
  });
  element.addEventListener('keydown', (event) => {
    if (!grip || isChord(event)) return;
    // What grows stands further right, or higher.
    const isAcross = grip.along === 'x';
    const arrow = arrowOf(event.key);
    if (arrow) {
      const by = (event.shiftKey ? wideStep : step) * (arrow[0] + arrow[1]);
      moveTo(isAcross ? grip.x + by : grip.y - by);
    } else if (event.key === 'Home') moveTo(isAcross ? grip.from : grip.to);
    else if (event.key === 'End') moveTo(isAcross ? grip.to : grip.from);
    else return;
    event.preventDefault();
  });
  return {
    follow,
    /** @param {Grip | null} next */
    place(next) {
      grip = next;
      element.hidden = next === null;
      if (!next) return;
      element.style.setProperty('left', `${next.x}px`);
      element.style.setProperty('top', `${next.y}px`);
      element.dataset.along = next.along;
      element.setAttribute('aria-orientation', next.along === 'x' ? 'horizontal' : 'vertical');
      const [least, most] = next.range;
      tellValue(element, Math.min(least, next.value), Math.max(most, next.value), next.value, next.text);
    },
    /** How far a point is from its line, in pixels. @param {readonly [number, number]} point */
    distanceTo: ([x, y]) => (grip ? Math.abs(grip.along === 'x' ? x - grip.x : y - grip.y) : Infinity),
  };
}
