// Wires the page: experiment → engine → views. The views get numbers and draw them.
import { createActions, endsOf, firstState, messageOf } from './actions.js';
import { createAccumulator, createFrameLoop } from './clocks.js';
import { createEngine } from './engine.js';
import {
  advanceRobot,
  createScene,
  createStore,
  gainsOf,
  generationsPerRun,
  generationsPerSecond,
  remember,
} from './state.js';
import * as strings from './strings.js';
import { createView } from './view.js';
import { byId, createViews, fillTexts, showMessage } from './views.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./engine.js').Experiment} Experiment */
/** @typedef {import('./engine.js').PaperResult} PaperResult */
/** @typedef {import('./engine.js').Preset} Preset */
/** @typedef {import('./state.js').Scene} Scene */
/** @typedef {import('./state.js').State} State */
/** @typedef {import('./state.js').Store} Store */
/** @typedef {import('./views.js').Views} Views */

const sliderRange = {
  'velocity-limits': /** @type {const} */ ([-2, 12]),
  'acceleration-limits': /** @type {const} */ ([-2, 32]),
};

/** @param {Engine} engine */
function start(engine) {
  const paper = engine.paper();
  const sceneOf = createScene(engine.drive, paper);
  const generations = createAccumulator(generationsPerSecond);
  const loop = createFrameLoop(frame);
  const store = createStore(firstState(engine, 'velocity-limits'), loop.request);
  const finalTime = () => sceneOf(store.get()).driving.finalTime;
  const actions = createActions(engine, store, paper, finalTime);
  const draw = createDraw(createViews(actions), engine, paper);

  /** @param {number} seconds */
  function frame(seconds) {
    const before = store.get();
    if (before.evolving && !before.dragging) actions.evolve(generations.take(seconds));
    const { robot, speed, evolving } = store.get();
    if (robot.playing) store.update({ robot: advanceRobot(robot, seconds, speed, finalTime(), evolving) });
    draw(store.get(), sceneOf(store.get()));
    return store.get().evolving || store.get().robot.playing;
  }

  byId('tagline').textContent = strings.tagline(store.get().experiment.evolution.population);
  byId('plane-robots').setAttribute('aria-label', strings.planeLabel);
  byId('instrument').hidden = false;
  followSurroundings(store, () => draw(store.get(), sceneOf(store.get())));
  loop.request();
  // After the first picture, which was asked for before this.
  requestAnimationFrame(() => {
    document.documentElement.dataset.ready = 'true';
  });
}

/** @param {Store} store @param {() => void} draw */
function followSurroundings(store, draw) {
  const plane = byId('plane');
  const measure = () => store.update({ size: { width: plane.clientWidth, height: plane.clientHeight } });
  new ResizeObserver(measure).observe(plane);
  // Another pixel density comes without another size.
  addEventListener('resize', measure);
  // At once, because a printer does not wait for the next frame.
  const repaint = () => {
    store.update({ theme: store.get().theme + 1 });
    draw();
  };
  for (const media of ['(prefers-color-scheme: dark)', 'print'])
    matchMedia(media).addEventListener('change', repaint);
}

/** @param {Views} views @param {Engine} engine @param {PaperResult[]} paper */
function createDraw(views, engine, paper) {
  const viewOf = remember(createView);
  const isMoved = remember(
    (/** @type {Experiment} */ experiment, /** @type {Preset} */ preset) =>
      JSON.stringify(endsOf(experiment)) !== JSON.stringify(endsOf(engine.experiment(preset))),
  );

  /** @param {State} state @param {Scene} scene @param {number} time */
  const drawPlane = (state, scene, time) => {
    if (state.size.width === 0) return;
    const view = viewOf(state.box, state.size);
    const ends = endsOf(state.experiment);
    views.plane.draw({ view, scene, ...ends, time, theme: state.theme });
    views.handles.draw({ view, ...ends });
  };

  /** @param {State} state @param {Scene} scene */
  return (state, scene) => {
    const { driver, experiment, history, preset, robot, evolving } = state;
    const { driving } = scene;
    const { generation, best } = history[history.length - 1];
    const time = Math.min(robot.time, driving.finalTime);

    showMessage(state.message);
    views.preset.draw(preset);
    views.drivers.draw(driver);
    drawPlane(state, scene, time);
    views.robotBar.draw({ time, finalTime: driving.finalTime, playing: robot.playing, speed: state.speed });
    views.cost.draw({ title: strings.costTitle(driver), run: driving, note: costNote(scene, driver) });
    views.curve.draw({ history, paper: scene.paperEp.cost.total, theme: state.theme });
    views.evolutionBar.draw({
      evolving,
      generation,
      seed: experiment.evolution.seed,
      note: evolutionNote(state),
    });
    views.gains.draw({
      gains: gainsOf(state, driver, paper),
      errors: state.gainErrors,
      range: sliderRange[preset],
      note: strings.gainsNote(driver, best.cost),
    });
    views.notes.draw({
      ...endsOf(experiment),
      scene,
      driver,
      history,
      time,
      atRest: !robot.playing && !evolving && !state.dragging,
      moved: isMoved(experiment, preset),
    });
  };
}

/** @param {Scene} scene @param {State['driver']} driver */
function costNote({ comparison, paperEp }, driver) {
  return driver === 'paper-ep'
    ? strings.costNote(strings.driverName('paper-arbitrary', 0), comparison.cost.total)
    : strings.costNote(strings.driverName('paper-ep', 0), paperEp.cost.total);
}

/** @param {State} state */
function evolutionNote({ history, evolving, restart, experiment }) {
  const newest = history[history.length - 1];
  if (newest.generation === 0) return strings.restartText(restart, experiment.evolution.population);
  if (!evolving && newest.generation % generationsPerRun === 0) return strings.restText(newest.generation);
  return strings.progressText(history[0], newest);
}

byId('unbuilt').remove();
fillTexts();
const engine = await createEngine().catch((error) => showMessage(strings.coreMissing(messageOf(error))));
if (engine) start(engine);
