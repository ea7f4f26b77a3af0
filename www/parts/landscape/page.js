// The part of the page that shows J over two gains.
/** @import { Engine, PaperResult, Statistics, Triple } from '../../core/engine.js' */
/** @import { Actions } from '../../run/actions/actions.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Spec } from './request.js' */
/** @import { Lowest } from './lowest.js' */
/** @import { Point } from './points.js' */
/** @import { MapModel } from './view.js' */
import '../map.css';
import './style.css';
import { gainNames, landscapeSlice } from './state.js';
import { followHeld, followKeys, followPointing, pointIn } from '../../kit/map.js';
import { remember } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { hidesPaper } from '../../run/exercise.js';
import { byIdIn } from '../../kit/elements.js';
import { followSize } from '../../kit/size.js';
import { tryNow } from '../../core/pending.js';
import { createSection } from '../section.js';
import words from './words/index.js';
import { createLandscapeRequests, createSpec, gainsAt } from './request.js';
import { isOn, markedOf } from './lowest.js';
import { hasCrosses, hasSketch, sketchOf } from './method.js';
import { createSight } from './sight.js';
import { axesOf, createMap } from './view.js';

/** @param {import('../part.js').Tools} parts @returns {import('../part.js').Page} */
export function createPage({ engine, store, actions, paper }) {
  const element = createSection('landscape', 'landscape-section');
  const specOf = createSpec(paper);
  const requests = createLandscapeRequests(engine, store);
  const { redraw } = store;
  const pathOf = remember((/** @type {Statistics[]} */ history) => history.map(({ best }) => best.gains));
  const sketched = createSketches(engine, redraw);
  const read = remember(
    (/** @type {State['experiment']} */ experiment, /** @type {Triple} */ gains) =>
      engine.drive(experiment, [gains])[0],
  );
  const gainsUnder = remember(gainsAt);
  const lowestOfLast = remember(markedOf);
  const lowestIn = (/** @type {State} */ state) => {
    const { result } = landscapeSlice.of(state);
    return result && isOn(result.spec, specOf(state)) ? lowestOfLast(result) : null;
  };
  const show = createSight(element, store, lowestIn);
  const first = store.get();
  show(first, specOf(first), null, first.population[0].gains, []);
  const map = createMap(element, redraw);
  const size = followSize(byIdIn(element, 'landscape-map'), redraw);

  /** @returns {MapModel} */
  const modelOf = () => {
    const state = store.get();
    const { result, cursor } = landscapeSlice.of(state);
    return {
      spec: specOf(state),
      result,
      population: state.population,
      hasCrosses: hasCrosses(state.experiment.evolution.method),
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
    retry: requests.retry,
    draw(state, scene) {
      const model = modelOf();
      const { spec, cursor } = model;
      requests.follow(spec, state.dragging);
      map.draw(model);
      const gains = cursor ? gainsUnder(spec, cursor) : gainsOf(state, state.driver, paper);
      show(state, spec, cursor ? read(state.experiment, gains) : scene.driving, gains, model.points);
    },
  };
}

/** What the method of the lab sees in the generation that is shown; nothing while that is under way. @param {Engine} engine @param {() => void} redraw */
function createSketches(engine, redraw) {
  const recorded = remember(
    (/** @type {Statistics} */ { generation }, /** @type {State['experiment']} */ experiment) =>
      engine.record(generation, experiment),
  );
  const sketch = remember(
    /** @param {Statistics} shown @param {State['experiment']} experiment @param {Spec['x']} x @param {Spec['y']} y */
    (shown, experiment, x, y) => {
      const [across, up] = [x, y].map(({ gain }) => gainNames.indexOf(gain));
      return sketchOf(experiment.evolution.method, recorded(shown, experiment), (gains) => [
        gains[across],
        gains[up],
      ]);
    },
  );
  return (/** @type {State} */ { history, generation, experiment }, /** @type {Spec} */ { x, y }) => {
    if (!hasSketch(experiment.evolution.method)) return null;
    return tryNow(() => sketch(history[generation], experiment, x, y), redraw);
  };
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

/** As many digits as are shown, so that the gains in the text are the gains that drive. @param {number} value */
const tidy = (value) => Number(value.toPrecision(3));

/** @param {HTMLElement} element @param {Store} store @param {Actions} actions @param {() => MapModel} modelOf */
function followCursor(element, store, actions, modelOf) {
  const put = (/** @type {MapModel['cursor']} */ cursor) => landscapeSlice.update(store, { cursor });
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
    onEscape() {
      if (modelOf().cursor === null) return false;
      put(null);
      return true;
    },
    onStep([right, up], isWide) {
      const model = modelOf();
      const { x, y } = axesOf(model);
      const [across, above] = current(model);
      const pixels = isWide ? 40 : 4;
      put([tidy(x.value(x.at(across) + right * pixels)), tidy(y.value(y.at(above) - up * pixels))]);
    },
  });
}
