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

/** What a number is typed with: the decimal keys of an iPhone have no minus. @param {boolean} isSigned */
export const keysFor = (isSigned) => (isSigned ? 'text' : 'decimal');

/** @param {Event} event Of a field. */
export const selectAll = ({ target }) => /** @type {HTMLInputElement} */ (target).select();

/** Of a button that keeps the focus while it can do nothing: it is `aria-disabled`, for a disabled one would lose it. @param {boolean} isIdle @param {() => void} act */
export const unless = (isIdle, act) => () => {
  if (!isIdle) act();
};

/** Of a button that ends what it has begun: the second press of a double one is meant for neither. @param {() => unknown} act */
export const unlessDouble =
  (act) =>
  (/** @type {MouseEvent} */ { detail }) => {
    if (detail < 2) act();
  };

/** Not of the Enter that ends a composition, which Safari tells by its code alone. @param {() => void} act @returns {(event: KeyboardEvent) => void} */
export const onEnter = (act) => (event) => {
  if (event.key === 'Enter' && !event.isComposing && event.keyCode !== 229) act();
};

/** What closes a panel. @param {string} id @param {string} label @param {() => void} onClick */
export const closeButton = (id, label, onClick) =>
  html`<button id=${id} type="button" class="icon" aria-label=${label} @click=${onClick}><svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true"><path d="M3 1.6 8 6.6l5-5L14.4 3l-5 5 5 5-1.4 1.4-5-5-5 5L1.6 13l5-5-5-5z"/></svg></button>`;

/** Every second piece is a subscript. @param {readonly string[]} pieces */
export const formula = (pieces) => pieces.map((piece, i) => (i % 2 ? html`<sub>${piece}</sub>` : piece));
