// One row of the settings: a number with its unit and slider, or a choice; a limit can be switched off.
import { numberOf } from '../words/numbers.js';
import { settings as words } from '../words/index.js';
import { createQuantity, createSliderScale } from './quantity.js';

/** @typedef {import('../run/actions/actions.js').Actions} Actions */
/** @typedef {import('../core/engine.js').Experiment} Experiment */
/** @typedef {import('../core/engine.js').Field} Field */
/** @typedef {import('../run/paths.js').Value} Value */
/** @typedef {import('./table.js').Row} Row */
/** @typedef {{ experiment: Experiment, value: Value, original: Value, error: string }} RowModel */
/** @typedef {{ element: HTMLElement, help: string, draw: (model: RowModel) => void }} RowView */

/** On a text field that holds what nobody has confirmed yet. */
export const typingMark = 'data-typing';

/** The same setting can stand in two places of the page. @param {string} path @param {string} [place] */
export const idOf = (path, place = 'setting') => `${place}-${path.replace(/\W+/g, '-').replace(/-$/, '')}`;

/** @template {keyof HTMLElementTagNameMap} K @param {K} tag @param {Partial<HTMLElementTagNameMap[K]>} [properties] @returns {HTMLElementTagNameMap[K]} */
const make = (tag, properties = {}) => Object.assign(document.createElement(tag), properties);

/** What every row has around its control. @param {Row} row @param {HTMLElement} control @param {string} help @param {() => void} onBack */
function createFrame({ path, symbol }, control, help, onBack) {
  const { name } = words.settings[path];
  const element = make('div', { className: 'setting' });
  const label = make('label', { htmlFor: control.id });
  const sign = make('span', { className: `symbol ${symbol?.colour ?? ''}`, ariaHidden: 'true' });
  const back = make('button', { type: 'button', className: 'back', textContent: '↺' });
  const error = make('p', { id: `${control.id}-error`, className: 'field-error', hidden: true });
  const about = make('span', { id: `${control.id}-help`, className: 'visually-hidden', textContent: help });
  if (symbol) sign.append(symbol.letter);
  if (symbol?.index) sign.append(make('sub', { textContent: symbol.index }));
  label.append(sign, make('span', { className: 'name', textContent: name }));
  error.setAttribute('role', 'alert');
  control.setAttribute('aria-describedby', `${error.id} ${about.id}`);
  back.addEventListener('click', () => {
    onBack();
    // The button that was pressed is about to go.
    control.focus();
  });
  element.append(label, control, back, error, about);
  return {
    element,
    error,
    /** @param {string} message @param {boolean} changed @param {string} original */
    draw(message, changed, original) {
      element.classList.toggle('changed', changed);
      back.hidden = !changed;
      back.setAttribute('aria-label', words.backLabel(name, original));
      back.title = words.backLabel(name, original);
      error.textContent = message;
      error.hidden = message === '';
      control.setAttribute('aria-invalid', String(message !== ''));
    },
  };
}

/** @param {Row} row @param {readonly string[]} values @param {Actions} actions @returns {RowView} */
export function createChoice(row, values, actions) {
  const { path } = row;
  const { name, help, choices = {} } = words.settings[path];
  const select = make('select', { id: idOf(path) });
  select.replaceChildren(...values.map((value) => new Option(choices[value], value)));
  select.addEventListener('change', () => actions.changeSetting(path, select.value, false));
  /** @type {Value} */
  let original = '';
  const text = words.helpText(name, help, '');
  const frame = createFrame(row, select, text, () => actions.changeSetting(path, original, false));
  frame.element.classList.add('choice');
  return {
    element: frame.element,
    help: text,
    draw(model) {
      original = model.original;
      select.value = String(model.value);
      frame.draw(model.error, model.value !== original, choices[String(original)]);
    },
  };
}

