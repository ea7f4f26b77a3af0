// What stands beside the parking place: what to do, how many have parked, three sliders, and what evolution found.
/** @import { Experiment, Triple } from '../../core/engine.js' */
/** @import { Bred, ParkState } from './state.js' */
import { html, nothing, svg } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { styled, unless, valueIn } from '../../kit/templates.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';

/** @typedef {Omit<ParkState, 'gains'> & { gains: Triple, moved: boolean, isFree: boolean, isOwn: boolean, parked: number, over: boolean, count: number, most: number, population: number, tolerance: Experiment['tolerance'] }} Model `isFree`: the sliders can be moved; `isOwn`: the robots drive with the sliders' gains. */
/** @typedef {{ slide: (index: number, value: number) => void, again: () => void, evolve: () => void, stop: () => void, lesson: string, lab: string | null }} Events */

/** @param {Model} model */
export function heading(model) {
  const newest = model.evolving ? undefined : model.bred.at(-1);
  return html`
    <h2 id="park-title">${words.title}</h2>
    <p class="park-say">${newest ? words.ending(model, newest) : words.invitation(model.count)}</p>`;
}

/** @param {Model} model @param {Events} on */
export function sight(model, on) {
  const { parked, count, bred, evolving, over, message } = model;
  const newest = bred.at(-1);
  const hand = model.moved ? words.yours : words.given;
  const seen = newest && !model.isOwn ? words.swarm(newest.generation, model.population) : hand;
  return html`
    <p class="park-count"><strong id="park-count">${parked}</strong> ${words.ofParked(count)}
      <span class="muted">${newest && !evolving && over ? '' : seen}</span></p>
    <fieldset id="park-gains" aria-label=${words.sliders}>${lab.gains.map((gain, i) => rowOf(gain, i, model, on))}</fieldset>
    <p class="park-bar">
      <button id="park-evolve" type="button" class=${newest ? '' : 'primary'} .disabled=${!model.moved && model.isFree} aria-describedby=${bred.length > 0 ? nothing : 'park-hint'}
        @click=${evolving ? on.stop : on.evolve}>${evolving ? words.stop : newest ? words.otherSeed : words.evolve}</button>
      <button id="park-again" type="button" aria-disabled=${String(evolving || !over)} @click=${unless(evolving || !over, on.again)}>${words.again}</button>
    </p>
    ${message ? html`<p class="message" role="alert">${message}</p>` : nothing}
    ${bred.length > 0 ? climb(model) : html`<p id="park-hint" class="muted">${model.moved || !model.isFree ? words.ready(model.population) : words.first}</p>`}
    ${over && !evolving && parked < count ? html`<p class="muted">${words.missed(model.tolerance)}</p>` : nothing}
    ${newest && !evolving ? comparison(model, newest) : nothing}
    ${newest && !evolving ? html`<p class="park-on"><a id="park-lesson" href="#${on.lesson}">${words.how}</a> ${on.lab ? html`<a id="park-lab" href="#${on.lab}">${words.openLab}</a>` : nothing}</p>` : nothing}
    <p class="visually-hidden" role="status">${over && !evolving ? words.picture(parked, count) : ''}</p>`;
}

/** @param {typeof lab.gains[number]} gain @param {number} index @param {Model} model @param {Events} on */
function rowOf({ id, name, letter, index: sub }, index, { gains, evolving, most }, on) {
  const value = gains[index];
  return html`<div class="gain ${id}">
    <label for="park-${id}">${letter}<sub>${sub}</sub></label>
    <input id="park-${id}" type="range" step="0.1" aria-label=${name} min="0" max=${most}
      .value=${live(String(value))} .disabled=${evolving} ${styled('--from', '0%')} ${styled('--to', `${(100 * value) / most}%`)}
      @input=${(/** @type {Event} */ event) => on.slide(index, Number(valueIn(event)))}>
    <span class="park-gain">${words.gain(value)}</span>
  </div>`;
}

/** How many the best robot of each generation parked. @param {Model} model */
function climb({ bred, best, count }) {
  const [width, height] = [300, 64];
  const x = (/** @type {number} */ generation) => (generation / Math.max(20, bred.length - 1)) * width;
  const y = (/** @type {number} */ parked) => height - (parked / count) * height;
  const line = bred.map(({ generation, parked }) => `${x(generation)},${y(parked)}`).join(' ');
  const newest = /** @type {Bred} */ (bred.at(-1));
  return html`<figure class="park-climb">
    <svg viewBox="-4 -6 ${width + 8} ${height + 12}" preserveAspectRatio="none" role="img" aria-label=${words.climb(newest)}>
      <path d="M0 0H${width}M0 ${height}H${width}"></path>
      ${best ? svg`<path class="park-yours" d="M0 ${y(best.parked)}H${width}"></path>` : nothing}
      <polyline points=${line}></polyline>
    </svg>
    <figcaption class="muted">${words.climb(newest)}</figcaption>
  </figure>`;
}

/** @param {Model} model @param {Bred} found */
function comparison({ best, gains, count }, found) {
  const mine = best ?? { gains, parked: null };
  const row = (
    /** @type {string} */ name,
    /** @type {Triple} */ triple,
    /** @type {number | null} */ parked,
  ) =>
    html`<tr><th scope="row">${name}</th>${triple.map((gain, i) => html`<td class=${lab.gains[i].id}>${words.gain(gain)}</td>`)}<td>${parked === null ? '–' : words.share(parked, count)}</td></tr>`;
  return html`<table class="park-table">
    <thead><tr><td></td>${lab.gains.map(({ letter, index }) => html`<th scope="col"><i>${letter}</i><sub>${index}</sub></th>`)}<th scope="col">${words.parkedColumn}</th></tr></thead>
    <tbody>${row(words.bestByHand, mine.gains, mine.parked)}${row(words.evolved, found.gains, found.parked)}</tbody>
  </table>`;
}
