// One row of the settings: a number with its unit and slider, or a choice; a limit can be switched off.
/** @import { Experiment, Field } from '../core/engine.js' */
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { Value } from '../run/paths.js' */
/** @import { Row } from './table.js' */
import { html, nothing, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { create } from '../kit/elements.js';
import { keysFor, options, selectAll, styled, valueIn } from '../kit/templates.js';
import { numberOf } from '../words/numbers.js';
import { settings as words } from '../words/index.js';
import { createQuantity, createSliderScale } from './quantity.js';

/** @typedef {{ experiment: Experiment, value: Value, original: Value, error: string }} RowModel */
/** @typedef {{ element: HTMLElement, help: string, draw: (model: RowModel) => void }} RowView */

/** On a text field that holds what nobody has confirmed yet. */
export const typingMark = 'data-typing';

/** The same setting can stand in two places of the page. @param {string} path @param {string} [place] */
const idOf = (path, place = 'setting') => `${place}-${path.replace(/\W+/g, '-').replace(/-$/, '')}`;

/** What every row has around its control. @param {Row} row @param {string} id @param {string} help @param {(original: Value) => void} onBack */
function createFrame({ path, symbol }, id, help, onBack) {
  const { name } = words.settings[path];
  const element = create('div', { class: 'setting', 'data-of': path });
  return {
    element,
    /** @param {RowModel} model @param {string} original As it is read. @param {unknown} control @param {unknown} [more] */
    draw(model, original, control, more = nothing) {
      const isChanged = model.value !== model.original;
      const back = words.backLabel(name, original);
      const onClick = () => {
        onBack(model.original);
        // The button that was pressed is about to go, and a field with it whose limit was none.
        document.getElementById(model.original === null ? `${id}-on` : id)?.focus();
      };
      element.classList.toggle('changed', isChanged);
      render(
        html`
          <label for=${id}><span translate="no" class="symbol ${symbol?.colour ?? ''}" lang="en" aria-hidden="true">${symbol?.letter}${
            symbol?.index ? html`<sub>${symbol.index}</sub>` : nothing
          }</span><span class="name">${name}</span></label>
          ${control}
          <button type="button" class="back" aria-label=${back} title=${back} .hidden=${!isChanged} @click=${onClick}>↺</button>
          ${more}
          <p id="${id}-error" class="field-error" role="alert" .hidden=${model.error === ''}>${model.error}</p>
          <span id="${id}-help" class="visually-hidden">${help}</span>`,
        element,
      );
    },
  };
}

/** @param {Row} row @param {readonly string[]} values @param {Actions} actions @returns {RowView} */
export function createChoice(row, values, actions) {
  const { path } = row;
  const id = idOf(path);
  const { name, help, choices = {} } = words.settings[path];
  const text = words.helpText(name, help, '');
  const change = (/** @type {Value} */ value) => actions.changeSetting(path, value, false);
  const named = values.map((value) => /** @type {const} */ ([value, choices[value]]));
  const frame = createFrame(row, id, text, change);
  frame.element.classList.add('choice');
  return {
    element: frame.element,
    help: text,
    draw: (model) =>
      frame.draw(
        model,
        choices[String(model.original)],
        html`<select id=${id} aria-describedby="${id}-error ${id}-help" aria-invalid=${String(model.error !== '')}
          .disabled=${row.isIdle?.(model.experiment) ?? false} @change=${(/** @type {Event} */ event) => change(valueIn(event))}>${options(named, String(model.value))}</select>`,
      ),
  };
}

/** @param {Row} row @param {Field} field @param {Actions} actions @param {number} fallback The limit for who switches it on. @param {string} [place] @returns {RowView} */
export function createNumber(row, field, actions, fallback, place) {
  const { path } = row;
  const id = idOf(path, place);
  const { name, help } = words.settings[path];
  const quantity = createQuantity(field);
  const printed = (/** @type {number} */ shown) => words.quantity(String(shown), quantity.unit);
  const shownText = (/** @type {Value} */ value) =>
    typeof value === 'number' ? printed(quantity.shown(value)) : words.noLimit;
  const [from, to] = quantity.range.map(printed);
  const range = words.rangeText({ integer: quantity.integer, from, to });
  const text = words.helpText(name, help, range);
  const change = (/** @type {Value} */ value, dragging = false) =>
    actions.changeSetting(path, value, dragging);

  let lastLimit = fallback;
  /** @type {readonly Value[]} */
  let known = [];
  /** What is shown of a number is the number itself, so that rounding changes nothing. @param {number} shown */
  const meant = (shown) =>
    known.find((value) => typeof value === 'number' && quantity.shown(value) === shown) ??
    quantity.value(shown);

  const slide = (/** @type {number} */ shown) => change(meant(shown), true);
  const slider = createSlider(row, field.min === 0, slide, actions.releaseSetting);
  const frame = createFrame(row, id, text, change);
  frame.element.classList.toggle('wide', field.max > 1e8);

  const typing = createTyping(id, quantity.unit, field.min < 0, (typed) => {
    const value = meant(numberOf(typed));
    if (typeof value === 'number' && quantity.allows(value)) change(value);
    else actions.refuseSetting(path, words.refused(name, range, typed));
  });
  const onLimit = (/** @type {Event} */ event) => change(targetOf(event).checked ? lastLimit : null);

  return {
    element: frame.element,
    help: text,
    draw(model) {
      const { value, error } = model;
      known = [value, model.original];
      const isLimited = typeof value === 'number';
      if (isLimited) lastLimit = value;
      const isOff = !isLimited || (row.isIdle?.(model.experiment) ?? false);
      const shown = isLimited ? quantity.shown(value) : Number.NaN;
      frame.draw(
        model,
        shownText(model.original),
        typing.field(isLimited ? String(shown) : '', error, isOff),
        html`${field.nullable ? limitOf(id, name, isLimited, onLimit) : nothing}${slider?.(id, shown, shownText(value), isOff)}`,
      );
      typing.write(/** @type {HTMLInputElement} */ (frame.element.querySelector('[type="text"]')), error);
    },
  };
}

/** The number as text: what somebody is typing is not overwritten by what happens meanwhile, and its undo is the field's own. @param {string} id @param {string} unit @param {boolean} isSigned @param {(typed: string) => void} onTyped */
function createTyping(id, unit, isSigned, onTyped) {
  let written = '';
  /** @param {Event} event @param {boolean} now */
  const setTyping = (event, now) => targetOf(event).toggleAttribute(typingMark, now);
  const on = {
    input: (/** @type {Event} */ event) => setTyping(event, valueIn(event) !== written),
    blur: (/** @type {Event} */ event) => setTyping(event, false),
    key(/** @type {KeyboardEvent} */ event) {
      if (event.key !== 'Escape') return;
      targetOf(event).value = written;
      setTyping(event, false);
    },
    change(/** @type {Event} */ event) {
      setTyping(event, false);
      onTyped(valueIn(event));
    },
  };
  return {
    /** @param {string} text Empty when there is no limit. @param {string} error @param {boolean} isOff */
    field(text, error, isOff) {
      written = text;
      return html`<input id=${id} type="text" inputmode=${keysFor(isSigned)} autocomplete="off" spellcheck="false"
            aria-describedby="${id}-error ${id}-help" aria-invalid=${String(error !== '')}
            .disabled=${isOff} placeholder=${text ? '' : words.noLimit}
            @input=${on.input} @blur=${on.blur} @keydown=${on.key} @focus=${selectAll} @change=${on.change}><span class="unit muted">${unit}</span>`;
    },
    /** Writes it into the field, once that is there. @param {HTMLInputElement} input @param {string} error */
    write(input, error) {
      if (input.hasAttribute(typingMark)) return;
      const isStale = !error && input.value !== written;
      if (isStale) input.value = written;
      if ((error || isStale) && document.activeElement === input) input.select();
    },
  };
}

/** @param {Event} event */
const targetOf = ({ target }) => /** @type {HTMLInputElement} */ (target);

/** Whether the limit is there. @param {string} id @param {string} name @param {boolean} isOn @param {(event: Event) => void} onSwitch */
const limitOf = (id, name, isOn, onSwitch) =>
  html`<label class="check"><input id="${id}-on" type="checkbox" aria-label=${words.limitLabel(name)}
    .checked=${live(isOn)} @change=${onSwitch}></label>`;

/**
 * What draws the slider, if the row has one: at most one change a frame, and one gesture from the first to the last: a drag, or a
 * key that is held.
 * @param {Row} row @param {boolean} hasZero @param {(shown: number) => void} onSlide @param {() => void} onSlid
 */
function createSlider({ path, slider: range, symbol }, hasZero, onSlide, onSlid) {
  if (!range) return null;
  const scale = createSliderScale(range, hasZero);
  let moving = false;
  let isKeyHeld = false;
  let position = scale.min;
  /** @type {number | null} */
  let pending = null;
  const apply = () => {
    if (pending !== null) onSlide(pending);
    pending = null;
  };
  const end = () => {
    apply();
    if (moving) onSlid();
    moving = false;
  };
  const on = {
    input(/** @type {Event} */ event) {
      if (pending === null) requestAnimationFrame(apply);
      moving = true;
      position = Number(valueIn(event));
      pending = scale.number(position);
    },
    change() {
      if (!isKeyHeld) end();
    },
    press() {
      isKeyHeld = true;
    },
    /** Where it ends at the value with which it began browsers tell of no change. */
    release() {
      isKeyHeld = false;
      end();
    },
  };
  const percent = (/** @type {number} */ at) => `${(100 * (at - scale.min)) / (scale.max - scale.min)}%`;
  const zero = range.log ? scale.min : Math.min(Math.max(0, scale.min), scale.max);

  /** @param {string} id @param {number} shown NaN when there is no limit. @param {string} text @param {boolean} isOff */
  return (id, shown, text, isOff) => {
    // While it is dragged it stands where the pointer is, which other numbers may be nearest to.
    if (pending === null && scale.number(position) !== shown)
      position = Number.isNaN(shown) ? scale.min : scale.position(shown);
    return html`<input id="${id}-slider" type="range" class=${symbol?.colour ?? ''} aria-label=${words.settings[path].name}
      min=${scale.min} max=${scale.max} step=${scale.step} aria-valuetext=${text} .disabled=${isOff}
      .value=${live(String(position))} ${styled('--from', percent(Math.min(zero, position)))} ${styled('--to', percent(Math.max(zero, position)))}
      @input=${on.input} @change=${on.change} @keydown=${on.press} @keyup=${on.release} @blur=${on.release}
      @pointerup=${on.release} @pointercancel=${on.release}>`;
  };
}
