// Wires the page: experiment → engine → views. The views get numbers and draw them.
import { createActions, firstState } from './run/actions.js';
import { createAddress } from './link/address.js';
import { createAccumulator, createFrameLoop } from './kit/loop.js';
import { createChecks } from './share/checks/dialog.js';
import { createEngine } from './core/engine.js';
import { createCurvesPage } from './parts/curves/page.js';
import { createDisturbancePage } from './parts/disturbance/page.js';
import { isEmbedded } from './kit/host.js';
import { createEmbed } from './embed/page.js';
import { guarded } from './run/guard.js';
import { createMaker } from './share/exercise/maker.js';
import { createExercise } from './share/exercise/page.js';
import { createGenerationPage } from './parts/generation/page.js';
import { createAnatomy, createChosenDrives } from './parts/generation/record.js';
import { createSteps } from './parts/generation/steps.js';
import { clearInstead, showInstead, watchCore } from './instead.js';
import { createKeep } from './share/dialog.js';
import { createKeys } from './share/keys.js';
import { createLandscapePage } from './parts/landscape/page.js';
import { createLesson } from './lesson/page.js';
import { linkOfStep } from './lesson/steps.js';
import { createLuckPage } from './parts/luck/page.js';
import { createRobustnessPage } from './parts/robustness/page.js';
import { advanceRobot, createScene, createStore, endsOf, gainsOf, pausesAt } from './run/state.js';
import { createPinButton } from './lab/pin-button.js';
import { createSettingsPanel } from './settings/panel.js';
import { fitnessTable } from './lab/fitness-table.js';
import { offerTable } from './kit/table.js';
import { curves as curveWords, lab as strings } from './words/index.js';
import { createTrainingPage } from './parts/training/page.js';
import { remember } from './kit/memo.js';
import { forgetColours } from './kit/palette.js';
import { createView } from './kit/transform.js';
import { byId, followSize } from './kit/elements.js';
import { createViews, fillTexts, showMessage } from './lab/views.js';

/** @typedef {import('./run/actions.js').Actions} Actions */
/** @typedef {import('./core/engine.js').Engine} Engine */
/** @typedef {import('./core/engine.js').Experiment} Experiment */
/** @typedef {import('./core/engine.js').PaperResult} PaperResult */
/** @typedef {import('./core/engine.js').Preset} Preset */
/** @typedef {import('./run/state.js').Scene} Scene */
/** @typedef {import('./run/state.js').State} State */
/** @typedef {import('./run/state.js').Store} Store */
/** @typedef {import('./lab/views.js').Views} Views */

const sliderRange = {
  'velocity-limits': /** @type {const} */ ([-2, 12]),
  'acceleration-limits': /** @type {const} */ ([-2, 32]),
};

/** @param {Engine} engine */
function start(engine) {
  const paper = engine.paper();
  const anatomyOf = createAnatomy(engine.record);
  const sceneOf = createScene(engine.drive, paper, createChosenDrives(anatomyOf));
  const generations = createAccumulator();
  const loop = createFrameLoop(frame);
  const store = createStore(firstState(engine, 'velocity-limits'), loop.request);
  const finalTime = () => sceneOf(store.get()).driving.finalTime;
  const actions = createActions(engine, store, paper, finalTime);
  const steps = createSteps({ store, actions, anatomyOf });
  const controls = guarded(actions, store);
  /** @param {string} link */
  const go = (link) => address?.go(link);
  const onLesson = () => go(linkOfStep(store.get().lastStep));
  const draw = createDraw(createViews(controls, onLesson), engine, paper);
  const lesson = createLesson({ engine, store, actions: controls, paper, go });
  const pages = [
    createGenerationPage,
    createCurvesPage,
    createLandscapePage,
    createRobustnessPage,
    createTrainingPage,
    createDisturbancePage,
    createLuckPage,
  ].map((create) => create({ engine, store, actions: controls, paper, anatomyOf, steps }));
  const settings = createSettingsPanel({ engine, store, actions: controls });
  const exercise = createExercise({ engine, store });
  const maker = isEmbedded ? null : createMaker({ engine, store, actions });
  const pinButton = createPinButton({ store, paper }, sceneOf);

  const drivingOf = () => sceneOf(store.get()).driving;
  const embed = isEmbedded ? createEmbed({ engine, store, actions, paper, drivingOf }) : null;

  /** @type {ReturnType<typeof createAddress> | null} */
  let address = null;

  /** Draws what the state says, then asks the workers for what the open page still lacks. */
  const show = () => {
    const state = store.get();
    const scene = sceneOf(state);
    draw(state, scene);
    lesson.draw(state, scene);
    for (const page of pages) if (page.name === state.page) page.draw(state, scene);
    address?.follow(state);
    settings.draw(state);
    exercise.draw(state);
    embed?.draw(state);
    maker?.draw(state);
    pinButton.draw(state, scene);
  };

  /** @param {number} seconds */
  function frame(seconds) {
    const before = store.get();
    steps.tick(before, seconds);
    if (before.evolving && !before.dragging)
      actions.evolve(moreOf(before.catchingUp ? Number.POSITIVE_INFINITY : before.pace, seconds));
    const { robot, speed, evolving } = store.get();
    if (robot.playing) store.update({ robot: advanceRobot(robot, seconds, speed, finalTime(), evolving) });
    show();
    return store.get().evolving || store.get().robot.playing;
  }

  /** As many generations as are due, or as fit into half a frame. @param {number} pace @param {number} seconds */
  function moreOf(pace, seconds) {
    if (Number.isFinite(pace)) {
      let due = generations.take(seconds, pace);
      return () => due-- > 0;
    }
    const end = performance.now() + 8;
    return () => performance.now() < end;
  }

  byId('plane-robots').setAttribute('aria-label', strings.planeLabel);
  byId('instrument').hidden = false;
  const redraw = () => {
    forgetColours();
    store.update({ theme: store.get().theme + 1 });
    show();
  };
  followSurroundings(store, redraw);
  createKeys();
  createChecks(engine);
  offerTable('fitness-table', () => fitnessTable(store.get().history));
  if (!isEmbedded) createKeep({ engine, store, actions, sceneOf });
  address = createAddress(engine, store, actions);
  embed?.begin();
  loop.request();
  // After the first picture, which was asked for before this.
  requestAnimationFrame(() => {
    document.documentElement.dataset.ready = 'true';
  });
}

