// The part of the page that shows J over two gains, and what its controls do.
import { gainNames, landscapeSlice } from './state.js';
import { offerTable } from '../../kit/table.js';
import { landscapeTable } from './table.js';
import { arrowOf, isChord } from '../../kit/keyboard.js';
import { remember, watch } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { byId, followSize } from '../../kit/elements.js';
import { lab, landscape as words } from '../../words/index.js';
import { createLandscapeRequests, createSpec, gainsAt, thirdOf } from './request.js';
import { axesOf, countOutside, createMap } from './view.js';

/** @typedef {import('../../run/actions/actions.js').Actions} Actions */
/** @typedef {import('../../core/engine.js').Engine} Engine */
/** @typedef {import('../../core/engine.js').PaperResult} PaperResult */
/** @typedef {import('../../core/engine.js').Statistics} Statistics */
/** @typedef {import('../../run/scene.js').Scene} Scene */
/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../run/store.js').Store} Store */
/** @typedef {import('../../core/engine.js').Triple} Triple */
/** @typedef {import('./request.js').AxisChoice} AxisChoice */
/** @typedef {import('./state.js').LandscapeState} LandscapeState */
/** @typedef {import('./view.js').Point} Point */
/** @typedef {import('./view.js').MapModel} MapModel */

/** @param {import('../part.js').Tools} parts @returns {import('../part.js').Page} */
export function createLandscapePage({ engine, store, actions, paper }) {
  const specOf = createSpec(paper);
  const requests = createLandscapeRequests(engine, store);
  const { redraw } = store;
  const map = createMap(
    {
      picture: byId('landscape-picture'),
      marks: byId('landscape-marks'),
      legend: byId('landscape-legend'),
    },
    redraw,
  );
  const controls = createControls(store);
  offerTable('landscape-table', () => {
    const { result } = landscapeSlice.of(store.get());
    return result && landscapeTable(result);
  });
  const pathOf = remember((/** @type {Statistics[]} */ history) => history.map(({ best }) => best.gains));
  const read = remember(
    (/** @type {State['experiment']} */ experiment, /** @type {Triple} */ gains) =>
      engine.drive(experiment, [gains])[0],
  );
  const gainsUnder = remember(gainsAt);
  const textsChanged = watch();
  const size = followSize(byId('landscape-map'), redraw);

  /** @returns {MapModel} */
  const modelOf = () => {
    const state = store.get();
    return {
      spec: specOf(state),
      result: landscapeSlice.of(state).result,
      population: state.population,
      path: pathOf(state.history),
      points: pointsOf(state, paper),
      cursor: landscapeSlice.of(state).cursor,
      size: size(),
      theme: state.theme,
    };
  };
  followPointer(store, actions, modelOf);
  followKeys(store, actions, modelOf);

  return {
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const model = modelOf();
      const { spec } = model;
      requests.follow(spec, state.dragging);
      controls.draw(landscapeSlice.of(state), spec.third);
      map.draw(model);
      const { result, message, cursor } = landscapeSlice.of(state);
      const fresh = result?.spec === spec;
      const gains = cursor ? gainsUnder(spec, cursor) : gainsOf(state, state.driver, paper);
      const run = cursor ? read(state.experiment, gains) : scene.driving;
      if (!textsChanged(run, message, fresh, result, model.population, spec.x, spec.y)) return;
      byId('landscape-note').textContent = message
        ? words.failed(message)
        : result && fresh
          ? words.drivesText(result.costs.length, result.milliseconds)
          : words.computing;
      const names = lab.gains.map(({ name }, i) => words.gainText(name, gains[i]));
      const outside = model.size.width > 0 ? countOutside(axesOf(model), spec, model.population) : 0;
      byId('landscape-readout').textContent = [
        words.readout(names.join(', '), run, lab.outcomeText(run)),
        ...(outside > 0 ? [words.outside(outside)] : []),
      ].join('. ');
    },
  };
}

/** The points that have a name. @param {State} state @param {PaperResult[]} paper @returns {Point[]} */
function pointsOf(state, paper) {
  const { handGains, pins } = state;
  return [
    { gains: gainsOf(state, 'paper-arbitrary', paper), name: words.paperArbitrary, mark: 'cross' },
    { gains: gainsOf(state, 'paper-ep', paper), name: words.paperEp, mark: 'diamond' },
    ...(handGains ? [/** @type {Point} */ ({ gains: handGains, name: words.hand, mark: 'ring' })] : []),
    ...pins.map(({ gains, name, slot }) => ({ gains, name, mark: slot })),
  ];
}

const { update } = landscapeSlice;

/** As many digits as are shown, so that the gains in the text are the gains that drive. @param {number} value */
const tidy = (value) => Number(value.toPrecision(3));

