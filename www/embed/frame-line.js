// The line that puts a figure into another page, apart from what every figure loads.
import { escaped } from '../kit/markup.js';

/** What a frame lets a figure do that a page of another origin may not: fill the screen, and, as Chromium wants it said, copy. */
export const allowed = 'fullscreen; clipboard-write';

/** The iframe, to be pasted into a page. @param {{ address: string, title: string, width: number, height: number }} frame */
export const frameText = ({ address, title, width, height }) =>
  `<iframe src="${escaped(address)}" title="${escaped(title)}" width="${width}" height="${height}" style="border: 0; max-width: 100%" loading="lazy" allow="${allowed}"></iframe>`;
