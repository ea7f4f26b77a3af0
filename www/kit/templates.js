// What templates are made of more than once.
import { html } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { ref } from 'lit-html/directives/ref.js';

/** What a select holds. @template V @param {readonly (readonly [V, string])[]} choices @param {V} chosen */
export const options = (choices, chosen) =>
  choices.map(
    ([value, text]) =>
      html`<option value=${String(value)} .selected=${live(value === chosen)}>${text}</option>`,
  );

/** What was chosen or typed. @param {Event} event */
export const valueIn = ({ target }) => /** @type {HTMLSelectElement | HTMLInputElement} */ (target).value;

/** Styles an element, which no attribute may. @param {string} name @param {string} value */
export const styled = (name, value) =>
  ref((element) => /** @type {HTMLElement | undefined} */ (element)?.style.setProperty(name, value));
