// What stands beside the parking place: what to do, how many have parked, three sliders, and what evolution found.
/** @import { Experiment, Triple } from '../../core/engine.js' */
/** @import { Film } from './film.js' */
/** @import { ParkState } from './state.js' */
import { html, nothing } from 'lit-html';
import { keyed } from 'lit-html/directives/keyed.js';
import { live } from 'lit-html/directives/live.js';
import { styled, unless, valueIn } from '../../kit/templates.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';

/** What there is once something has been tried, when it is there. @typedef {import('./after/page.js').After | null} After */
/** @typedef {Omit<ParkState, 'gains'> & { gains: Triple, driven: Triple, driving: number, film: Film, moved: boolean, isFree: boolean, isOwn: boolean, parked: number, over: boolean, count: number, population: number, tolerance: Experiment['tolerance'] }} Model `isFree`: the sliders can be moved; `isOwn`: the robots drive with the sliders' gains; `driven`: what they drive with, and `driving`: how many park so; `film`: another at every drive, once it is over. */
/** @typedef {{ slide: (index: number, value: number) => void, again: () => void, evolve: () => void, stop: () => void, lesson: string | null, lab: string | null }} Events */

/** @param {Model} model @param {After} after */
export function heading(model, after) {
  const newest = model.evolving ? undefined : model.bred.at(-1);
  return html`
    <h2 id="park-title">${words.title}</h2>
    <p class="park-say not-in-small-figure">${after && newest ? html`${after.ending(model, newest)}${after.beyond(model, newest)}` : words.invitation(model.count)}</p>`;
}

/** Whose robots drive. @param {Model} model @param {After} after */
function driverOf({ bred, isOwn, moved, between, population }, after) {
  const newest = bred.at(-1);
  if (!newest || isOwn) return moved ? words.yours : words.given;
  return after && between ? after.walked(between) : words.swarm(newest.generation, population);
}

/** @param {Model} model @param {Events} on @param {After} after @param {HTMLElement | null} failed Says that it cannot be there. */
export function sight(model, on, after, failed) {
  const { film, parked, count, bred, evolving, over, message, isOwn } = model;
  const newest = bred.at(-1);
  return html`
    <p class="park-count"><strong id="park-count">${parked}</strong> <span>${words.ofParked(count)}</span>
      <span class="muted">${driverOf(model, after)}</span></p>
    <fieldset id="park-gains" class=${newest && !isOwn ? 'is-idle' : ''} aria-label=${words.sliders}>${lab.gains.map((gain, i) => rowOf(gain, i, model, on, after))}</fieldset>
    <p class="park-bar row not-on-paper">
      <button id="park-evolve" type="button" class=${newest ? '' : 'primary'} .disabled=${!model.moved && model.isFree} aria-describedby=${bred.length > 0 ? nothing : 'park-hint'}
        @click=${evolving ? on.stop : on.evolve}>${evolving ? words.stop : newest ? words.otherSeed : words.evolve}</button>
      <button id="park-again" type="button" class="not-in-small-figure" aria-disabled=${String(evolving || !over)} @click=${unless(evolving || !over, on.again)}>${words.again}</button>
    </p>
    ${after && newest ? after.key(model) : nothing}
    ${failed}
    ${message ? html`<p class="message" role="alert">${message}</p>` : nothing}
    ${newest ? after?.climb(model) : html`<p id="park-hint" class="muted not-in-small-figure not-on-paper">${model.moved || !model.isFree ? words.ready(model.population) : words.first}</p>`}
    ${newest && !evolving ? after?.comparison(model, newest, after.walk) : nothing}
    ${newest && !evolving ? html`<p class="park-on row not-on-paper">${on.lesson ? html`<a id="park-lesson" href="#${on.lesson}">${words.how}</a>` : nothing} ${on.lab ? html`<a id="park-lab" class="not-in-small-figure" href="#${on.lab}">${words.openLab}</a>` : nothing}</p>` : nothing}
    ${over && !evolving && parked < count ? html`<p class="muted not-in-small-figure">${words.missed(model.tolerance)} <span class="hint">${words.pressOne}</span></p>` : nothing}
    <p class="visually-hidden" role="status">${keyed(film, html`${over && !evolving ? (after?.told(model) ?? words.picture(parked, count)) : ''}`)}</p>`;
}

/** @param {typeof lab.gains[number]} gain @param {number} index @param {Model} model @param {Events} on @param {After} after */
function rowOf({ id, name, letter, index: sub }, index, model, on, after) {
  const { gains, driven, bred, isOwn, evolving, ends, endsBefore } = model;
  const [value, most] = [gains[index], ends[index]];
  return html`<div class="gain ${id}">
    <label for="park-${id}"><span translate="no">${letter}<sub>${sub}</sub></span> <span class="park-what not-in-figure">${words.whatFor[index]}</span></label>
    <input id="park-${id}" type="range" step="0.1" aria-label=${`${name}, ${words.whatFor[index]}`} min="0" max=${most}
      .value=${live(String(value))} .disabled=${evolving} ${styled('--from', '0%')} ${styled('--to', `${(100 * value) / most}%`)}
      @input=${(/** @type {Event} */ event) => on.slide(index, Number(valueIn(event)))}>
    <span class="park-gain">${words.gain(value)}</span>
    ${most > endsBefore[index] ? html`<span class="park-end muted not-on-paper" aria-hidden="true">${most}</span>` : nothing}
    ${bred.length > 0 ? after?.mark(isOwn ? (bred.at(-1)?.gains ?? driven)[index] : driven[index], most) : nothing}
  </div>`;
}
