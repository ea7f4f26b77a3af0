// The part of the page that shows J over two gains, and what its controls do.
/** @import { Engine, PaperResult, Run, Statistics, Triple } from '../../core/engine.js' */
/** @import { Actions } from '../../run/actions/actions.js' */
/** @import { Scene } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { AxisChoice, Spec } from './request.js' */
/** @import { LandscapeState } from './state.js' */
/** @import { Lowest } from './lowest.js' */
/** @import { Point } from './points.js' */
/** @import { MapModel } from './view.js' */
import './style.css';
import { html, noChange, nothing, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { gainNames, landscapeSlice } from './state.js';
import { showTable } from '../../lab/table-sheet.js';
import { landscapeTable } from './table.js';
import { followHeld, followKeys, followPointing, pointIn } from '../../kit/map.js';
import { remember, watch } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { hidesPaper } from '../../run/exercise.js';
import { byIdIn, followSize } from '../../kit/elements.js';
import { options, valueIn } from '../../kit/templates.js';
import { tryNow } from '../../core/pending.js';
import { createSection } from '../section.js';
import { lab, tables } from '../../words/index.js';
import words from './words/index.js';
import { createLandscapeRequests, createSpec, gainsAt, thirdOf } from './request.js';
import { isOn, lowestOf } from './lowest.js';
import { sketchOf } from './method.js';
import { outlines } from './points.js';
import { lowestText, noteText, readoutOf } from './told.js';
import { axesOf, createMap } from './view.js';

const { texts } = words;
/** What an axis can show. */
const choices = [false, true].flatMap((log) =>
  lab.gains.map(({ id, name }) => ({ gain: id, log, text: log ? words.onLogAxis(name) : name })),
);

/** @param {import('../part.js').Tools} parts @returns {import('../part.js').Page} */
export function createPage({ engine, store, actions, paper }) {
  const element = createSection('landscape', 'landscape-section');
  const specOf = createSpec(paper);
  const requests = createLandscapeRequests(engine, store);
  const { redraw } = store;
  const on = createEvents(store);
  const pathOf = remember((/** @type {Statistics[]} */ history) => history.map(({ best }) => best.gains));
  const sketched = createSketches(engine, redraw);
  const read = remember(
    (/** @type {State['experiment']} */ experiment, /** @type {Triple} */ gains) =>
      engine.drive(experiment, [gains])[0],
  );
  const gainsUnder = remember(gainsAt);
  const lowestOfLast = remember(lowestOf);
  const lowestIn = (/** @type {State} */ state) => {
    const { result } = landscapeSlice.of(state);
    return result && isOn(result.spec, specOf(state)) ? lowestOfLast(result) : null;
  };
  const changed = watch();

  /** @param {State} state @param {Spec} spec @param {Run | null} run @param {Triple} gains */
  const show = (state, spec, run, gains) => {
    const own = landscapeSlice.of(state);
    const isTyping = document.activeElement?.id === 'landscape-third';
    const { driver, found, generation } = state;
    if (changed(own, spec, run, state.population, driver, found, generation, isTyping))
      render(
        sight(
          own,
          {
            spec,
            isTyping,
            method: words.methodSketch(state.experiment.evolution.method),
            readout: run ? readoutOf(state, spec, run, gains) : '',
            lowest: lowestIn(state),
          },
          on,
        ),
        element,
      );
  };
  const first = store.get();
  show(first, specOf(first), null, first.population[0].gains);
  const map = createMapIn(element, redraw);
  const size = followSize(byIdIn(element, 'landscape-map'), redraw);

  /** @returns {MapModel} */
  const modelOf = () => {
    const state = store.get();
    const { result, cursor } = landscapeSlice.of(state);
    return {
      spec: specOf(state),
      result,
      population: state.population,
      hasSigmas: state.experiment.evolution.method !== 'random',
      sketch: sketched(state, specOf(state)),
      path: pathOf(state.history),
      points: pointsOf(state, paper, lowestIn(state)),
      cursor,
      size: size(),
      theme: state.theme,
    };
  };
  followCursor(byIdIn(element, 'landscape-map'), store, actions, modelOf);

  return {
    element,
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const model = modelOf();
      const { spec, cursor } = model;
      requests.follow(spec, state.dragging);
      map.draw(model);
      const gains = cursor ? gainsUnder(spec, cursor) : gainsOf(state, state.driver, paper);
      show(state, spec, cursor ? read(state.experiment, gains) : scene.driving, gains);
    },
  };
}

