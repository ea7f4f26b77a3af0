// Which pixels differ between two folders of pictures.
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import pixelmatch from 'pixelmatch';
import { PNG } from 'pngjs';

/** @typedef {{ name: string, said: string }} Difference */

const gap = 16;

/** A picture on a larger sheet, whose rest is transparent. @param {PNG} picture @param {number} width @param {number} height */
function onSheet(picture, width, height) {
  const sheet = new PNG({ width, height });
  PNG.bitblt(picture, sheet, 0, 0, picture.width, picture.height, 0, 0);
  return sheet;
}

/** Around all pixels that are not transparent. @param {PNG} mask */
function boxOf({ width, height, data }) {
  let [left, top, right, bottom] = [width, height, -1, -1];
  for (let y = 0; y < height; y += 1)
    for (let x = 0; x < width; x += 1)
      if (data[4 * (y * width + x) + 3] > 0) {
        left = Math.min(left, x);
        right = Math.max(right, x);
        top = Math.min(top, y);
        bottom = y;
      }
  return { left, top, right, bottom };
}

/**
 * What differs, in words, and before, after and the differences beside each other; null if nothing does.
 * @param {Buffer} before @param {Buffer} after
 */
function differenceOf(before, after) {
  if (before.equals(after)) return null;
  const [one, other] = [before, after].map((content) => PNG.sync.read(content));
  const width = Math.max(one.width, other.width);
  const height = Math.max(one.height, other.height);
  const [a, b] = [one, other].map((picture) => onSheet(picture, width, height));
  const mask = new PNG({ width, height });
  const options = { threshold: 0.02, includeAA: true, diffMask: true };
  const count = pixelmatch(a.data, b.data, mask.data, width, height, options);
  const isOtherSize = one.width !== other.width || one.height !== other.height;
  if (count === 0 && !isOtherSize) return null;
  const { left, top, right, bottom } = boxOf(mask);
  const marked = new PNG({ width, height });
  pixelmatch(a.data, b.data, marked.data, width, height, { ...options, diffMask: false, alpha: 0.15 });
  const sheet = new PNG({ width: 3 * width + 2 * gap, height });
  for (const [i, picture] of [a, b, marked].entries())
    PNG.bitblt(picture, sheet, 0, 0, width, height, i * (width + gap), 0);
  const sizes = isOtherSize ? `, ${one.width} × ${one.height} became ${other.width} × ${other.height}` : '';
  return {
    said: `${count} pixels from (${left}, ${top}) to (${right}, ${bottom})${sizes}`,
    sheet: PNG.sync.write(sheet),
  };
}

/**
 * Compares all pictures of two folders and writes a sheet for each that differs.
 * @param {string} before @param {string} after @param {string} output
 * @returns {{ same: number, differences: Difference[] }}
 */
export function compareFolders(before, after, output) {
  const [old, young] = [before, after].map((folder) =>
    readdirSync(folder).filter((name) => name.endsWith('.png')),
  );
  const names = [...new Set([...old, ...young])].sort();
  /** @type {Difference[]} */
  const differences = [];
  for (const name of names) {
    const [one, other] = [join(before, name), join(after, name)];
    if (!existsSync(one) || !existsSync(other)) {
      differences.push({ name, said: existsSync(one) ? 'only before' : 'only after' });
      continue;
    }
    const found = differenceOf(readFileSync(one), readFileSync(other));
    if (!found) continue;
    mkdirSync(output, { recursive: true });
    writeFileSync(join(output, name), found.sheet);
    differences.push({ name, said: found.said });
  }
  return { same: names.length - differences.length, differences };
}
