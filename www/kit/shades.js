// The shades of all maps: even to the eye, also in grey and for the colour-blind, and the same in both themes.
import { interpolateCividis } from 'd3-scale-chromatic';

export const shades = 256;

/** Red, green and blue of each shade. */
export const palette = Uint8Array.from({ length: 3 * shades }, (_, i) => {
  const [, ...rgb] =
    /rgb\((\d+), (\d+), (\d+)\)/.exec(interpolateCividis(Math.floor(i / 3) / (shades - 1))) ?? [];
  return Number(rgb[i % 3]);
});

/** The colour of a part of the scale, from 0 to 1. @param {number} part */
export const shadeAt = (part) => interpolateCividis(part);
