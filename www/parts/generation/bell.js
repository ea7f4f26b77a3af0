// The density of N(0, 1) as a small picture, with the draw on it.
import { html, nothing, svg } from 'lit-html';

const width = 84;
const height = 40;
const base = height - 6;
const reach = 3.3;

const x = (/** @type {number} */ draw) =>
  ((Math.max(-reach, Math.min(reach, draw)) + reach) / (2 * reach)) * width;
const y = (/** @type {number} */ draw) => base - (base - 4) * Math.exp(-0.5 * draw * draw);

const outline = Array.from({ length: 45 }, (_, i) => {
  const draw = -reach + (2 * reach * i) / 44;
  return `${x(draw).toFixed(1)} ${y(draw).toFixed(1)}`;
}).join('L');

/** @param {number | null} draw Null: nothing has been drawn yet. */
export const bell = (draw) => html`
  <svg class="bell" viewBox="0 0 ${width} ${height}" aria-hidden="true">
    <path class="density" d="M${outline}" /><path class="base" d="M0 ${base}H${width}M${width / 2} ${base}v4" />
    ${draw === null ? nothing : drawn(draw)}
  </svg>`;

/** @param {number} draw */
const drawn = (draw) => svg`
  <path class="draw" d="M${x(draw)} ${base}V${Math.min(y(draw), base - 8)}" />
  <circle class="drawn" cx=${x(draw)} cy=${base} r="3.5" />`;
