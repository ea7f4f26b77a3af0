// The words and controls around the map of J over two gains, and what the controls do.
/** @import { Run, Triple } from '../../core/engine.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Lowest } from './lowest.js' */
/** @import { AxisChoice, Spec } from './request.js' */
/** @import { LandscapeState } from './state.js' */
import { html, noChange, nothing, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { announce, createTeller } from '../../lab/announcer.js';
import { tableButton } from '../../lab/table-sheet.js';
import { watch } from '../../kit/memo.js';
import { checkOf, selectOf } from '../../kit/fields.js';
import { keysFor, selectAll, valueIn } from '../../kit/templates.js';
import { lab } from '../../words/index.js';
import { outlines } from './points.js';
import { thirdOf } from './request.js';
import { landscapeSlice } from './state.js';
import { landscapeTable } from './table.js';
import { legendOf, lowestText, noteText, readoutOf } from './told.js';
import words from './words/index.js';

const { texts } = words;
/** What an axis can show. */
const choices = [false, true].flatMap((log) =>
  lab.gains.map(({ id, name }) => ({ gain: id, log, text: log ? words.onLogAxis(name) : name })),
);

/** @param {AxisChoice} shown */
const chosenOf = (shown) => choices.findIndex(({ gain, log }) => shown.gain === gain && shown.log === log);

/** @param {HTMLElement} element @param {Store} store @param {(state: State) => Lowest | null} lowestIn */
export function createSight(element, store, lowestIn) {
  const on = createEvents(store);
  const changed = watch();
  const tell = createTeller('landscape');
  /** @param {State} state @param {Spec} spec @param {Run | null} run @param {Triple} gains @param {readonly { gains: Triple }[]} points */
  return (state, spec, run, gains, points) => {
    const own = landscapeSlice.of(state);
    const isTyping = document.activeElement?.id === 'landscape-third';
    const { driver, evolving, found, generation, pins, handGains, population } = state;
    const seen = [own, spec, run, population, driver, evolving, found, generation, pins, handGains, isTyping];
    if (!changed(...seen)) return;
    const shown = {
      spec,
      isTyping,
      evolving,
      legend: legendOf(state, spec, points),
      readout: run ? readoutOf(state, spec, run, gains) : '',
      lowest: lowestIn(state),
    };
    render(sight(own, shown, on), element);
    tell(shown.readout, evolving || own.cursor !== null);
  };
}

/** @typedef {ReturnType<typeof createEvents>} Events */

/** @param {Store} store */
function createEvents(store) {
  const { now: own, update } = landscapeSlice.at(store);
  return {
    redraw: store.redraw,
    /** @param {'x' | 'y'} axis @param {AxisChoice} choice */
    onAxis(axis, { gain, log }) {
      const { [axis]: before, [axis === 'x' ? 'y' : 'x']: other } = own();
      const chosen = { gain, log };
      // The gain of the other axis: the two change places.
      const left = gain === other.gain ? { ...other, gain: before.gain } : other;
      const axes = axis === 'x' ? { x: chosen, y: left } : { x: left, y: chosen };
      // Only another gain than before has no value of its own yet.
      const isOther = thirdOf(axes) !== thirdOf(own());
      update({ ...(isOther && { third: null, thirdError: '' }), cursor: null, ...axes });
      if (left === other) return;
      const moved = choices[chosenOf(left)].text;
      announce('landscape-axis', `${axis === 'x' ? texts.landscapeUp : texts.landscapeAcross}: ${moved}`);
    },
    /** @param {string} text */
    onThird(text) {
      const value = lab.numberOf(text);
      const { name } = lab.gains[thirdOf(own())];
      if (Number.isFinite(value)) update({ third: value, thirdError: '' });
      else update({ thirdError: lab.notANumber(name, text) });
    },
    /** @param {boolean} follows @param {number} value */
    onFollows: (follows, value) => update({ third: follows ? null : value, thirdError: '' }),
  };
}

/** @param {LandscapeState} landscape @param {{ spec: Spec, isTyping: boolean, evolving: boolean, readout: string, lowest: Lowest | null, legend: string }} shown @param {Events} on */
function sight(landscape, { spec, isTyping, evolving, readout, lowest, legend }, on) {
  return html`
    <div class="heading">
      <h2 id="landscape-title">${texts.landscapeTitle}</h2>
      <p id="landscape-note" class="muted">${noteText(landscape, spec)}</p>
      ${tableButton('landscape', landscape.result, landscapeTable)}
    </div>
    <div class="bar axes large-figure-only">
      <label>→ ${axisChoice('x', landscape, texts.landscapeAcross, on)}</label>
      <label>↑ ${axisChoice('y', landscape, texts.landscapeUp, on)}</label>
      ${thirdGain(landscape, spec.third, isTyping, on)}
    </div>
    <div class="landscape-sight">
      ${legend ? html`<p id="landscape-method" class="muted">${withSymbols(legend)}</p>` : nothing}
      <div id="landscape-map" class="map picture layers" data-picture="landscape" data-name=${words.texts.landscapePicture} tabindex="0" role="application"
        aria-label=${words.mapLabel} aria-describedby="landscape-readout">
        <canvas id="landscape-picture" aria-hidden="true"></canvas>
        <canvas id="landscape-marks" aria-hidden="true"></canvas>
      </div>
      <canvas id="landscape-legend" class="map-legend" data-picture="landscape" aria-hidden="true"></canvas>
      <p id="landscape-lowest" class="muted large-figure-only">${lowest ? html`${signOf()} ${withSymbols(lowestText(lowest))}` : nothing}</p>
      <p id="landscape-readout" class="readout" aria-live=${landscape.cursor && !evolving ? 'polite' : 'off'} aria-atomic="true">${withSymbols(readout)}</p>
    </div>`;
}

/** The gain's letter in its colour, as in formulas. @param {typeof lab.gains[number]} gain */
const symbolOf = ({ id, letter, index }) =>
  html`<span translate="no" class="symbol ${id}" lang="en">${letter}<sub>${index}</sub></span>`;

const names = new RegExp(`(${lab.gains.map(({ name }) => name).join('|')})`);
/** A sentence in which each gain is written so. @param {string} text */
const withSymbols = (text) =>
  text.split(names).map((piece) => {
    const gain = lab.gains.find(({ name }) => name === piece);
    return gain ? symbolOf(gain) : piece;
  });

/** The mark of the lowest point, as the map has it. */
const signOf = () =>
  html`<svg class="landscape-sign" viewBox="-12 -12 24 24" aria-hidden="true"><path d=${outlines.sight}></path></svg>`;

/** @param {'x' | 'y'} axis @param {LandscapeState} landscape @param {string} label @param {Events} on */
function axisChoice(axis, { [axis]: shown }, label, { onAxis }) {
  const names = choices.map(({ text }, i) => /** @type {const} */ ([i, text]));
  return selectOf(`landscape-${axis}`, label, names, chosenOf(shown), (i) => onAxis(axis, choices[i]));
}

/** The gain that is on no axis. @param {LandscapeState} landscape @param {number} value @param {boolean} isTyping What is typed stays. @param {Events} on */
function thirdGain(landscape, value, isTyping, { onThird, onFollows, redraw }) {
  const { third, thirdError } = landscape;
  const { id, name, letter, index } = lab.gains[thirdOf(landscape)];
  return html`
    <label><span id="landscape-third-name" translate="no" class="symbol ${id}" lang="en">${letter}<sub>${index}</sub></span>
      <input id="landscape-third" type="text" size="5" inputmode=${keysFor(true)} autocomplete="off" spellcheck="false"
        aria-label=${words.thirdLabel(name)} aria-describedby="landscape-third-error"
        aria-invalid=${String(thirdError !== '')} .value=${isTyping || thirdError ? noChange : live(lab.typed(value, 3))}
        @focus=${selectAll} @blur=${redraw}
        @change=${(/** @type {Event} */ event) => onThird(valueIn(event))}></label>
    ${checkOf('landscape-follows', texts.landscapeFollows, third === null, (follows) => onFollows(follows, value))}
    <p id="landscape-third-error" class="field-error" role="alert" .hidden=${!thirdError}>${thirdError}</p>`;
}
