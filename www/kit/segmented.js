// A choice of one among a few: native radio buttons that look like one control.
import { html, noChange, nothing, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { byId } from './elements.js';

/** @template {string} V @typedef {{ value: V, text: string, hint?: string, disabled?: boolean }} Choice */
/** What each is called, none forgotten. @template {string} V @typedef {Readonly<Record<V, string | { text: string, hint?: string }>>} Choices */

/** In the order in which they are written. @template {string} V @param {Choices<V>} choices @returns {Choice<V>[]} */
export const listed = (choices) =>
  /** @type {[V, string | { text: string, hint?: string }][]} */ (Object.entries(choices)).map(
    ([value, said]) => (typeof said === 'string' ? { value, text: said } : { value, ...said }),
  );

/**
 * What a fieldset of this id holds. Firefox prints what the attributes say.
 * @template {string} V
 * @param {string} id @param {string} legend @param {readonly Choice<V>[]} choices
 * @param {V | null} chosen @param {(value: V) => void} onChoose
 */
export const choicesOf = (id, legend, choices, chosen, onChoose) => html`
  <legend class="visually-hidden">${legend}</legend>${choices.map(
    ({ value, text, hint, disabled }) =>
      html`<label title=${hint ?? nothing} data-choice=${value}><input id="${id}-${value}" type="radio" name=${id} value=${value}
        .checked=${live(value === chosen)} ?checked=${value === chosen} .disabled=${disabled ?? noChange} @change=${() => onChoose(value)}><span>${text}</span></label>`,
  )}`;

/**
 * @template {string} V
 * @param {string} id Of the fieldset. @param {string} legend
 * @param {readonly Choice<V>[]} choices @param {(value: V) => void} onChoose
 */
export function createSegmented(id, legend, choices, onChoose) {
  const fieldset = byId(id);
  /** @param {V | null} chosen */
  const draw = (chosen) => render(choicesOf(id, legend, choices, chosen, onChoose), fieldset);
  draw(null);
  return { draw };
}