/** @param {Store} store @param {() => void} redraw */
function followSurroundings(store, redraw) {
  const plane = byId('plane');
  followSize(plane, (size) => store.update({ size }));
  // At once, because a printer does not wait for the next frame.
  for (const media of ['(prefers-color-scheme: dark)', 'print'])
    matchMedia(media).addEventListener('change', redraw);
  // Not every browser tells the page itself that its media is paper.
  for (const [name, prints] of /** @type {const} */ ([
    ['beforeprint', true],
    ['afterprint', false],
  ]))
    addEventListener(name, () => {
      document.documentElement.toggleAttribute('data-printing', prints);
      redraw();
    });
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
    const { pins, theme } = state;
    views.plane.draw({ view, scene, ...ends, pins, pays: state.page === 'curves', time, theme });
    views.handles.draw({ view, ...ends });
  };

  /** What evolution has done: J, or σ. @param {State} state @param {Scene} scene */
  const drawCurve = ({ history, generation, theme, curves }, scene) => {
    const isCost = curves.lab === 'cost';
    byId('curve').hidden = !isCost;
    byId('sigmas').hidden = isCost;
    byId('curve-title').textContent = isCost ? strings.texts.curveTitle : curveWords.sigmaTitle;
    views.curveChoice.draw(curves.lab);
    if (isCost) views.curve.draw({ history, generation, paper: scene.paperEp.cost.total, theme });
    else views.sigmas.draw({ history, generation, theme });
  };

  /** @param {State} state @param {Scene} scene */
  return (state, scene) => {
    const { driver, experiment, history, generation, preset, robot, evolving } = state;
    const { driving } = scene;
    const { best } = history[generation];
    const time = Math.min(robot.time, driving.finalTime);

    showMessage(state.message);
    views.pages.draw(state.page, state.lesson, experiment.evolution.population);
    views.preset.draw(preset);
    views.drivers.draw(driver);
    drawPlane(state, scene, time);
    views.robotBar.draw({ time, finalTime: driving.finalTime, playing: robot.playing, speed: state.speed });
    views.cost.draw({
      title: strings.costTitle(driver, state.found),
      run: driving,
      note: costNote(scene, driver),
    });
    if (state.page === 'lab') drawCurve(state, scene);
    views.evolutionBar.draw({
      evolving,
      generation,
      newest: history.length - 1,
      seed: experiment.evolution.seed,
      pace: state.pace,
      until: state.until,
      untilError: state.untilError,
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
      found: state.found,
      history,
      generation,
      population: state.population.length,
      time,
      pins: state.pins,
      atRest: !robot.playing && !evolving && !state.dragging,
      moved: isMoved(experiment, preset),
      tried: state.trial.start !== null,
    });
  };
}

/** @param {Scene} scene @param {State['driver']} driver */
function costNote({ comparison, paperEp }, driver) {
  return driver === 'paper-ep'
    ? strings.costNote(strings.driverName('paper-arbitrary', 0, 'hand'), comparison.cost.total)
    : strings.costNote(strings.driverName('paper-ep', 0, 'hand'), paperEp.cost.total);
}

/** @param {State} state */
function evolutionNote({ history, generation, evolving, until, restart, experiment }) {
  const shown = history[generation];
  if (history.length === 1) return strings.restartText(restart, experiment.evolution.population);
  if (generation < history.length - 1 && !evolving)
    return strings.recordedText(generation, history.length - 1);
  if (!evolving && pausesAt(until, shown)) return strings.restText(generation);
  return strings.progressText(history[0], shown);
}

document.body.toggleAttribute('data-embed', isEmbedded);
fillTexts();
watchCore();
try {
  start(await createEngine());
  clearInstead();
} catch (error) {
  showInstead(error);
  throw error;
}