/** @param {Row} row @param {Field} field @param {Actions} actions @param {number} fallback The limit for who switches it on. @param {string} [place] @returns {RowView} */
export function createNumber(row, field, actions, fallback, place) {
  const { path } = row;
  const { name, help } = words.settings[path];
  const quantity = createQuantity(field);
  const printed = (/** @type {number} */ shown) => words.quantity(String(shown), quantity.unit);
  const shownText = (/** @type {Value} */ value) =>
    typeof value === 'number' ? printed(quantity.shown(value)) : words.noLimit;
  const [from, to] = quantity.range.map(printed);
  const range = words.rangeText({ integer: quantity.integer, from, to });
  const text = words.helpText(name, help, range);
  const input = make('input', {
    type: 'text',
    inputMode: 'decimal',
    id: idOf(path, place),
    autocomplete: 'off',
    spellcheck: false,
  });
  const unit = make('span', { className: 'unit', textContent: quantity.unit });

  /** @type {Value} */
  let original = null;
  /** @type {Value} */
  let current = null;
  /** What is shown of a number is the number itself, so that rounding changes nothing. @param {number} shown */
  const meant = (shown) =>
    [current, original].find((known) => typeof known === 'number' && quantity.shown(known) === shown) ??
    quantity.value(shown);

  const frame = createFrame(row, input, text, () => actions.changeSetting(path, original, false));
  input.after(unit);
  frame.element.classList.toggle('wide', field.max > 1e8);
  const slider =
    row.slider &&
    createSlider(
      row,
      input.id,
      field.min === 0,
      (shown, dragging) => actions.changeSetting(path, meant(shown), dragging),
      actions.releaseSetting,
    );
  const limit = field.nullable
    ? createLimit(path, input.id, (on) => actions.changeSetting(path, on ? lastLimit : null, false))
    : null;
  let lastLimit = fallback;
  frame.error.before(...(limit ? [limit.element] : []), ...(slider ? [slider.element] : []));

  // What somebody is typing is not overwritten by what happens meanwhile, and its undo is the field's own.
  let typing = false;
  let written = '';
  const setTyping = (/** @type {boolean} */ now) => {
    typing = now;
    input.toggleAttribute(typingMark, now);
  };
  input.addEventListener('input', () => setTyping(input.value !== written));
  input.addEventListener('blur', () => setTyping(false));
  input.addEventListener('focus', () => input.select());
  input.addEventListener('change', () => {
    setTyping(false);
    const shown = numberOf(input.value);
    const value = meant(shown);
    if (typeof value === 'number' && quantity.allows(value)) actions.changeSetting(path, value, false);
    else actions.refuseSetting(path, words.refused(name, range, input.value));
  });

  return {
    element: frame.element,
    help: text,
    draw(model) {
      ({ original, value: current } = model);
      const isLimited = typeof current === 'number';
      if (typeof current === 'number') lastLimit = current;
      frame.draw(model.error, current !== original, shownText(original));
      const isOff = !isLimited || (row.isIdle?.(model.experiment) ?? false);
      input.disabled = isOff;
      input.placeholder = isLimited ? '' : words.noLimit;
      const shown = typeof current === 'number' ? quantity.shown(current) : Number.NaN;
      written = isLimited ? String(shown) : '';
      const isStale = !model.error && !typing && input.value !== written;
      if (isStale) input.value = written;
      if ((model.error || isStale) && document.activeElement === input) input.select();
      slider?.draw(shown, shownText(current), isOff);
      limit?.draw(isLimited);
    },
  };
}

/** Whether the limit is there. @param {string} path @param {string} id @param {(on: boolean) => void} onSwitch */
function createLimit(path, id, onSwitch) {
  const label = make('label', { className: 'check' });
  const box = make('input', {
    type: 'checkbox',
    id: `${id}-on`,
    ariaLabel: words.limitLabel(words.settings[path].name),
  });
  box.addEventListener('change', () => onSwitch(box.checked));
  label.append(box);
  return {
    element: label,
    /** @param {boolean} on */
    draw(on) {
      box.checked = on;
    },
  };
}

/** @param {Row} row @param {string} id @param {boolean} hasZero @param {(shown: number, dragging: boolean) => void} onSlide @param {() => void} onSlid */
function createSlider({ path, slider, symbol }, id, hasZero, onSlide, onSlid) {
  const range = /** @type {import('./quantity.js').SliderRange} */ (slider);
  const scale = createSliderScale(range, hasZero);
  const { name } = words.settings[path];
  const element = make('input', {
    type: 'range',
    id: `${id}-slider`,
    className: symbol?.colour ?? '',
    min: String(scale.min),
    max: String(scale.max),
    step: String(scale.step),
    ariaLabel: words.sliderLabel(name),
  });

  // At most one change a frame, and one gesture from the first to the last: a drag, or a key that is held.
  let moving = false;
  let isKeyHeld = false;
  /** @type {number | null} */
  let pending = null;
  const apply = () => {
    if (pending !== null) onSlide(pending, true);
    pending = null;
  };
  const end = () => {
    apply();
    if (moving) onSlid();
    moving = false;
  };
  element.addEventListener('input', () => {
    if (pending === null) requestAnimationFrame(apply);
    moving = true;
    pending = scale.number(element.valueAsNumber);
  });
  element.addEventListener('change', () => {
    if (!isKeyHeld) end();
  });
  element.addEventListener('keydown', () => {
    isKeyHeld = true;
  });
  for (const name of ['keyup', 'blur'])
    element.addEventListener(name, () => {
      isKeyHeld = false;
      end();
    });

  return {
    element,
    /** @param {number} shown NaN when there is no limit. @param {string} text @param {boolean} isOff */
    draw(shown, text, isOff) {
      element.disabled = isOff;
      element.setAttribute('aria-valuetext', text);
      const position = Number.isNaN(shown) ? scale.min : scale.position(shown);
      if (pending === null && scale.number(element.valueAsNumber) !== shown) element.value = String(position);
      const percent = (/** @type {number} */ at) => `${(100 * (at - scale.min)) / (scale.max - scale.min)}%`;
      const zero = range.log ? scale.min : Math.min(Math.max(0, scale.min), scale.max);
      element.style.setProperty('--from', percent(Math.min(zero, position)));
      element.style.setProperty('--to', percent(Math.max(zero, position)));
    },
  };
}
