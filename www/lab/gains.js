// The three gains: a slider and a number for each.
/** @import { Triple } from '../core/engine.js' */
import { html, noChange, nothing, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { create } from '../kit/elements.js';
import { takesBack } from '../kit/keyboard.js';
import { keysFor, selectAll, styled } from '../kit/templates.js';
import { watch } from '../kit/memo.js';
import { lab as strings } from '../words/index.js';

/** @typedef {{ isShown: boolean, gains: Triple, errors: readonly [string, string, string], range: readonly [number, number], note: string }} GainsModel */
/**
 * @typedef {object} GainEvents
 * @property {(index: number, value: number) => void} onSlide
 * @property {() => void} onSlid
 * @property {(index: number, text: string) => void} onType
 */

/** @param {HTMLElement} root @param {HTMLElement} note @param {GainEvents} events */
export function createGains(root, note, events) {
  const rows = strings.gains.map((gain, index) => createRow(gain, index, events));
  root.replaceChildren(...rows.map(({ row }) => row));
  const changed = watch();
  return {
    /** @param {GainsModel} model */
    draw(model) {
      root.hidden = !model.isShown;
      if (!changed(...model.gains, ...model.errors, ...model.range, model.note)) return;
      note.textContent = model.note;
      for (const [i, row] of rows.entries()) row.draw(model.gains[i], model.errors[i], model.range);
    },
  };
}

/** Where a slider's thumb is caught at 0, as a share of its length: a few pixels, for a hand cannot hit one. */
const detent = 0.01;

/** Three digits after the point, and of what is so long only those that are not 0. @param {number} value */
const shown = (value) => (Math.abs(value) < 1e5 ? strings.typed(value, 3) : String(Number(value.toFixed(3))));

/**
 * @param {{ id: string, name: string, letter: string, index: string }} gain @param {number} index @param {GainEvents} events
 * @param {string} [unit]
 */
export function createRow(gain, index, events, unit = '') {
  const { id } = gain;
  const row = create('div', { class: `gain ${id}`, 'data-term': id === 'ktheta' ? 'kt' : id });
  // What somebody is typing is not overwritten by what evolution finds meanwhile.
  let typing = false;
  // Keys go step by step, and need no help.
  let held = false;
  let sliding = false;
  let current = 0;
  const on = {
    hold: () => {
      held = true;
    },
    key: () => {
      held = false;
    },
    slide: (/** @type {Event} */ { target }) => {
      const slider = /** @type {HTMLInputElement} */ (target);
      const reach = detent * (Number(slider.max) - Number(slider.min));
      if (held && Math.abs(slider.valueAsNumber) < reach) slider.value = '0';
      sliding = true;
      events.onSlide(index, slider.valueAsNumber);
    },
    slid: () => {
      sliding = false;
      events.onSlid();
    },
    /** Also where a finger only scrolls the page. */
    lost: () => sliding && on.slid(),
    input: () => {
      typing = true;
    },
    /** What is copied whole has all its digits, of which the field shows three. */
    copy: (/** @type {ClipboardEvent} */ event) => {
      const field = /** @type {HTMLInputElement} */ (event.target);
      const isWhole = field.selectionStart === 0 && field.selectionEnd === field.value.length;
      if (!isWhole || field.value !== shown(current)) return;
      event.clipboardData?.setData('text/plain', String(current));
      event.preventDefault();
    },
    blur: () => {
      typing = false;
    },
    leave: (/** @type {KeyboardEvent} */ event) => {
      if (!takesBack(event, typing)) return;
      typing = false;
      /** @type {HTMLInputElement} */ (event.target).value = shown(current);
    },
    change: (/** @type {Event} */ { target }) => {
      // Firefox tells it too of what was taken back.
      if (!typing) return;
      typing = false;
      events.onType(index, /** @type {HTMLInputElement} */ (target).value);
    },
  };

  return {
    row,
    /** @param {number} value @param {string} message @param {readonly [number, number]} range */
    draw(value, message, [low, high]) {
      // Where the middle of the thumb is.
      const place = (/** @type {number} */ at) =>
        `calc(9px + (100% - 18px) * ${(Math.min(Math.max(at, low), high) - low) / (high - low)})`;
      const from = styled('--from', place(Math.min(0, value)));
      const to = styled('--to', place(Math.max(0, value)));
      const zero = styled('--zero', place(0));
      const text = shown(value);
      current = value;
      const before = /** @type {HTMLInputElement | null} */ (row.querySelector('[type="text"]'));
      const isStale = !message && !typing && before?.value !== text;
      render(
        html`
          <label for="gain-${id}" translate="no">${gain.letter}<sub>${gain.index}</sub></label>
          <input id="slider-${id}" type="range" step="0.01" aria-label=${gain.name}
            aria-valuetext=${unit ? `${text} ${unit}` : nothing}
            .min=${String(low)} .max=${String(high)} .value=${live(String(value))} ${from} ${to} ${zero}
            @pointerdown=${on.hold} @keydown=${on.key} @input=${on.slide} @change=${on.slid} @pointercancel=${on.lost}>
          <input id="gain-${id}" type="text" inputmode=${keysFor(true)} autocomplete="off" spellcheck="false"
            aria-label=${strings.gainInputLabel(gain.name)} aria-describedby="gain-${id}-error"
            aria-invalid=${String(message !== '')} .value=${isStale ? live(text) : noChange}
            @input=${on.input} @copy=${on.copy} @blur=${on.blur} @keydown=${on.leave} @change=${on.change} @focus=${selectAll}>
          ${unit ? html`<span class="muted">${unit}</span>` : nothing}
          <p id="gain-${id}-error" class="field-error" role="alert" .hidden=${message === ''}>${message}</p>`,
        row,
      );
      if (before && ((message && !typing) || isStale) && document.activeElement === before) before.select();
    },
  };
}
