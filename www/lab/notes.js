// What the pictures say in words: the legend on the plane, the two postures, and the texts for who cannot see them.
/** @import { Experiment, Posture, Run } from '../core/engine.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { endsOf, State } from '../run/state.js' */
import { createSwatch } from '../kit/swatch.js';
import { differenceOf, styles } from '../run/pins.js';
import { isTracking } from '../core/reference.js';
import { html, render } from 'lit-html';
import { announce, settlingMilliseconds } from './announcer.js';
import { byId, write } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { lab as strings, pins as pinWords } from '../words/index.js';

/** What it takes from the state. @typedef {Pick<State, 'driver' | 'found' | 'history' | 'generation' | 'pins'> & ReturnType<typeof endsOf>} Told */
/** `note`: what stands under the bar of evolution; `isToldBeside`: the open part tells how gains drive; `moved`: start or goal is not the paper's; `tried`: the start is one that evolution does not see. @typedef {Told & { scene: Scene, population: number, evolving: boolean, note: string, isToldBeside: boolean, time: number, atRest: boolean, moved: boolean, tried: boolean }} NotesModel */

/** @param {{ onRestore: () => void }} events */
export function createNotes({ onRestore }) {
  const legendChanged = watch();
  const posturesChanged = watch();
  const textChanged = watch();
  const historyChanged = watch();
  const planeText = byId('plane-text');
  const tell = createTelling();

  return {
    /** @param {NotesModel} model */
    draw(model) {
      const { scene, driver, found, history, generation, pins, time, start, goal, moved, tried } = model;
      const { driving, others, comparison, chosen } = scene;
      const told = [driving, others, chosen, driver, found, history, generation, scene.pins];
      if (legendChanged(...told, comparison)) render(legendOf(model), byId('legend'));
      if (posturesChanged(start, goal, moved, tried)) render(posturesOf(model, onRestore), byId('postures'));
      const shownAt = model.atRest ? time : null;
      if (textChanged(...told, shownAt, start, goal))
        write(
          planeText,
          strings.planeText(
            chosen?.name ?? strings.driverName(driver, generation, found),
            driving,
            start,
            goal,
            shownAt === null ? '' : strings.clockText(shownAt, driving.finalTime),
            others.length ? othersText(scene, model.population) : '',
            pinTextsOf(pins, scene.pins, scene.experiment),
          ),
        );
      if (historyChanged(history))
        byId('curve').setAttribute('aria-label', strings.curveLabel(history[0], history[history.length - 1]));
      tell(model);
    },
  };
}

/** What is said of its own accord: how evolution goes, what it has paused at, and how the gains drive that somebody chose. */
function createTelling() {
  const bestChanged = watch();
  const pauseChanged = watch();
  const driveChanged = watch();
  let isThere = false;
  /** @param {NotesModel} model */
  return ({ scene, driver, found, history, generation, evolving, note, isToldBeside, tried }) => {
    const { driving, chosen } = scene;
    const shown = history[generation];
    // Gains that were found elsewhere are told there; those of a map are not.
    const isUntold = driver === 'hand' && found === 'map';
    const isTold =
      !chosen && !tried && (isUntold || (!isToldBeside && (driver !== 'hand' || found === 'hand')));
    // What evolution drives changes by itself.
    const isOther = driveChanged(isTold && (driver === 'evolved' ? driver : driving));
    const isNew = bestChanged(shown);
    const hasPaused = pauseChanged(evolving) && !evolving;
    // What is there from the beginning is read in its place.
    if (!isThere) {
      isThere = true;
      return;
    }
    const best = strings.announcement(shown);
    if (hasPaused)
      announce('lab', note.includes(strings.costText(shown.best.cost)) ? note : `${best}. ${note}`);
    else if (isNew && (evolving || !isOther)) announce('lab', best);
    if (isOther && isTold)
      announce(
        'lab',
        `J ${strings.costText(driving.cost.total)}, ${strings.outcomeText(driving)}`,
        settlingMilliseconds,
      );
  };
}

/** Who drives, and whom that is compared with. @param {Pick<NotesModel, 'scene' | 'driver' | 'found' | 'generation'>} model */
function namesOfRuns({ scene, driver, found, generation }) {
  const { chosen, comparison, comparisonDriver, withoutDisturbance } = scene;
  const rival = chosen?.partner?.name ?? strings.driverName(comparisonDriver, generation, found);
  return {
    solid: chosen?.name ?? strings.driverName(driver, generation, found),
    dashed: withoutDisturbance ? strings.withoutDisturbance : strings.comparisonText(rival, comparison),
    isAlone: comparisonDriver === driver && !withoutDisturbance && !chosen,
  };
}

/** The lines of the legend that one sees, one below the other, and which of them is the dotted run's. @param {State} state @param {Scene} scene @param {{ width: number, height: number }} size */
export function linesOfLegend(state, scene, { width, height }) {
  const { solid, dashed, isAlone } = namesOfRuns({ ...state, scene });
  // As the styles of the lesson have it at usual letters.
  const isBrief = state.lesson > 0 && (height <= 300 || width <= 340);
  const others = scene.others.length > 0 && !isBrief ? [othersText(scene, state.population.length)] : [];
  const pinned = isBrief ? [] : pinTextsOf(state.pins, scene.pins, scene.experiment);
  return { texts: [solid, ...others, ...(isAlone ? [] : [dashed]), ...pinned], solid, dashed };
}

/** Which line is whose. @param {NotesModel} model */
function legendOf(model) {
  const { scene, population, pins } = model;
  const { solid, dashed, isAlone } = namesOfRuns(model);
  return html`
    <li class="solid">${solid}</li>
    <li class="thin" .hidden=${scene.others.length === 0}>${othersText(scene, population)}</li>
    <li class="dashed" .hidden=${isAlone}>${dashed}</li>
    ${pinTextsOf(pins, scene.pins, scene.experiment).map(
      (text, i) => html`<li class="pin">${createSwatch(styles[pins[i].slot])}${text}</li>`,
    )}`;
}

/** With what they drove in that is not what drives now. @param {NotesModel['pins']} pins @param {readonly Run[]} runs @param {Experiment} now */
export const pinTextsOf = (pins, runs, now) =>
  pins.map(({ name, experiment }, i) => pinWords.pinText(name, runs[i], differenceOf(experiment, now)));

/** @param {NotesModel} model @param {() => void} onRestore */
function posturesOf({ start, goal, moved, tried }, onRestore) {
  const isTheirs = !moved && !tried;
  // One text, so that it is one in a saved picture too.
  const named = (/** @type {string} */ name, /** @type {Posture} */ posture) =>
    `${name} ${strings.postureText(posture)}`;
  return html`
    <li id="start-text" class="value">${named(strings.startName, start)}</li>
    <li id="goal-text" class="value">${named(strings.goalName, goal)}</li>
    <li class="hint" .hidden=${!isTheirs}>${strings.dragHint}</li>
    <li class="hint"><button id="restore-postures" type="button" class="link" .hidden=${isTheirs} @click=${onRestore}>${tried ? strings.endTrial : strings.restorePostures}</button></li>`;
}

/** @param {Scene} scene @param {number} population */
function othersText({ others, chosen }, population) {
  const arrived = others.some(isTracking) ? null : others.filter((run) => run.arrived).length;
  return chosen
    ? chosen.othersText(others.length, arrived)
    : strings.othersText({ others: others.length, population, arrived });
}
