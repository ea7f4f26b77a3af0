// What there is once something has been tried: the curve over generations, the comparison, and the way between both ends of it.
/** @import { Triple } from '../../../core/engine.js' */
/** @import { Bred } from '../state.js' */
/** @import { Model } from '../sight.js' */
import './style.css';
import { html, nothing, svg } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { styled, valueIn } from '../../../kit/templates.js';
import { lab } from '../../../words/index.js';
import { isDone } from '../breeding.js';
import { areBeyond } from '../state.js';
import { mineOf } from './walk.js';
import park from '../words/index.js';
import words from './words/index.js';

/** @param {Model} model @param {Bred} found */
export const ending = (model, found) =>
  words.ending(
    model,
    found,
    isDone(model.bred, model.count),
    model.best !== null && areBeyond(model.best.gains, model.endsBefore),
  );

/** That a slider goes further now, if it does. @param {Model} model @param {Bred} found */
export function beyond({ best, ends, endsBefore, isFree }, found) {
  const [, ky] = found.gains;
  const isFar = isFree && ky > endsBefore[1] && found.parked > (best?.parked ?? 0);
  return isFar ? ` ${words.beyond(endsBefore[1], ky, ends[1])}` : '';
}

/** @param {number} share */
const percentOf = (share) => Math.round(100 * share);

/** Who drives on the way. @param {{ share: number }} between */
export const walked = ({ share }) => words.walked(percentOf(share));

/** Whose the sliders are, and whose the marks on them. @param {Model} model */
export const key = ({ between }) =>
  html`<p class="park-key row muted not-in-figure not-on-paper"><span aria-hidden="true">○</span> ${words.sliders} <span class="park-mark" aria-hidden="true"></span> ${words.marks(between !== null)}</p>`;

/** On the track of a slider: the gain that evolution has, or that drives in between. @param {number} value @param {number} most */
export function mark(value, most) {
  const at = Math.min(1, Math.max(0, value / most));
  return html`<span class="park-track not-on-paper" aria-hidden="true"><span class=${`park-mark ${value > most ? 'is-beyond' : ''}`} ${styled('--at', String(at))}></span></span>
    <span class="park-found" aria-hidden="true">${value > most ? `${words.gain(value)} →` : words.gain(value)}</span>`;
}

/** How many the best robot of each generation parked. @param {Model} model */
export function climb({ bred, best, count }) {
  const [width, height] = [300, 64];
  const x = (/** @type {number} */ generation) => (generation / Math.max(20, bred.length - 1)) * width;
  const y = (/** @type {number} */ parked) => height - (parked / count) * height;
  const line = bred.map(({ generation, parked }) => `${x(generation)},${y(parked)}`).join(' ');
  const name = words.climb(/** @type {Bred} */ (bred.at(-1)));
  return html`<figure class="park-climb not-in-small-figure">
    <div class="park-climb-axis column not-in-figure" aria-hidden="true"><span>${words.climbAxis(count)}</span><span>0</span></div>
    <div class="park-climb-plot not-in-figure">
      <svg viewBox="0 -2 ${width} ${height + 4}" preserveAspectRatio="none" role="img" aria-label=${best ? `${name} · ${words.yoursParked(best.parked)}` : name}>
        <path d="M0 0H${width}M0 ${height}H${width}"></path>
        ${best ? svg`<path class="park-yours" d="M0 ${y(best.parked)}H${width}"></path>` : nothing}
        <polyline points=${line}></polyline>
      </svg>
      ${best ? html`<span class="park-yours-name" aria-hidden="true" ${styled('--at', String(best.parked / count))}>${words.yoursParked(best.parked)}</span>` : nothing}
    </div>
    <figcaption class="muted">${name}</figcaption>
  </figure>`;
}

/** @param {Model} model @param {Bred} found @param {(share: number) => void} onWalk */
export function comparison(model, found, onWalk) {
  const { best, count } = model;
  const row = (
    /** @type {string} */ name,
    /** @type {Triple} */ triple,
    /** @type {number | null} */ parked,
  ) =>
    html`<tr><th scope="row">${name}</th>${triple.map((gain, i) => html`<td class=${lab.gains[i].id}>${words.gain(gain)}</td>`)}<td>${parked === null ? '–' : words.share(parked, count)}</td></tr>`;
  return html`<table class="park-table ruled large-figure-only" aria-label=${`${park.sliders}: ${words.bestByHand}, ${words.evolved}`}>
    <thead><tr><td></td>${lab.gains.map(({ id, letter, index }) => html`<th scope="col"><span translate="no" class="symbol ${id}" lang="en">${letter}<sub>${index}</sub></span></th>`)}<th scope="col">${words.parkedColumn}</th></tr></thead>
    <tbody>${row(words.bestByHand, mineOf(model, model.gains), best?.parked ?? null)}${row(words.evolved, found.gains, found.parked)}</tbody>
  </table>
  ${way(model, onWalk)}`;
}

/** All gains at once, from those by hand to evolution's. @param {Model} model @param {(share: number) => void} onWalk */
function way({ between, isOwn, isFree, driven, driving, count }, onWalk) {
  const share = between?.share ?? (isOwn ? 0 : 1);
  const gains = lab.gains.map(({ name }, i) => `${name} ${words.gain(driven[i])}`);
  return html`<p class="park-walk row not-in-figure not-on-paper"><span aria-hidden="true">${words.bestByHand}</span>
    <input id="park-between" type="range" min="0" max="1" step="0.01" aria-label=${words.walk} aria-valuetext=${words.walkedTo(gains, driving, count)}
      .value=${live(String(share))} .disabled=${!isFree} ${styled('--from', '0%')} ${styled('--to', `${percentOf(share)}%`)}
      @input=${(/** @type {Event} */ event) => onWalk(Number(valueIn(event)))}>
    <span aria-hidden="true">${words.evolved}</span></p>`;
}
