// Wires the page: experiment → engine → views. The views get numbers and draw them.
import { createActions, firstState } from './actions.js';
import { createAccumulator, createFrameLoop } from './clocks.js';
import { createEngine } from './engine.js';
import { createDisturbancePage } from './disturbance/page.js';
import { createLandscapePage } from './landscape/page.js';
import { createLuckPage } from './luck/page.js';
import { messageOf } from './messages.js';
import { createRobustnessPage } from './robustness/page.js';
import {
  advanceRobot,
  createScene,
  createStore,
  endsOf,
  gainsOf,
  generationsPerRun,
  generationsPerSecond,
  pageNames,
  remember,
} from './state.js';
import * as strings from './words/en/lab.js';
import { createTrainingPage } from './training/page.js';
import { createView } from './view.js';
import { byId } from './elements.js';
import { createViews, fillTexts, showMessage } from './views.js';

/** @typedef {import('./actions.js').Actions} Actions */
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
  const pages = [
    createLandscapePage,
    createRobustnessPage,
    createTrainingPage,
    createDisturbancePage,
    createLuckPage,
  ].map((create) => create({ engine, store, actions, paper }));

  /** Draws what the state says, then asks the workers for what the open page still lacks. */
  const show = () => {
    const state = store.get();
    const scene = sceneOf(state);
    draw(state, scene);
    for (const page of pages) if (page.name === state.page) page.draw(state, scene);
  };

  /** @param {number} seconds */
  function frame(seconds) {
    const before = store.get();
    if (before.evolving && !before.dragging) actions.evolve(generations.take(seconds));
    const { robot, speed, evolving } = store.get();
    if (robot.playing) store.update({ robot: advanceRobot(robot, seconds, speed, finalTime(), evolving) });
    show();
    return store.get().evolving || store.get().robot.playing;
  }

  byId('plane-robots').setAttribute('aria-label', strings.planeLabel);
  byId('instrument').hidden = false;
  followSurroundings(store, show);
  followLink(store, actions);
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

/** The part of the page that the address names. @param {Store} store @param {Actions} actions */
function followLink(store, actions) {
  const follow = () => {
    const name = location.hash.slice(1) || 'lab';
    const page = pageNames.find((known) => known === name);
    if (page) actions.openPage(page);
    else store.update({ message: strings.unknownPage(name, pageNames) });
  };
  addEventListener('hashchange', follow);
  follow();
}

/** @param {Views} views @param {Engine} engine @param {PaperResult[]} paper */
function createDraw(views, engine, paper) {
  const viewOf = remember(createView);
  const isMoved = remember((/** @type {Experiment} */ experiment, /** @type {Preset} */ preset) => {
    const { starts, goal } = engine.experiment(preset);
    return JSON.stringify([experiment.starts, experiment.goal]) !== JSON.stringify([starts, goal]);
  });

  /** @param {State} state @param {Scene} scene @param {number} time */
  const drawPlane = (state, scene, time) => {
    if (state.size.width === 0) return;
    const view = viewOf(state.box, state.size);
    const ends = endsOf(state);
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
    views.pages.draw(state.page, experiment.evolution.population);
    views.preset.draw(preset);
    views.drivers.draw(driver);
    drawPlane(state, scene, time);
    views.robotBar.draw({ time, finalTime: driving.finalTime, playing: robot.playing, speed: state.speed });
    views.cost.draw({ title: strings.costTitle(driver), run: driving, note: costNote(scene, driver) });
    if (state.page === 'lab')
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
      ...endsOf(state),
      scene,
      driver,
      history,
      time,
      atRest: !robot.playing && !evolving && !state.dragging,
      moved: isMoved(experiment, preset),
      tried: state.trial.start !== null,
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
