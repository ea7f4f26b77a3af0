// Pictures as they were saved: what is in them, and how far they are from what is on the screen.
import assert from 'node:assert/strict';
import { crc32 } from 'node:zlib';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** What a button saves, and under which name. @param {Page} page @param {string} label @returns {Promise<{ name: string, type: string, bytes: Buffer }>} */
export async function saved(page, label) {
  const { name, type, url } = await page.evaluate(async (button) => {
    const { createObjectURL } = URL;
    const { click } = HTMLAnchorElement.prototype;
    /** @type {Blob} */
    let blob = new Blob();
    URL.createObjectURL = (object) => {
      blob = /** @type {Blob} */ (object);
      return createObjectURL(object);
    };
    /** @type {string} */
    const download = await new Promise((resolve) => {
      // WebKit's test browser would open a list of downloads, which makes the page narrower.
      HTMLAnchorElement.prototype.click = function () {
        resolve(this.download);
      };
      /** @type {HTMLElement} */ (document.querySelector(`#keep-pictures [aria-label="${button}"]`)).click();
    });
    URL.createObjectURL = createObjectURL;
    HTMLAnchorElement.prototype.click = click;
    /** @type {string} */
    const data = await new Promise((resolve) => {
      const reader = new FileReader();
      reader.onload = () => resolve(String(reader.result));
      reader.readAsDataURL(blob);
    });
    return { name: download, type: blob.type, url: data };
  }, label);
  return { name, type, bytes: Buffer.from(url.slice(url.indexOf(',') + 1), 'base64') };
}

/** The texts in a PNG, and its size; throws if a chunk is damaged. @param {Buffer} png */
export function readPng(png) {
  assert.equal(png.subarray(0, 8).toString('latin1'), '\x89PNG\r\n\x1a\n');
  /** @type {Record<string, string>} */
  const texts = {};
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    const type = png.toString('latin1', at + 4, at + 8);
    const data = png.subarray(at + 8, at + 8 + length);
    assert.equal(png.readUInt32BE(at + 8 + length), crc32(png.subarray(at + 4, at + 8 + length)), type);
    if (type === 'iTXt') {
      const [keyword, text] = data.toString('utf8').split('\0\0\0\0\0');
      texts[keyword] = text;
    }
    at += 12 + length;
  }
  return { width: png.readUInt32BE(16), height: png.readUInt32BE(20), texts };
}

/** Where a picture is on the screen. @param {Page} page @param {string} key */
export const placeOf = (page, key) =>
  page.evaluate((name) => {
    const boxes = [...document.querySelectorAll(`[data-picture="${name}"]`)].map((one) =>
      one.getBoundingClientRect(),
    );
    const seen = boxes.filter(({ width, height }) => width > 0 && height > 0);
    return {
      left: Math.min(...seen.map(({ left }) => left)),
      top: Math.min(...seen.map(({ top }) => top)),
      right: Math.max(...seen.map(({ right }) => right)),
      bottom: Math.max(...seen.map(({ bottom }) => bottom)),
    };
  }, key);

/** How far two pictures differ, from 0 to 255 at a pixel on average, and how much of the first is not blank. @param {Page} page @param {string} first @param {string} second Their addresses. @param {{ x: number, y: number }} offset Where the first one's corner is in the second. @param {number} density Of the first. @param {number} secondDensity */
export const difference = (page, first, second, offset, density, secondDensity) =>
  page.evaluate(
    async (one, other, { x, y }, dense, otherDense) => {
      const [image, screen] = await Promise.all(
        [one, other].map(async (src) => {
          const loaded = new Image();
          loaded.src = src;
          await loaded.decode();
          return loaded;
        }),
      );
      const [width, height] = [image.naturalWidth / dense, image.naturalHeight / dense];
      const pixels = [image, screen].map((source, i) => {
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [width, height];
        const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
        context.imageSmoothingQuality = 'high';
        if (i === 0) context.drawImage(source, 0, 0, width, height);
        else
          context.drawImage(
            source,
            -x,
            -y,
            source.naturalWidth / otherDense,
            source.naturalHeight / otherDense,
          );
        return context.getImageData(0, 0, width, height).data;
      });
      let [sum, marked] = [0, 0];
      for (let i = 0; i < pixels[0].length; i += 4) {
        const [a, b] = pixels;
        sum += (Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2])) / 3;
        if (a[i] !== a[0] || a[i + 1] !== a[1] || a[i + 2] !== a[2]) marked += 1;
      }
      const count = pixels[0].length / 4;
      return { mean: sum / count, marked: marked / count };
    },
    first,
    second,
    offset,
    density,
    secondDensity,
  );

/** Whether programs other than browsers show an SVG as it is meant, and nothing in it asks for a mouse. @param {string} text */
export function isPlain(text) {
  assert.doesNotMatch(text, /paint-order| href=/);
  // A stroke that lies on its letters would hide them.
  for (const [tag] of text.matchAll(/<text [^>]* stroke="[^>]*>/g)) assert.match(tag, / fill="none"/);
  for (const [tag, png] of text.matchAll(/<image [^>]*"pixelated"[^>]*base64,([^"]*)"/g))
    assert.ok(
      Buffer.from(png, 'base64').readUInt32BE(16) >= 400,
      `it will be smoothed: ${tag.slice(0, 200)}`,
    );
  assert.doesNotMatch(text, />[^<]*(?:Drag|Press|Tap|Click)\b/);
}

/** What is in an SVG, read as the browser reads it. @param {Page} page @param {string} text */
export const readSvg = (page, text) =>
  page.evaluate((source) => {
    const svg = new DOMParser().parseFromString(source, 'image/svg+xml');
    const all = [...svg.querySelectorAll('*')];
    const texts = (/** @type {string} */ name) =>
      [...svg.getElementsByTagName(name)].map((one) => one.textContent);
    const addresses = all.flatMap((one) => [one.getAttribute('href'), one.getAttribute('xlink:href')]);
    return {
      error: svg.querySelector('parsererror')?.textContent ?? null,
      names: all.map(({ localName }) => localName),
      texts: texts('text'),
      title: texts('title')[0],
      description: texts('desc')[0],
      creator: texts('dc:creator')[0],
      link: texts('dc:source')[0],
      outside: addresses.filter((one) => one !== null && !one.startsWith('data:image/png')),
    };
  }, text);
