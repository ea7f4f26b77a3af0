// Start and goal in the hand: transparent buttons over the plane, for pointer, touch and keyboard.
/** @import { Posture } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
import { create, tellValue } from '../kit/elements.js';
import { keepInside, knobOf } from '../kit/transform.js';
import { arrowOf } from '../kit/keyboard.js';
import { watch } from '../kit/memo.js';
import { lab as strings } from '../words/index.js';

/** @typedef {'start' | 'goal'} End */
/** @typedef {'position' | 'heading'} Part */
/** @typedef {{ view: View, start: Posture, goal: Posture }} HandlesModel */
/**
 * @typedef {object} HandleEvents
 * @property {(end: End) => Posture} postureOf The newest, which may not be drawn yet.
 * @property {(end: End, posture: Posture, dragging: boolean) => void} onMove
 * @property {() => void} onRelease
 */

const turn = Math.PI / 36;
const fineTurn = Math.PI / 180;
/** Pixels within which a press trembles and moves nothing. */
const slop = 2;
/** Metres, as the core has it. */
const farthest = 1000;

/** @param {HTMLElement} root @param {HandleEvents} events */
export function createHandles(root, events) {
  /** @type {HandlesModel | null} */
  let model = null;
  const changed = watch();
  const handles = /** @type {const} */ (['start', 'goal']).flatMap((end) =>
    /** @type {const} */ (['position', 'heading']).map((part) =>
      createHandle(end, part, () => model?.view, events),
    ),
  );
  root.replaceChildren(...handles.map(({ button }) => button));
  return {
    /** @param {HandlesModel} next */
    draw(next) {
      model = next;
      if (!changed(next.view, next.start, next.goal)) return;
      for (const handle of handles) handle.draw(next);
    },
  };
}

/** @param {End} end @param {Part} part @param {() => View | undefined} current @param {HandleEvents} events */
function createHandle(end, part, current, events) {
  const name = end === 'start' ? strings.startName : strings.goalName;
  const isHeading = part === 'heading';
  const label = isHeading ? strings.headingLabel(name) : strings.positionLabel(name);
  const attributes = { id: `${end}-${part}`, class: `handle ${part}`, type: 'button', 'aria-label': label };
  // Nothing is pressed here, and of what is no button the arrow keys reach the page.
  const button = create('button', { ...attributes, role: 'slider' });
  drag(button, end, part, current, events);

  // A key that is held is one gesture, like a drag.
  let isKeyHeld = false;
  const letGo = () => {
    if (isKeyHeld) events.onRelease();
    isKeyHeld = false;
  };
  button.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey) return;
    const posture = events.postureOf(end);
    const moved = isHeading ? turnedByKey(posture, event) : movedByKey(posture, event);
    if (!moved) return;
    event.preventDefault();
    isKeyHeld = true;
    events.onMove(end, tidy(moved, posture), true);
  });
  button.addEventListener('keyup', (event) => {
    if (event.key.startsWith('Arrow')) letGo();
  });
  button.addEventListener('blur', letGo);

  return {
    button,
    /** @param {HandlesModel} model */
    draw(model) {
      const posture = model[end];
      const { px, py } = isHeading
        ? knobOf(model.view, posture)
        : { px: model.view.screenX(posture.x), py: model.view.screenY(posture.y) };
      button.style.transform = `translate(${px}px, ${py}px) translate(-50%, -50%)`;
      const { x, theta } = posture;
      if (isHeading) tellValue(button, -180, 180, (theta * 180) / Math.PI, strings.degrees(theta));
      else tellValue(button, -farthest, farthest, x, strings.postureText(posture));
    },
  };
}

