// What the lab shows of the state: each view gets the numbers that it draws.
/** @import { Engine, Experiment, PaperResult, Posture, Preset } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Head, Views } from './views.js' */
import { hasSigmas } from '../core/methods.js';
import { byId, write } from '../kit/elements.js';
import { onceAtMost, remember } from '../kit/memo.js';
import { createView } from '../kit/transform.js';
import { gainsOf, sliderRange } from '../run/drivers.js';
import { shownExercise } from '../run/exercise.js';
import { isReached, lastGeneration, pausesAt } from '../run/pace.js';
import { asked, endsOf } from '../run/state.js';
import { sigmas as sigmaWords, lab as strings } from '../words/index.js';
import { linesOfLegend } from './notes.js';
import { placeOfLegend, placeOfName, placeOfPostures } from './plane-corners.js';
import { isSmall } from './plane-names.js';
import { labSlice } from './state.js';
import { showMessage } from './views.js';

/** Of the lab as a whole there are else only its head and its message; of the sliders, nothing; of what is paid of J, nothing at the path; how gains drive is told by the lab, unless the part does; with steps, what leads on stands elsewhere. @typedef {Record<'lab' | 'gains' | 'pays' | 'tells' | 'steps', (state: State) => boolean>} InSight */

/**
 * What there is to draw of the lab, each view by its name.
 * @param {() => Views} createViews Called when the lab is first in sight, or an exercise first hides some of it.
 * @param {Engine} engine @param {PaperResult[]} paper @param {InSight} inSight
 */
export function createDraw(createViews, engine, paper, inSight) {
  const viewsNow = onceAtMost(createViews);
  const viewOf = remember(createView);
  const isMoved = remember((/** @type {Experiment} */ experiment, /** @type {Preset} */ preset) => {
    const { starts, goal } = engine.experiment(preset);
    return JSON.stringify([experiment.starts, experiment.goal]) !== JSON.stringify([starts, goal]);
  });

  /** @param {Views} views @param {State} state @param {Scene} scene @param {number} time */
  const drawPlane = (views, state, scene, time) => {
    if (state.size.width === 0) return;
    const view = viewOf(state.box, state.size);
    const ends = endsOf(state);
    const { pins, theme } = state;
    const pays = inSight.pays(state);
    views.plane.draw({ view, scene, ...ends, pins, pays, time, theme });
    views.handles.draw({ view, ...ends });
    placeWordsOf(state, scene, view, pays && !isSmall(view));
  };

  /** @param {State} state @param {Scene} scene @returns {Record<string, () => void>} */
  const labOf = (state, scene) => {
    const views = viewsNow();
    const { driver, experiment, history, generation, population, preset, robot, speed } = state;
    const { finalTime } = scene.driving;
    const time = Math.min(robot.time, finalTime);
    return {
      drivers: () => views.drivers.draw(driver),
      plane: () => drawPlane(views, state, scene, time),
      robotBar: () => views.robotBar.draw({ time, finalTime, playing: robot.playing, speed }),
      cost: () =>
        views.cost.draw({
          title: strings.costTitle(driver, state.found, population[0].cost <= history[generation].best.cost),
          starts: scene.experiment.starts.length,
          run: scene.driving,
          note: costNote(scene, state),
        }),
      generation: () => write(byId('generation'), String(generation)),
      seed: () => write(byId('seed'), String(experiment.evolution.seed)),
      curve: () => state.page === 'lab' && drawCurve(views, state, scene),
      evolutionBar: () => views.evolutionBar.draw({ ...evolutionOf(state), isMain: !inSight.steps(state) }),
      gains: () =>
        views.gains.draw({
          isShown: inSight.gains(state),
          gains: gainsOf(state, driver, paper),
          errors: state.gainErrors,
          range: sliderRange[preset],
          note: gainsNote(state, scene),
        }),
      notes: () =>
        views.notes.draw({
          ...endsOf(state),
          driver,
          found: state.found,
          history,
          population: population.length,
          ...evolutionOf(state),
          isToldBeside: inSight.tells(state),
          pins: state.pins,
          atRest: !robot.playing && !state.evolving && !state.dragging,
          tried: state.trial.start !== null,
          scene,
          time,
          moved: isMoved(experiment, preset),
        }),
    };
  };

  /** @param {State} state @param {Scene} scene */
  return (state, scene) => {
    // Before they are taken out of the document, where they would not be found.
    if (shownExercise(state).hidden.length > 0) viewsNow();
    return inSight.lab(state) ? labOf(state, scene) : {};
  };
}

/** What stands above all parts, by its name. @param {Head} head @param {State} state @param {string} [waiting] What is open and not there yet. @returns {[string, () => void][]} */
export const headOf = (head, state, waiting) => [
  ['message', () => showMessage(state.message)],
  ['pages', () => head.pages.draw(state.page, state.lesson, state.population.length, waiting)],
  ['preset', () => head.preset.draw(asked(state).preset)],
];

