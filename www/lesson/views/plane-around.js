// A small plane of its own, which just holds what is to be seen.
import { boxAround } from '../../kit/transform.js';

/** @import { Posture } from '../../core/engine.js' */

/** In the middle of a picture. @param {readonly Posture[]} postures @param {{ width: number, height: number }} size @param {number} margin Pixels at each side. */
export function planeAround(postures, { width, height }, margin) {
  const { left, right, top, bottom } = boxAround(postures);
  const scale = Math.min((width - 2 * margin) / (right - left), (height - 2 * margin) / (top - bottom));
  const originX = width / 2 - (scale * (left + right)) / 2;
  const originY = height / 2 + (scale * (bottom + top)) / 2;
  return {
    /** Pixels a metre. */
    scale,
    originX,
    originY,
    /** In pixels. @param {Posture} posture */
    placeOf: ({ x, y, theta }) => ({ x: originX + x * scale, y: originY - y * scale, theta }),
  };
}
