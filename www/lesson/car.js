// A robot as one sees it from above: a body, two wheels, a nose; and the bay in which it parks.

/** @typedef {{ x: number, y: number, theta: number }} Place In pixels, the heading as in the model. */

/** @param {CanvasRenderingContext2D} context @param {Place} place @param {number} size Half its length. @param {{ body: string, wheel: string, nose: string }} colours */
export function drawCar(context, { x, y, theta }, size, { body, wheel, nose }) {
  context.save();
  context.translate(x, y);
  context.rotate(-theta);
  context.fillStyle = wheel;
  for (const side of [-1, 1])
    context.fillRect(-0.5 * size, side * 0.86 * size - 0.16 * size, size, 0.32 * size);
  context.fillStyle = body;
  context.beginPath();
  context.roundRect(-size, -0.7 * size, 2 * size, 1.4 * size, 0.45 * size);
  context.fill();
  context.fillStyle = nose;
  context.beginPath();
  context.moveTo(0.78 * size, 0);
  context.lineTo(0.2 * size, 0.42 * size);
  context.lineTo(0.2 * size, -0.42 * size);
  context.fill();
  context.restore();
}

/** Open at the rear. @param {CanvasRenderingContext2D} context @param {Place} place @param {number} size @param {string} colour */
export function drawBay(context, { x, y, theta }, size, colour) {
  context.save();
  context.translate(x, y);
  context.rotate(-theta);
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
