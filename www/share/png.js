// A drawing as a PNG file, twice as dense as CSS pixels or more, with texts inside that say what made it.
/** @import { About, Drawing, Mark, Paint } from './marks.js' */
import { isGradient } from './marks.js';
import { cssFont } from './screen.js';
import words from './words/index.js';

const pixelsPerMetre = 96 / 0.0254;
/** The signature and the header chunk. */
const beginning = 8 + 25;

/** @param {Drawing} drawing @param {About} about @returns {Promise<Blob>} */
export async function pngOf(drawing, { title, description, link, version }) {
  const density = Math.max(2, globalThis.devicePixelRatio || 1);
  const canvas = painted(drawing, density);
  if (!isReadable(canvas, drawing.paper)) throw new Error(words.unreadable);
  const blob = await new Promise((resolve) => canvas.toBlob(resolve));
  if (!blob) throw new Error(`${canvas.width} × ${canvas.height}`);
  const bytes = new Uint8Array(await blob.arrayBuffer());
  const texts = Object.entries({ Title: title, Description: description, Software: version, Source: link });
  return new Blob(
    [
      bytes.slice(0, beginning),
      physicalSize(density * pixelsPerMetre),
      ...texts.map(([keyword, text]) => chunk('iTXt', utf8(`${keyword}\0\0\0\0\0${text}`))),
      bytes.slice(beginning),
    ],
    { type: 'image/png' },
  );
}

/** Some browsers give pages noise in the place of what they have drawn: the corner, which is paper, tells. @param {HTMLCanvasElement} canvas @param {string} paper */
function isReadable(canvas, paper) {
  const wanted = /^rgba?\(([\d, ]+)/.exec(paper)?.[1].split(',').map(Number) ?? [];
  const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(0, 0, 8, 1);
  return data.every((value, i) => i % 4 === 3 || Math.abs(value - (wanted[i % 4] ?? value)) <= 2);
}

/** @param {Drawing} drawing @param {number} density */
function painted({ width, height, paper, marks }, density) {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width * density, height * density];
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.fillStyle = paper;
  context.fillRect(0, 0, canvas.width, canvas.height);
  const dense = new DOMMatrix().scale(density);
  for (const mark of marks) {
    context.save();
    for (const { d, matrix } of mark.clips) {
      context.setTransform(dense.multiply(matrix));
      context.clip(new Path2D(d));
    }
    context.setTransform(dense.multiply(mark.matrix));
    paint(context, mark);
    context.restore();
  }
  return canvas;
}

/** @param {CanvasRenderingContext2D} context @param {Mark} mark */
function paint(context, mark) {
  const { fill, stroke, alpha } = mark;
  context.globalAlpha = alpha;
  if (fill) context.fillStyle = styleOf(context, fill);
  if (stroke) {
    context.strokeStyle = styleOf(context, stroke.paint);
    context.lineWidth = stroke.width;
    context.lineCap = /** @type {CanvasLineCap} */ (stroke.cap);
    context.lineJoin = /** @type {CanvasLineJoin} */ (stroke.join);
    context.setLineDash(stroke.dash);
  }
  if (mark.kind === 'image') {
    context.imageSmoothingEnabled = mark.smooth;
    context.drawImage(mark.source, ...mark.box);
  } else if (mark.kind === 'shape') {
    const path = new Path2D(mark.d);
    if (fill) context.fill(path);
    if (stroke) context.stroke(path);
  } else {
    context.font = cssFont(mark.font);
    context.textAlign = mark.anchor === 'middle' ? 'center' : mark.anchor;
    if (stroke) context.strokeText(mark.text, mark.x, mark.y);
    if (fill) context.fillText(mark.text, mark.x, mark.y);
  }
}

/** @param {CanvasRenderingContext2D} context @param {Paint} paint */
function styleOf(context, paint) {
  if (typeof paint === 'string') return paint;
  if (isGradient(paint)) {
    const { from, to, stops } = paint;
    const gradient = context.createLinearGradient(...from, ...to);
    for (const [offset, colour] of stops) gradient.addColorStop(offset, colour);
    return gradient;
  }
  const { tile, scale } = paint;
  const pattern = /** @type {CanvasPattern} */ (context.createPattern(tile, 'repeat'));
  pattern.setTransform(new DOMMatrix().scale(scale));
  return pattern;
}

const utf8 = (/** @type {string} */ text) => new TextEncoder().encode(text);

/** So that it is as large in print as on the screen. @param {number} perMetre */
function physicalSize(perMetre) {
  const data = new DataView(new ArrayBuffer(9));
  data.setUint32(0, Math.round(perMetre));
  data.setUint32(4, Math.round(perMetre));
  data.setUint8(8, 1);
  return chunk('pHYs', new Uint8Array(data.buffer));
}

/** @param {string} type @param {Uint8Array} data */
function chunk(type, data) {
  const bytes = new Uint8Array(12 + data.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set(utf8(type), 4);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, crc32(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

/** @param {Uint8Array} bytes */
function crc32(bytes) {
  let crc = -1;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit += 1) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}