/** @param {HTMLElement} button @param {End} end @param {Part} part @param {() => View | undefined} current @param {HandleEvents} events */
function drag(button, end, part, current, events) {
  /** @type {{ pointerId: number, before: Posture, x: number, y: number, isFar: boolean, offsetX: number, offsetY: number } | null} */
  let held = null;
  /** @type {Posture | null} */
  let pending = null;

  /** The other part may be in another hand. */
  const apply = () => {
    const now = events.postureOf(end);
    if (pending)
      events.onMove(
        end,
        part === 'heading' ? { ...now, theta: pending.theta } : { ...pending, theta: now.theta },
        true,
      );
    pending = null;
  };

  button.addEventListener('pointerdown', (event) => {
    if (held || event.button !== 0) return;
    const box = button.getBoundingClientRect();
    held = {
      pointerId: event.pointerId,
      before: events.postureOf(end),
      x: event.clientX,
      y: event.clientY,
      isFar: false,
      offsetX: event.clientX - (box.left + box.width / 2),
      offsetY: event.clientY - (box.top + box.height / 2),
    };
    button.setPointerCapture(event.pointerId);
  });

  button.addEventListener('pointermove', (event) => {
    const view = current();
    const plane = button.offsetParent;
    if (!held || !view || !plane || event.pointerId !== held.pointerId) return;
    // It was lifted where the page has not seen it.
    if (event.buttons === 0) return lose();
    held.isFar ||= Math.hypot(event.clientX - held.x, event.clientY - held.y) > slop;
    if (!held.isFar) return;
    const { left, top } = plane.getBoundingClientRect();
    const px = event.clientX - held.offsetX - left - plane.clientLeft;
    const py = event.clientY - held.offsetY - top - plane.clientTop;
    const posture = events.postureOf(end);
    if (!pending) requestAnimationFrame(apply);
    const moved = part === 'heading' ? turnedTo : movedTo;
    pending = tidy(moved(view, posture, px, py), posture);
  });

  const letGo = () => {
    held = null;
    apply();
    events.onRelease();
  };
  /** What was moved stays there, and a run that took its place is left alone. */
  const lose = () => {
    held = null;
    pending = null;
    events.onRelease();
  };
  const takeBack = () => {
    if (!held) return;
    pending = held.before;
    letGo();
  };
  button.addEventListener('pointerup', ({ pointerId }) => {
    if (pointerId === held?.pointerId) letGo();
  });
  button.addEventListener('pointercancel', ({ pointerId }) => {
    if (pointerId === held?.pointerId) takeBack();
  });
  // Where the handle was taken out of the page, only the document hears of it.
  document.addEventListener('lostpointercapture', ({ pointerId }) => {
    if (pointerId === held?.pointerId) lose();
  });
  const onKey = (/** @type {KeyboardEvent} */ event) => {
    if (event.key !== 'Escape' || !held) return;
    event.preventDefault();
    takeBack();
  };
  // Not every browser gives a button the focus that is pressed; and before others ask what Escape is for.
  addEventListener('keydown', onKey, { capture: true });
}

/** @param {View} view @param {Posture} posture @param {number} px @param {number} py @returns {Posture} */
function movedTo(view, posture, px, py) {
  const inside = keepInside(view, px, py);
  return { ...posture, ...view.world(inside.px, inside.py) };
}

/** @param {View} view @param {Posture} posture @param {number} px @param {number} py @returns {Posture} */
function turnedTo(view, posture, px, py) {
  const [dx, dy] = [px - view.screenX(posture.x), view.screenY(posture.y) - py];
  return Math.hypot(dx, dy) < 4 ? posture : { ...posture, theta: Math.atan2(dy, dx) };
}

/** @param {Posture} posture @param {KeyboardEvent} event @returns {Posture | null} */
function movedByKey(posture, event) {
  const arrow = arrowOf(event.key);
  if (!arrow) return null;
  const [right, up] = arrow;
  if (event.shiftKey) return right ? { ...posture, theta: posture.theta - right * turn } : null;
  const step = event.altKey ? 0.01 : 0.1;
  return { ...posture, x: posture.x + right * step, y: posture.y + up * step };
}

/** @param {Posture} posture @param {KeyboardEvent} event @returns {Posture | null} */
function turnedByKey(posture, event) {
  const arrow = arrowOf(event.key);
  if (!arrow) return null;
  const left = arrow[1] - arrow[0];
  return { ...posture, theta: posture.theta + left * (event.altKey ? fineTurn : turn) };
}

/** Whole centimetres and degrees in what was moved, so that the numbers in the text are the numbers that drive. @param {Posture} posture @param {Posture} before @returns {Posture} */
function tidy({ x, y, theta }, before) {
  const turns = Math.round((theta * 180) / Math.PI);
  const wrapped = turns - 360 * Math.ceil((turns - 180) / 360);
  return {
    x: x === before.x ? x : Math.round(x * 100) / 100,
    y: y === before.y ? y : Math.round(y * 100) / 100,
    theta: theta === before.theta ? theta : (wrapped * Math.PI) / 180,
  };
}
