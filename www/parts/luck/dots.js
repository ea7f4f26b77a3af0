// One dot a seed: where dots stand that would lie on each other, which of them is meant, and how they are drawn.
import { circle, strokeTwice } from '../../kit/canvas.js';
import { colour } from '../../kit/palette.js';

/** Pixels along the axis, and away from it. @typedef {{ along: Float64Array, away: Float64Array }} Dots */

/** The more dots, the smaller. @param {number} count */
export const diameterOf = (count) => (count <= 30 ? 8 : count <= 150 ? 5 : 3);

/**
 * Dots beside each other along an axis, stacked where they would lie on each other; they overlap only when the highest
 * stack has no room.
 * @param {readonly number[]} positions Pixels along the axis. @param {number} diameter @param {number} room Pixels away from it.
 * @returns {Dots}
 */
export function stackDots(positions, diameter, room) {
  const bins = positions.map((position) => Math.round(position / diameter));
  /** @type {Map<number, number>} */
  const heights = new Map();
  const levels = bins.map((bin) => {
    const level = heights.get(bin) ?? 0;
    heights.set(bin, level + 1);
    return level;
  });
  const highest = Math.max(1, ...heights.values()) - 1;
  const step = Math.min(diameter, (room - diameter) / Math.max(1, highest));
  return {
    along: Float64Array.from(bins, (bin) => bin * diameter),
    away: Float64Array.from(levels, (level) => diameter / 2 + level * step),
  };
}

/**
 * The dot nearest to a point, or −1 if none is near.
 * @param {Dots} dots @param {number} along @param {number} away
 */
export function nearestDot({ along: alongs, away: aways }, along, away) {
  let nearest = -1;
  let distance = 12;
  for (let i = 0; i < alongs.length; i += 1) {
    const own = Math.hypot(alongs[i] - along, aways[i] - away);
    if (own < distance) [nearest, distance] = [i, own];
  }
  return nearest;
}

/** @param {CanvasRenderingContext2D} context @param {Dots} dots @param {number} diameter @param {string} token @param {(along: number, away: number) => [number, number]} place */
export function drawDots(context, { along, away }, diameter, token, place) {
  context.fillStyle = colour(token);
  // Overlapping dots show where there are many.
  context.globalAlpha = 0.6;
  for (let i = 0; i < along.length; i += 1) {
    circle(context, ...place(along[i], away[i]), Math.max(1, diameter / 2 - 0.5));
    context.fill();
  }
  context.globalAlpha = 1;
}

/** Marks the seed in question. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y */
export function drawRing(context, x, y) {
  circle(context, x, y, 5.5);
  strokeTwice(context, [colour('--paper'), 5], [colour('--ink'), 2]);
}
