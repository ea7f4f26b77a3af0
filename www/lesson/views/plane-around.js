// A small plane of its own, which just holds what is to be seen.
import { boxAround, middleOf, viewAt } from '../../kit/transform.js';

/** @import { Posture } from '../../core/engine.js' */

/** In the middle of a picture. @param {readonly Posture[]} postures @param {{ width: number, height: number }} size @param {number} margin Pixels at each side. */
export function planeAround(postures, { width, height }, margin) {
  const box = boxAround(postures);
  const [across, up] = [box.right - box.left, box.top - box.bottom];
  const scale = Math.min((width - 2 * margin) / across, (height - 2 * margin) / up);
  const view = viewAt(middleOf(box), scale, width / 2, height / 2);
  return {
    ...view,
    /** In pixels. @param {Posture} posture */
    placeOf: ({ x, y, theta }) => ({ x: view.screenX(x), y: view.screenY(y), theta }),
  };
}