/** @param {Store} store @param {Actions} actions @param {() => MapModel} modelOf */
function followPointer(store, actions, modelOf) {
  const element = byId('landscape-map');
  let held = false;
  /** @param {PointerEvent} event @returns {[number, number]} */
  const pointAt = (event) => {
    const { left, top } = element.getBoundingClientRect();
    const { x, y } = axesOf(modelOf());
    return [tidy(x.value(event.clientX - left)), tidy(y.value(event.clientY - top))];
  };
  const drive = (/** @type {PointerEvent} */ event) => {
    const cursor = pointAt(event);
    update(store, { cursor });
    actions.driveGains(gainsAt(modelOf().spec, cursor), 'map');
  };
  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    held = true;
    element.setPointerCapture(event.pointerId);
    drive(event);
  });
  element.addEventListener('pointermove', (event) => {
    if (held) drive(event);
    else if (event.pointerType !== 'touch') update(store, { cursor: pointAt(event) });
  });
  const release = () => {
    if (held) actions.driveAgain();
    held = false;
  };
  element.addEventListener('pointerup', release);
  element.addEventListener('pointercancel', release);
  element.addEventListener('pointerleave', () => {
    if (!held) update(store, { cursor: null });
  });
}

/** @param {Store} store @param {Actions} actions @param {() => MapModel} modelOf */
function followKeys(store, actions, modelOf) {
  const element = byId('landscape-map');
  element.setAttribute('aria-label', words.mapLabel);
  element.addEventListener('keydown', (event) => {
    const model = modelOf();
    const { spec } = model;
    const axes = axesOf(model);
    const gains = model.population[0].gains;
    const from = model.cursor ?? [
      gains[gainNames.indexOf(spec.x.gain)],
      gains[gainNames.indexOf(spec.y.gain)],
    ];
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      actions.driveGains(gainsAt(spec, /** @type {[number, number]} */ (from)), 'map');
      actions.driveAgain();
    } else if (event.key === 'Escape') update(store, { cursor: null });
    const step = arrowOf(event.key);
    if (!step || isChord(event)) return;
    event.preventDefault();
    const pixels = event.shiftKey ? 40 : 4;
    update(store, {
      cursor: [
        tidy(axes.x.value(axes.x.at(from[0]) + step[0] * pixels)),
        tidy(axes.y.value(axes.y.at(from[1]) - step[1] * pixels)),
      ],
    });
  });
  element.addEventListener('blur', () => update(store, { cursor: null }));
}

/** Which gains the axes show. @param {Store} store */
function createControls(store) {
  const axes = /** @type {const} */ (['x', 'y']).map((axis) => {
    /** @type {HTMLSelectElement} */
    const select = byId(`landscape-${axis}`);
    const options = [false, true].flatMap((log) =>
      lab.gains.map(({ id, name }) => ({
        choice: { gain: id, log },
        text: log ? words.onLogAxis(name) : name,
      })),
    );
    select.replaceChildren(...options.map(({ text }, i) => new Option(text, String(i))));
    select.addEventListener('change', () => {
      const { [axis]: own, [axis === 'x' ? 'y' : 'x']: other } = landscapeSlice.of(store.get());
      const chosen = options[Number(select.value)].choice;
      // The gain of the other axis: the two change places.
      const left = chosen.gain === other.gain ? { ...other, gain: own.gain } : other;
      update(store, {
        third: null,
        thirdError: '',
        cursor: null,
        ...(axis === 'x' ? { x: chosen, y: left } : { x: left, y: chosen }),
      });
    });
    /** @param {AxisChoice} shown */
    const draw = (shown) => {
      select.value = String(
        options.findIndex(({ choice }) => choice.gain === shown.gain && choice.log === shown.log),
      );
    };
    return { axis, draw };
  });

  /** @type {HTMLInputElement} */
  const third = byId('landscape-third');
  /** @type {HTMLInputElement} */
  const follows = byId('landscape-follows');
  const error = byId('landscape-third-error');
  const thirdName = byId('landscape-third-name');
  third.addEventListener('focus', () => third.select());
  third.addEventListener('change', () => {
    const value = lab.numberOf(third.value);
    const { name } = lab.gains[thirdOf(landscapeSlice.of(store.get()))];
    if (Number.isFinite(value)) update(store, { third: value, thirdError: '' });
    else update(store, { thirdError: lab.notANumber(name, third.value) });
  });
  follows.addEventListener('change', () => {
    const value = lab.numberOf(third.value);
    update(store, { third: follows.checked || !Number.isFinite(value) ? null : value, thirdError: '' });
  });

  return {
    /** @param {LandscapeState} landscape @param {number} value Of the gain that is on no axis. */
    draw(landscape, value) {
      for (const { axis, draw } of axes) draw(landscape[axis]);
      const { id, name, letter, index } = lab.gains[thirdOf(landscape)];
      if (thirdName.textContent !== name) thirdName.replaceChildren(letter, subscript(index));
      thirdName.className = `symbol ${id}`;
      third.setAttribute('aria-label', words.thirdLabel(name));
      const text = lab.typed(value, 3);
      if (document.activeElement !== third && !landscape.thirdError && third.value !== text)
        third.value = text;
      third.setAttribute('aria-invalid', String(landscape.thirdError !== ''));
      follows.checked = landscape.third === null;
      error.textContent = landscape.thirdError;
      error.hidden = landscape.thirdError === '';
    },
  };
}

/** @param {string} text */
function subscript(text) {
  const element = document.createElement('sub');
  element.textContent = text;
  return element;
}
