// What the line plots share: their size, colours, axes and the names at their lines.
import { textFont } from './fonts.js';
import { colour } from './palette.js';

/** @typedef {import('uplot')} uPlot */
/** @typedef {import('uplot').Axis} Axis */

export const wholeSteps = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];
const labelHeight = 17;

/** @param {HTMLElement} root */
export const sizeOf = (root) => ({
  width: Math.max(120, root.clientWidth),
  height: Math.max(100, root.clientHeight),
});

/** Where a plot is narrower, the names of its lines stand within it. */
const roomForNames = 300;
const gutter = 100;

/** @param {uPlot} plot */
export const isNarrow = (plot) => plot.width < roomForNames;

/** The room for names beside the lines. @param {uPlot} plot */
export const gutterOf = (plot) => (isNarrow(plot) ? 10 : gutter);

/** Puts a name at the end of its line, or above that at the edge of a narrow plot. @param {uPlot} plot @param {HTMLElement} element @param {number} x @param {number} y */
export function placeName(plot, element, x, y) {
  element.style.transform = isNarrow(plot)
    ? `translate(${plot.over.clientWidth}px, ${Math.max(y, labelHeight)}px) translate(-100%, -100%)`
    : `translate(${x}px, ${y}px) translateY(-50%)`;
}

/** @returns {Axis} */
export const axis = () => ({
  stroke: () => colour('--muted'),
  font: textFont,
  grid: { stroke: () => colour('--hairline'), width: 1 },
  ticks: { show: false },
  gap: 6,
});

/** As many digits as the step needs, at every tick. @param {uPlot} _ @param {number[]} ticks */
export function sameDigits(_, ticks) {
  const step = ticks.length > 1 ? ticks[1] - ticks[0] : 1;
  if (step >= 1000) return ticks.map((tick) => (tick === 0 ? '0' : `${tick / 1000}k`));
  const digits =
    [0, 1, 2, 3, 4, 5].find(
      (count) => Math.abs(step * 10 ** count - Math.round(step * 10 ** count)) < 1e-6,
    ) ?? 6;
  return ticks.map((tick) => tick.toFixed(digits));
}

/** The name of a line, which is placed where the line ends. @param {string} name @param {string} text */
export function lineLabel(name, text) {
  const element = document.createElement('span');
  element.className = `line-label ${name}`;
  element.textContent = text;
  return element;
}

/**
 * Moves labels apart that would lie on each other, as little up as down, and keeps them inside.
 * @param {{ y: number }[]} places @param {number} height
 */
export function spread(places, height) {
  const sorted = [...places].sort((a, b) => a.y - b.y);
  const wanted = sorted.map(({ y }) => y);
  for (let i = 1; i < sorted.length; i += 1) sorted[i].y = Math.max(wanted[i], sorted[i - 1].y + labelHeight);
  const pushed = sorted.reduce((sum, { y }, i) => sum + y - wanted[i], 0) / sorted.length;
  const up = Math.min(pushed, sorted[0].y);
  const over = Math.max(0, sorted[sorted.length - 1].y - up - height);
  for (const place of sorted) place.y -= up + over;
}
