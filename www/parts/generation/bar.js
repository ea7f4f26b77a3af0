// A number with its sign as a bar beside 0, as large as it is beside the largest.
import { html } from 'lit-html';

const width = 84;
const height = 40;
const middle = width / 2;
const reach = middle - 4;

/** @param {number} part From −1 to 1. */
export function bar(part) {
  const long = Math.max(-1, Math.min(1, Number.isFinite(part) ? part : 0)) * reach;
  return html`
    <svg class="bell bar-of" viewBox="0 0 ${width} ${height}" aria-hidden="true">
      <path class="base" d="M${middle} 6V34" />
      <rect x=${Math.min(middle, middle + long)} y="12" width=${Math.abs(long)} height="16" />
    </svg>`;
}