/** What the method of the lab sees in the generation that is shown; nothing while that is under way. @param {Engine} engine @param {() => void} redraw */
function createSketches(engine, redraw) {
  const recorded = remember((/** @type {Statistics} */ { generation }) => engine.record(generation));
  const sketch = remember(
    (
      /** @type {Statistics} */ shown,
      /** @type {State['experiment']} */ { evolution },
      /** @type {Spec['x']} */ x,
      /** @type {Spec['y']} */ y,
    ) => {
      const [across, up] = [x, y].map(({ gain }) => gainNames.indexOf(gain));
      return sketchOf(evolution.method, recorded(shown), (gains) => [gains[across], gains[up]]);
    },
  );
  return (/** @type {State} */ { history, generation, experiment }, /** @type {Spec} */ { x, y }) => {
    if (experiment.evolution.method === 'ep' || experiment.evolution.method === 'random') return null;
    /** @type {ReturnType<typeof sketch> | null} */
    let found = null;
    tryNow(() => {
      found = sketch(history[generation], experiment, x, y);
    }, redraw);
    return found;
  };
}

/** Where the templates have made room for it. @param {HTMLElement} element @param {() => void} redraw */
function createMapIn(element, redraw) {
  const [picture, marks, legend] = /** @type {HTMLCanvasElement[]} */ (
    ['picture', 'marks', 'legend'].map((name) => byIdIn(element, `landscape-${name}`))
  );
  return createMap({ picture, marks, legend }, redraw);
}

/** The points that have a name. @param {State} state @param {PaperResult[]} paper @param {Lowest | null} lowest @returns {Point[]} */
function pointsOf(state, paper, lowest) {
  const { handGains, pins } = state;
  /** @type {Point[]} */
  const ofPaper = [
    { gains: gainsOf(state, 'paper-arbitrary', paper), name: words.paperArbitrary, mark: 'cross' },
    { gains: gainsOf(state, 'paper-ep', paper), name: words.paperEp, mark: 'diamond' },
  ];
  return [
    ...(lowest ? [/** @type {Point} */ ({ gains: lowest.gains, name: words.lowest, mark: 'sight' })] : []),
    ...(hidesPaper(state) ? [] : ofPaper),
    ...(handGains ? [/** @type {Point} */ ({ gains: handGains, name: words.hand, mark: 'ring' })] : []),
    ...pins.map(({ gains, name, slot }) => ({ gains, name, mark: slot })),
  ];
}

/** @typedef {ReturnType<typeof createEvents>} Events */

