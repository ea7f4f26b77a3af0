// The density of N(0, 1), or of Cauchy's distribution, as a small picture, with the draw on it.
/** @import { Experiment } from '../../core/engine.js' */
import { html, nothing, svg } from 'lit-html';

/** @typedef {Experiment['evolution']['step']} Step */
/** How far the picture reaches, and the density with 1 at its top. @typedef {{ reach: number, density: (draw: number) => number }} Shape */

const width = 84;
const height = 40;
const base = height - 6;

/** @type {Readonly<Record<Step, Shape>>} */
export const shapes = {
  gaussian: { reach: 3.3, density: (draw) => Math.exp(-0.5 * draw * draw) },
  cauchy: { reach: 10, density: (draw) => 1 / (1 + draw * draw) },
};

const xIn = (/** @type {Shape} */ { reach }, /** @type {number} */ draw) =>
  ((Math.max(-reach, Math.min(reach, draw)) + reach) / (2 * reach)) * width;
const yIn = (/** @type {Shape} */ { density }, /** @type {number} */ draw) =>
  base - (base - 4) * density(draw);

const outlineOf = (/** @type {Shape} */ shape) =>
  Array.from({ length: 45 }, (_, i) => {
    const draw = shape.reach * (i / 22 - 1);
    return `${xIn(shape, draw).toFixed(1)} ${yIn(shape, draw).toFixed(1)}`;
  }).join('L');
const outlines = { gaussian: outlineOf(shapes.gaussian), cauchy: outlineOf(shapes.cauchy) };

/** @param {number | null} draw Null: nothing has been drawn yet, or nobody knows what. @param {Step} [step] */
export const bell = (draw, step = 'gaussian') => html`
  <svg class="bell" viewBox="0 0 ${width} ${height}" aria-hidden="true">
    <path class="density" d="M${outlines[step]}" /><path class="base" d="M0 ${base}H${width}M${width / 2} ${base}v4" />
    ${draw === null ? nothing : Math.abs(draw) > shapes[step].reach ? beyond(draw) : drawn(shapes[step], draw)}
  </svg>`;

/** @param {Shape} shape @param {number} draw */
function drawn(shape, draw) {
  const x = xIn(shape, draw);
  return svg`
    <path class="draw" d="M${x} ${base}V${Math.min(yIn(shape, draw), base - 8)}" />
    <circle class="drawn" cx=${x} cy=${base} r="3.5" />`;
}

/** A tip at the edge, for what lies further out. @param {number} draw */
const beyond = (draw) =>
  svg`<path class="drawn" d=${draw > 0 ? `M${width} ${base}l-8 -5v10z` : `M0 ${base}l8 -5v10z`} />`;
