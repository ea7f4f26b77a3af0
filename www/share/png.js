// A drawing as a PNG file, twice as dense as CSS pixels or more, with texts inside that say what made it.
/** @import { About, Drawing } from './marks.js' */
import { svgOf } from './svg.js';
import words from './words/index.js';

const pixelsPerMetre = 96 / 0.0254;
/** The signature and the header chunk. */
const beginning = 8 + 25;

/** @param {Drawing} drawing @param {About} about @returns {Promise<Blob>} */
export async function pngOf(drawing, about) {
  const { title, description, link, version } = about;
  const density = Math.max(2, globalThis.devicePixelRatio || 1);
  const canvas = await painted(svgOf(drawing, about), drawing, density);
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

/** What the SVG file shows, as the browser draws it. @param {string} svg @param {Drawing} drawing @param {number} density */
async function painted(svg, { width, height }, density) {
  const canvas = document.createElement('canvas');
  [canvas.width, canvas.height] = [width * density, height * density];
  const image = new Image(canvas.width, canvas.height);
  // Of a Blob, browsers let no page on a disk read what was drawn.
  image.src = `data:image/svg+xml,${encodeURIComponent(svg)}`;
  await image.decode();
  canvas.getContext('2d')?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas;
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
