// The one transform between the plane in metres and a picture in pixels.

/** @typedef {{ x: number, y: number }} Point Metres. */
/** @typedef {{ left: number, right: number, bottom: number, top: number }} Box Metres. */
/** @typedef {ReturnType<typeof createView>} View */

/** From a posture to the knob that turns it, in pixels: as it is where there is room, and at least so far that it stands before the arrow. */
const knobDistance = { usual: 52, least: 26 };
/** What is seen of a knob, in pixels from its centre, and some paper. */
const knobMargin = 8;
const smallestSpan = 0.8;

/** The pixels that start and goal keep free at each edge, so that no handle lies under a note or outside. @param {{ width: number, height: number }} size */
function insets({ width, height }) {
  const side = width < 560 ? { left: 64, right: 56 } : { left: 96, right: 88 };
  if (height < 170) return { ...side, top: knobDistance.least + knobMargin, bottom: 36 };
  if (height < 280) return { ...side, top: 44, bottom: 40 };
  return height < 440 ? { ...side, top: 96, bottom: 64 } : { ...side, top: 96, bottom: 104 };
}

/** @param {readonly Point[]} points @returns {Box} */
export function boxAround(points) {
  const span = (/** @type {number[]} */ values) => {
    const middle = (Math.min(...values) + Math.max(...values)) / 2;
    const half = Math.max(smallestSpan, Math.max(...values) - Math.min(...values)) / 2;
    return [middle - half, middle + half];
  };
  const [left, right] = span(points.map(({ x }) => x));
  const [bottom, top] = span(points.map(({ y }) => y));
  return { left, right, bottom, top };
}

/** With a centre at a place of the picture. @param {Point} centre @param {number} scale Pixels a metre. @param {number} [px] @param {number} [py] Pixels. */
export function viewAt({ x, y }, scale, px = 0, py = 0) {
  const originX = px - x * scale;
  const originY = py + y * scale;
  return {
    /** Pixels a metre. */
    scale,
    originX,
    originY,
    /** @param {number} x */
    screenX: (x) => originX + x * scale,
    /** @param {number} y */
    screenY: (y) => originY - y * scale,
    /** @param {number} px @param {number} py */
    world: (px, py) => ({ x: (px - originX) / scale, y: (originY - py) / scale }),
  };
}

/** All within a radius, in metres. @param {Point} centre @param {number} radius @param {{ width: number, height: number }} size */
export const viewAround = (centre, radius, { width, height }) =>
  viewAt(centre, Math.min(width, height) / (2 * radius), width / 2, height / 2);

/** @param {Box} box @returns {Point} */
export const middleOf = ({ left, right, bottom, top }) => ({ x: (left + right) / 2, y: (bottom + top) / 2 });

/** @param {Box} box @param {{ width: number, height: number }} size */
export function createView(box, { width, height }) {
  const inset = insets({ width, height });
  const free = {
    width: Math.max(40, width - inset.left - inset.right),
    height: Math.max(40, height - inset.top - inset.bottom),
  };
  const scale = Math.min(free.width / (box.right - box.left), free.height / (box.top - box.bottom));
  const middle = [inset.left + free.width / 2, inset.top + free.height / 2];
  return { width, height, inset, ...viewAt(middleOf(box), scale, ...middle) };
}

/**
 * The box around these points: the old one while they lie well inside it and fill it, else a new one.
 * @param {Box} box @param {{ width: number, height: number }} size @param {readonly Point[]} points
 */
export function refit(box, size, points) {
  const view = createView(box, size);
  const next = boxAround(points);
  const outside = points.some(({ x, y }) => {
    const [px, py] = [view.screenX(x), view.screenY(y)];
    return (
      px < view.inset.left - 1 ||
      px > size.width - view.inset.right + 1 ||
      py < view.inset.top - 1 ||
      py > size.height - view.inset.bottom + 1
    );
  });
  return outside || createView(next, size).scale > 1.6 * view.scale ? next : box;
}

/**
 * Where the knob that turns a posture is drawn: straight ahead of it, nearer where the plane ends before. Only of a posture that is
 * just being moved to the edge it may lie outside.
 * @param {View} view @param {Point & { theta: number }} posture
 */
export function knobOf({ width, height, screenX, screenY }, { x, y, theta }) {
  const [ahead, down] = [Math.cos(theta), -Math.sin(theta)];
  const [px, py] = [screenX(x), screenY(y)];
  const room = Math.min(roomAhead(px, ahead, width), roomAhead(py, down, height));
  const distance = Math.max(knobDistance.least, Math.min(knobDistance.usual, room));
  return { px: px + distance * ahead, py: py + distance * down };
}

/** How far one may go until the plane ends on this axis. @param {number} from @param {number} step A pixel of the way, on this axis. @param {number} end */
const roomAhead = (from, step, end) =>
  step === 0 ? Number.POSITIVE_INFINITY : ((step > 0 ? end - knobMargin : knobMargin) - from) / step;

/** @param {{ width: number, height: number }} size @param {number} px @param {number} py */
export function keepInside({ width, height }, px, py) {
  const margin = 16;
  return {
    px: Math.min(Math.max(px, margin), width - margin),
    py: Math.min(Math.max(py, margin), height - margin),
  };
}
