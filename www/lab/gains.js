// The three gains: a slider and a number for each.
import { watch } from '../kit/memo.js';
import { lab as strings } from '../words/index.js';

/** @typedef {import('../core/engine.js').Triple} Triple */
/** @typedef {{ gains: Triple, errors: readonly [string, string, string], range: readonly [number, number], note: string }} GainsModel */
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
      if (!changed(...model.gains, ...model.errors, ...model.range, model.note)) return;
      note.textContent = model.note;
      for (const [i, row] of rows.entries()) row.draw(model.gains[i], model.errors[i], model.range);
    },
  };
}

/** @param {{ id: string, name: string, letter: string, index: string }} gain @param {number} index @param {GainEvents} events */
export function createRow(gain, index, events) {
  const { id } = gain;
  const row = document.createElement('div');
  const label = document.createElement('label');
  const slider = document.createElement('input');
  const number = document.createElement('input');
  const error = document.createElement('p');
  const subscript = document.createElement('sub');
  row.className = `gain ${id}`;
  row.dataset.term = id === 'ktheta' ? 'kt' : id;
  Object.assign(slider, { type: 'range', id: `slider-${id}`, step: '0.01' });
  Object.assign(number, {
    type: 'text',
    inputMode: 'decimal',
    id: `gain-${id}`,
    autocomplete: 'off',
    spellcheck: false,
  });
  Object.assign(error, { id: `gain-${id}-error`, className: 'field-error', hidden: true });
  error.setAttribute('role', 'alert');
  slider.setAttribute('aria-label', strings.gainSliderLabel(gain.name));
  number.setAttribute('aria-label', strings.gainInputLabel(gain.name));
  number.setAttribute('aria-describedby', error.id);
  label.htmlFor = number.id;
  subscript.textContent = gain.index;
  label.append(gain.letter, subscript);
  row.append(label, slider, number, error);

  slider.addEventListener('input', () => events.onSlide(index, slider.valueAsNumber));
  slider.addEventListener('change', events.onSlid);
  // What somebody is typing is not overwritten by what evolution finds meanwhile.
  let typing = false;
  number.addEventListener('input', () => {
    typing = true;
  });
  number.addEventListener('blur', () => {
    typing = false;
  });
  number.addEventListener('change', () => {
    typing = false;
    events.onType(index, number.value);
  });
  number.addEventListener('focus', () => number.select());

  return {
    row,
    /** @param {number} value @param {string} message @param {readonly [number, number]} range */
    draw(value, message, [low, high]) {
      Object.assign(slider, { min: String(low), max: String(high) });
      slider.value = String(value);
      const percent = (/** @type {number} */ at) =>
        `${(100 * (Math.min(Math.max(at, low), high) - low)) / (high - low)}%`;
      slider.style.setProperty('--from', percent(Math.min(0, value)));
      slider.style.setProperty('--to', percent(Math.max(0, value)));
      const text = strings.typed(value, 3);
      const isStale = !message && !typing && number.value !== text;
      if (isStale) number.value = text;
      number.setAttribute('aria-invalid', String(message !== ''));
      if ((message || isStale) && document.activeElement === number) number.select();
      error.textContent = message;
      error.hidden = message === '';
    },
  };
}
