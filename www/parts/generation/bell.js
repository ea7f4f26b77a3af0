// Where a draw around a gain is likely to land, as a small picture: the density of N(k, σ²), or of Cauchy's distribution, and on it
// what was drawn. As wide as σ is beside the widest of the three gains: they have one scale.
/** @import { Experiment } from '../../core/engine.js' */
import { html, nothing, svg } from 'lit-html';
import words from './words/index.js';

/** @typedef {Experiment['evolution']['step']} Step */
/** How far the widest picture reaches, in σ, and the density with 1 at its top. @typedef {{ reach: number, density: (draw: number) => number }} Shape */

const width = 84;
const height = 40;
const middle = width / 2;
const base = height - 6;
/** What stands for the gain beside its mark needs so much room. */
const named = 22;

/** @type {Readonly<Record<Step, Shape>>} */
export const shapes = {
  gaussian: { reach: 3.3, density: (draw) => Math.exp(-0.5 * draw * draw) },
  cauchy: { reach: 10, density: (draw) => 1 / (1 + draw * draw) },
};

/** How wide a σ is beside the widest; where none is above 0, what is drawn stays where it is. @param {readonly number[]} sigmas @param {number} i */
export function shareOf(sigmas, i) {
  const widest = Math.max(...sigmas);
  if (widest === 0) return 0;
  return widest < Infinity ? sigmas[i] / widest : 1;
}

const yIn = (/** @type {Shape} */ { density }, /** @type {number} */ draw) =>
  base - (base - 4) * density(draw);

/** @param {Shape} shape @param {number} share */
const outlineOf = (shape, share) =>
  Array.from({ length: 45 }, (_, i) => {
    const part = i / 22 - 1;
    return `${(middle * (1 + share * part)).toFixed(1)} ${yIn(shape, shape.reach * part).toFixed(1)}`;
  }).join('L');

/** @param {number | null} draw In σ; null: nothing has been drawn yet, or nobody knows what. @param {Step} [step] @param {number} [share] Of the width of the picture. */
export function bell(draw, step = 'gaussian', share = 1) {
  const shape = shapes[step];
  const part = draw === null ? 0 : (share * draw) / shape.reach;
  return html`
  <svg class="bell" viewBox="0 0 ${width} ${height}" aria-hidden="true">
    <path class="density" d="M${outlineOf(shape, share)}" /><path class="base" d="M0 ${base}H${width}M${middle} ${base}v4" />
    ${draw === null ? nothing : Math.abs(part) > 1 ? beyond(draw) : drawn(middle * (1 + part), yIn(shape, draw))}
  </svg>`;
}

/** @param {number} x @param {number} y */
function drawn(x, y) {
  const isRight = x < middle ? x < named : x < width - named;
  return svg`
    <path class="draw" d="M${x} ${base}V${Math.min(y, base - 8)}" />
    <circle class="drawn" cx=${x} cy=${base} r="3.5" />
    <text x=${isRight ? x + 7 : x - 7} y=${base - 3} text-anchor=${isRight ? 'start' : 'end'}>${words.newGain}</text>`;
}

/** A tip at the edge, for what lies further out. @param {number} draw */
const beyond = (draw) =>
  svg`<path class="drawn" d=${draw > 0 ? `M${width} ${base}l-8 -5v10z` : `M0 ${base}l8 -5v10z`} />`;

/** A number with its sign as a bar beside 0, as large as it is beside the largest. @param {number} part From −1 to 1. */
export function bar(part) {
  const long = Math.max(-1, Math.min(1, Number.isFinite(part) ? part : 0)) * (middle - 4);
  return html`
    <svg class="bell bar-of" viewBox="0 0 ${width} ${height}" aria-hidden="true">
      <path class="base" d="M${middle} 6V34" />
      <rect x=${Math.min(middle, middle + long)} y="12" width=${Math.abs(long)} height="16" />
    </svg>`;
}