/** @param {Store} store */
function createEvents(store) {
  const update = (/** @type {Partial<LandscapeState>} */ patch) => landscapeSlice.update(store, patch);
  const own = () => landscapeSlice.of(store.get());
  return {
    onTable() {
      const { result } = own();
      showTable(result && landscapeTable(result));
    },
    /** @param {'x' | 'y'} axis @param {AxisChoice} choice */
    onAxis(axis, { gain, log }) {
      const { [axis]: before, [axis === 'x' ? 'y' : 'x']: other } = own();
      const chosen = { gain, log };
      // The gain of the other axis: the two change places.
      const left = gain === other.gain ? { ...other, gain: before.gain } : other;
      const axes = axis === 'x' ? { x: chosen, y: left } : { x: left, y: chosen };
      update({ third: null, thirdError: '', cursor: null, ...axes });
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

/** @param {LandscapeState} landscape @param {{ spec: Spec, isTyping: boolean, readout: string, lowest: Lowest | null, method: string }} shown @param {Events} on */
function sight(landscape, { spec, isTyping, readout, lowest, method }, on) {
  return html`
    <div class="heading">
      <h2 id="landscape-title">${texts.landscapeTitle}</h2>
      <p id="landscape-note" class="muted">${noteText(landscape, spec)}</p>
      <button id="landscape-table" type="button" class="link" @click=${on.onTable}>${tables.texts.tableButton}</button>
    </div>
    <div class="bar axes">
      <label>→ ${axisChoice('x', landscape, texts.landscapeAcross, on)}</label>
      <label>↑ ${axisChoice('y', landscape, texts.landscapeUp, on)}</label>
      ${thirdGain(landscape, spec.third, isTyping, on)}
    </div>
    ${method ? html`<p id="landscape-method" class="muted">${method}</p>` : nothing}
    <div id="landscape-map" class="map layers" data-picture="landscape" data-name=${words.texts.landscapePicture} tabindex="0" role="application"
      aria-label=${words.mapLabel} aria-describedby="landscape-readout">
      <canvas id="landscape-picture" aria-hidden="true"></canvas>
      <canvas id="landscape-marks" aria-hidden="true"></canvas>
    </div>
    <canvas id="landscape-legend" class="map-legend" data-picture="landscape" aria-hidden="true"></canvas>
    <p id="landscape-lowest" class="muted">${lowest ? html`${signOf()} ${lowestText(lowest)}` : nothing}</p>
    <p id="landscape-readout" class="readout" aria-live="polite">${readout}</p>`;
}

/** The mark of the lowest point, as the map has it. */
const signOf = () =>
  html`<svg class="landscape-sign" viewBox="-12 -12 24 24" aria-hidden="true"><path d=${outlines.sight}></path></svg>`;

/** @param {'x' | 'y'} axis @param {LandscapeState} landscape @param {string} label @param {Events} on */
function axisChoice(axis, { [axis]: shown }, label, { onAxis }) {
  const chosen = choices.findIndex(({ gain, log }) => shown.gain === gain && shown.log === log);
  return html`<select id="landscape-${axis}" aria-label=${label}
    @change=${(/** @type {Event} */ event) => onAxis(axis, choices[Number(valueIn(event))])}>${options(
      choices.map(({ text }, i) => /** @type {const} */ ([i, text])),
      chosen,
    )}</select>`;
}

/** The gain that is on no axis. @param {LandscapeState} landscape @param {number} value @param {boolean} isTyping What is typed stays. @param {Events} on */
function thirdGain(landscape, value, isTyping, { onThird, onFollows }) {
  const { third, thirdError } = landscape;
  const { id, name, letter, index } = lab.gains[thirdOf(landscape)];
  const follows = third === null;
  return html`
    <label><span id="landscape-third-name" class="symbol ${id}" lang="en">${letter}<sub>${index}</sub></span>
      <input id="landscape-third" type="text" size="5" inputmode="decimal" autocomplete="off" spellcheck="false"
        aria-label=${words.thirdLabel(name)} aria-describedby="landscape-third-error"
        aria-invalid=${String(thirdError !== '')} .value=${isTyping || thirdError ? noChange : live(lab.typed(value, 3))}
        @focus=${(/** @type {Event} */ { target }) => /** @type {HTMLInputElement} */ (target).select()}
        @change=${(/** @type {Event} */ event) => onThird(valueIn(event))}></label>
    <label class="check"><input id="landscape-follows" type="checkbox" .checked=${live(follows)}
      @change=${() => onFollows(!follows, value)}> <span>${texts.landscapeFollows}</span></label>
    <p id="landscape-third-error" class="field-error" role="alert" .hidden=${!thirdError}>${thirdError}</p>`;
}

/** As many digits as are shown, so that the gains in the text are the gains that drive. @param {number} value */
const tidy = (value) => Number(value.toPrecision(3));

/** @param {HTMLElement} element @param {Store} store @param {Actions} actions @param {() => MapModel} modelOf */
function followCursor(element, store, actions, modelOf) {
  const put = (/** @type {readonly [number, number] | null} */ cursor) =>
    landscapeSlice.update(store, { cursor });
  /** @param {PointerEvent} event @returns {[number, number]} */
  const at = (event) => {
    const { x, y } = axesOf(modelOf());
    const [px, py] = pointIn(element, event);
    return [tidy(x.value(px)), tidy(y.value(py))];
  };
  /** @param {MapModel} model */
  const current = ({ spec, cursor, population: [{ gains }] }) =>
    cursor ?? [gains[gainNames.indexOf(spec.x.gain)], gains[gainNames.indexOf(spec.y.gain)]];
  const drive = (/** @type {readonly [number, number]} */ cursor) =>
    actions.driveGains(gainsAt(modelOf().spec, cursor), 'map');
  const isHeld = followHeld(
    element,
    (event) => {
      const cursor = at(event);
      put(cursor);
      drive(cursor);
    },
    actions.driveAgain,
  );
  followPointing(element, (event) => put(event && at(event)), isHeld);
  followKeys(element, {
    onEnter() {
      drive(/** @type {[number, number]} */ (current(modelOf())));
      actions.driveAgain();
    },
    onEscape: () => put(null),
    onStep([right, up], isWide) {
      const model = modelOf();
      const { x, y } = axesOf(model);
      const [across, above] = current(model);
      const pixels = isWide ? 40 : 4;
      put([tidy(x.value(x.at(across) + right * pixels)), tidy(y.value(y.at(above) - up * pixels))]);
    },
  });
}
