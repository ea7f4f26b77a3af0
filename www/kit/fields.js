// Fields that templates hold more than once, each with what it is called and what it does.
import { html, noChange } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { choicesOf } from './segmented.js';
import { options, valueIn } from './templates.js';

/**
 * @template V
 * @param {string} id @param {string} label @param {readonly (readonly [V, string])[]} choices
 * @param {V} chosen @param {(value: V) => void} onChoose @param {boolean} [isDisabled] Else it is left alone.
 */
export function selectOf(id, label, choices, chosen, onChoose, isDisabled) {
  const change = (/** @type {Event} */ event) => {
    const choice = choices.find(([value]) => String(value) === valueIn(event));
    if (choice) onChoose(choice[0]);
  };
  return html`<select id=${id} aria-label=${label} .disabled=${isDisabled ?? noChange} @change=${change}>${options(choices, chosen)}</select>`;
}

/**
 * @template {string} V
 * @param {string} id @param {string} legend @param {readonly import('./segmented.js').Choice<V>[]} choices
 * @param {V} chosen @param {(value: V) => void} onChoose @param {string} [more] Classes.
 */
export const segmentedOf = (id, legend, choices, chosen, onChoose, more = '') =>
  html`<fieldset id=${id} class=${`segmented ${more}`.trim()}>${choicesOf(id, legend, choices, chosen, onChoose)}</fieldset>`;

/** @param {string} id @param {string} text @param {boolean} isOn @param {(isOn: boolean) => void} onSwitch @param {{ more?: string, isDisabled?: boolean }} [look] `more`: classes. */
export const checkOf = (id, text, isOn, onSwitch, { more = '', isDisabled } = {}) =>
  html`<label class=${`check ${more}`.trim()}><input id=${id} type="checkbox" .checked=${live(isOn)} .disabled=${isDisabled ?? noChange}
    @change=${() => onSwitch(!isOn)}> <span>${text}</span></label>`;
