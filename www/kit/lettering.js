// How texts look on a canvas, and where they stand beside their points. The fonts are those of --sans in style.css, at the size of plots.
import { colour } from './palette.js';

const family =
  'system-ui, "Apple SD Gothic Neo", "Malgun Gothic", "Noto Sans KR", "Noto Sans CJK KR", sans-serif';

export const textFont = `13px ${family}`;
export const strongFont = `600 13px ${family}`;
/** As letters stand in formulas. @param {number} size */
export const italicFont = (size) => `italic ${size}px "STIX Two Text", "Cambria Math", Georgia, serif`;
export const symbolFont = italicFont(17);

/** Of all texts that follow. @param {CanvasRenderingContext2D} context @param {{ token?: string, font?: string, align?: CanvasTextAlign, baseline?: CanvasTextBaseline }} look */
export function setLettering(
  context,
  { token = '--muted', font = textFont, align = 'left', baseline = 'middle' },
) {
  context.fillStyle = colour(token);
  context.font = font;
  context.textAlign = align;
  context.textBaseline = baseline;
}