/** @param {State} state @param {Scene} scene @param {View} view @param {boolean} isPaid */
function placeWordsOf(state, scene, view, isPaid) {
  const ends = endsOf(state);
  const { texts, solid, dashed } = linesOfLegend(state, scene, view);
  placeWords(view, scene, ends.start, ends.goal, isPaid, texts.join('\n'), solid, dashed);
}

/** The words that stand in a corner of the plane. */
const placeWords = remember(
  /** @param {View} view @param {Scene} scene @param {Posture} start @param {Posture} goal @param {boolean} isPaid @param {string} texts Each in a line. @param {string} solid @param {string} dashed */
  (view, { driving, comparison, pins }, start, goal, isPaid, texts, solid, dashed) => {
    const standing = { view, ends: { start, goal }, runs: [driving, comparison, ...pins], isPaid };
    const { corner, raised } = placeOfName(standing, solid, dashed);
    const legend = byId('legend');
    legend.dataset.corner = corner;
    legend.style.setProperty('--raised', `${raised}px`);
    const lines = texts.split('\n');
    const whole = placeOfLegend(standing, lines, dashed);
    legend.dataset.at = whole.corner;
    legend.classList.toggle('short', whole.isShort);
    // The second name stands by itself, where the styles of the lesson have it so at usual letters.
    const isFirstAbove = whole.corner === 'top left' && lines.length === 2;
    legend.classList.toggle('apart', view.width <= 440 || (whole.isShort && isFirstAbove));
    const { side, under } = placeOfPostures(standing, lines.length, whole.rooms);
    const postures = byId('postures');
    postures.classList.toggle('left', side === 'left');
    postures.classList.toggle('under', under !== null);
    postures.style.setProperty('--under', `${under}px`);
  },
);

/** Whether evolution counts the drive that is seen, and not the mean over many. @param {State} state */
const isOneDrive = ({ experiment }) => experiment.starts.length === 1;

/** What evolution has done: J, or σ where there is one. @param {Views} views @param {State} state @param {Scene} scene */
function drawCurve(views, state, scene) {
  const { experiment, history, generation, theme } = state;
  const { curve } = labSlice.of(state);
  const hasChoice = hasSigmas(experiment.evolution.method);
  const isCost = curve === 'cost' || !hasChoice;
  byId('curve-choice').hidden = !hasChoice;
  byId('curve').hidden = !isCost;
  byId('sigmas').hidden = isCost;
  write(byId('curve-title'), isCost ? strings.texts.curveTitle : sigmaWords.sigmaTitle);
  views.curveChoice.draw(curve);
  const paper = isOneDrive(state) ? (scene.paperEp?.cost.total ?? null) : null;
  if (isCost) views.curve.draw({ history, generation, paper, theme });
  else views.sigmas.draw({ history, generation, theme });
}

/** @param {State} state @param {Scene} scene */
function gainsNote(state, { comparison, comparisonDriver }) {
  const { driver, found, history, generation, versions } = state;
  if (driver === 'hand' && found !== 'hand' && versions.past.at(-1)?.hand) return strings.gainsReplaced;
  const isPapers = comparisonDriver === 'paper-ep';
  const cost = isPapers ? comparison.cost.total : history[generation].best.cost;
  return strings.gainsNote(driver, isPapers, isOneDrive(state) ? cost : null);
}

/** @param {State} state */
function evolutionOf(state) {
  const { page: open, evolving, generation, history, pace, until, untilError, computing } = state;
  const note = evolutionNote(state);
  const timeline = computing?.generation ?? generation;
  return { open, evolving, generation, timeline, newest: history.length - 1, pace, until, untilError, note };
}

/** @param {Scene} scene @param {State} state */
function costNote(scene, { driver, population, generation, found }) {
  const { comparison, comparisonDriver, paperEp } = scene;
  const { length: starts } = scene.experiment.starts;
  // From one of many starts others may be better.
  if (driver === 'evolved' && starts > 1) return strings.meanNote(starts, population[0].cost);
  if (driver === 'paper-ep')
    return strings.costNote(strings.driverName('paper-arbitrary', 0, 'hand'), comparison.cost.total);
  if (paperEp) return strings.costNote(strings.driverName('paper-ep', 0, 'hand'), paperEp.cost.total);
  return comparisonDriver === driver
    ? ''
    : strings.costNote(strings.driverName(comparisonDriver, generation, found), comparison.cost.total);
}

/** @param {State} state */
export function evolutionNote({ history, generation, evolving, until, restart, experiment, population }) {
  const shown = history[generation];
  const { method, selection } = experiment.evolution;
  const isPapers = method === 'ep' && selection === 'tournament';
  if (history.length === 1) return strings.restartText(restart, population.length, isPapers);
  if (generation < history.length - 1 && !evolving)
    return strings.recordedText(generation, history.length - 1);
  if (!evolving && until.kind === 'cost' && isReached(until, shown))
    return strings.reachedText(until.value, shown);
  // After the last generation none comes.
  if (!evolving && generation < lastGeneration && pausesAt(until, shown)) return strings.restText(generation);
  return strings.progressText(history[0], shown);
}
