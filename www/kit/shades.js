// The shades of all maps, cividis: even to the eye, also in grey and for the colour-blind, and the same in both themes.

export const shades = 256;

/** Red, green and blue as polynomials of the part, by Jamie R. Nuñez and others, 2018, as d3-scale-chromatic has them. */
const channels = [
  [-4.54, -35.34, 2381.73, -6402.7, 7024.72, -2710.57],
  [32.49, 170.73, 52.82, -131.46, 176.58, -67.37],
  [81.24, 442.36, -2482.43, 6167.24, -6614.94, 2475.67],
];

/** @param {number} part From 0 to 1. */
function cividis(part) {
  const t = Math.max(0, Math.min(1, part));
  return channels.map((terms) => {
    const value = terms.reduceRight((sum, term) => sum * t + term, 0);
    return Math.max(0, Math.min(255, Math.round(value)));
  });
}

/** Red, green and blue of each shade. */
export const palette = Uint8Array.from(
  Array.from({ length: shades }, (_, i) => cividis(i / (shades - 1))).flat(),
);

/** The colour of a part of the scale. @param {number} part From 0 to 1. */
export const shadeAt = (part) => `rgb(${cividis(part).join(', ')})`;
