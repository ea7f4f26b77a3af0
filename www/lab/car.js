// A robot as one sees it from above: a body, two wheels, a nose; and the bay in which it parks.

/** @typedef {{ x: number, y: number, theta: number }} Place In pixels, the heading as in the model. */

/** The body, half as long as one: its corners are cut off. */
const outline = /** @type {const} */ ([
  [-1, -0.35],
  [-0.75, -0.6],
  [0.6, -0.6],
  [1, -0.25],
  [1, 0.25],
  [0.6, 0.6],
  [-0.75, 0.6],
  [-1, 0.35],
]);

/** The same in one outline, two wheels, a body and its nose, as SVG writes it; the nose is cut out. @param {number} size Half its length. */
export function carOutline(size) {
  const path = (/** @type {readonly (readonly [number, number])[]} */ points) =>
    `M${points.map(([ahead, right]) => `${(ahead * size).toFixed(2)} ${(right * size).toFixed(2)}`).join('L')}Z`;
  const wheel = (/** @type {number} */ side) =>
    path([
      [-0.5, side - 0.17],
      [0.5, side - 0.17],
      [0.5, side + 0.17],
      [-0.5, side + 0.17],
    ]);
  // Round the other way than the body.
  const nose = path([
    [0.78, 0],
    [0.2, -0.42],
    [0.2, 0.42],
  ]);
  return wheel(-0.88) + wheel(0.88) + path(outline) + nose;
}

/** From here everything is in pixels ahead of it and to its right. @param {CanvasRenderingContext2D} context @param {Place} place */
function placeAt(context, { x, y, theta }) {
  const [c, s] = [Math.cos(theta), Math.sin(theta)];
  context.transform(c, -s, s, c, x, y);
}

/** @param {CanvasRenderingContext2D} context @param {Place} place @param {number} size Half its length. @param {{ body: string, wheel: string, nose: string, edge?: string }} colours */
export function drawCar(context, place, size, { body, wheel, nose, edge }) {
  context.save();
  placeAt(context, place);
  context.fillStyle = wheel;
  for (const side of [-1, 1])
    context.fillRect(-0.5 * size, side * 0.88 * size - 0.17 * size, size, 0.34 * size);
  context.fillStyle = body;
  context.beginPath();
  context.moveTo(outline[0][0] * size, outline[0][1] * size);
  for (const [ahead, right] of outline.slice(1)) context.lineTo(ahead * size, right * size);
  context.closePath();
  context.fill();
  if (edge) {
    context.strokeStyle = edge;
    context.lineWidth = 1.5;
    context.stroke();
  }
  context.fillStyle = nose;
  context.beginPath();
  context.moveTo(0.78 * size, 0);
  context.lineTo(0.2 * size, 0.42 * size);
  context.lineTo(0.2 * size, -0.42 * size);
  context.fill();
  context.restore();
}

/** Open at the rear. @param {CanvasRenderingContext2D} context @param {Place} place @param {number} size @param {string} colour */
export function drawBay(context, place, size, colour) {
  context.save();
  placeAt(context, place);
  context.strokeStyle = colour;
  context.lineWidth = 2;
  context.beginPath();
  context.moveTo(-1.5 * size, -1.3 * size);
  context.lineTo(1.5 * size, -1.3 * size);
  context.lineTo(1.5 * size, 1.3 * size);
  context.lineTo(-1.5 * size, 1.3 * size);
  context.stroke();
  context.restore();
}
