// What the pictures say in words: the legend on the plane, the two postures, and the texts for who cannot see them.
import { createSwatch } from '../kit/swatch.js';
import { styles } from '../run/pins.js';
import { isTracking } from '../core/reference.js';
import { watch } from '../kit/memo.js';
import { lab as strings } from '../words/index.js';

/** @typedef {import('../core/engine.js').Posture} Posture */
/** @typedef {import('../core/engine.js').Run} Run */
/** @typedef {import('../core/engine.js').Statistics} Statistics */
/** @typedef {import('../run/state.js').Driver} Driver */
/** @typedef {import('../run/scene.js').Scene} Scene */
/** @typedef {{ legend: HTMLElement, postures: HTMLElement, planeText: HTMLElement, curve: HTMLElement, announcer: HTMLElement }} NotesElements */
/**
 * @typedef {object} NotesModel
 * @property {Posture} start
 * @property {Posture} goal
 * @property {Scene} scene
 * @property {Driver} driver
 * @property {import('../run/state.js').Found} found
 * @property {Statistics[]} history
 * @property {number} generation The one that is shown.
 * @property {number} population
 * @property {number} time
 * @property {import('../run/pins.js').Pins} pins
 * @property {boolean} atRest
 * @property {boolean} moved Start or goal is not the paper's.
 * @property {boolean} tried The start is one that evolution does not see.
 */

/** @param {NotesElements} elements @param {{ onRestore: () => void }} events */
export function createNotes({ legend, postures, planeText, curve, announcer }, { onRestore }) {
  const driving = item(legend, 'solid');
  const others = item(legend, 'thin');
  const comparison = item(legend, 'dashed');
  const start = item(postures, 'value');
  const goal = item(postures, 'value');
  start.id = 'start-text';
  goal.id = 'goal-text';
  const restore = document.createElement('button');
  Object.assign(restore, {
    id: 'restore-postures',
    type: 'button',
    className: 'link',
  });
  restore.addEventListener('click', onRestore);
  const hint = item(postures, 'hint');
  hint.textContent = strings.dragHint;
  item(postures, 'hint').append(restore);

  /** @type {HTMLElement[]} */
  let pinItems = [];
  const pinsChanged = watch();
  const sceneChanged = watch();
  const posturesChanged = watch();
  const restChanged = watch();
  const say = createAnnouncer(announcer);

  /** @param {NotesModel} model */
  const describe = ({
    scene,
    driver,
    found,
    history,
    generation,
    population,
    time,
    start: from,
    goal: to,
    pins,
  }) => {
    planeText.textContent = strings.planeText(
      scene.chosen?.name ?? strings.driverName(driver, generation, found),
      scene.driving,
      from,
      to,
      strings.clockText(time, scene.driving.finalTime),
      scene.others.length ? othersText(scene, population) : '',
      pins.map(({ name }, i) => strings.comparisonText(name, scene.pins[i])),
    );
    curve.setAttribute('aria-label', strings.curveLabel(history[0], history[history.length - 1]));
  };

  return {
    /** @param {NotesModel} model */
    draw(model) {
      const { scene, driver, found, history, generation, moved, tried } = model;
      const { chosen } = scene;
      if (
        sceneChanged(
          scene.driving,
          scene.others,
          scene.comparison,
          chosen,
          driver,
          found,
          history,
          generation,
        )
      ) {
        const rival = chosen?.partner?.name ?? strings.driverName(scene.comparisonDriver, generation, found);
        driving.textContent = chosen?.name ?? strings.driverName(driver, generation, found);
        others.textContent = othersText(scene, model.population);
        others.hidden = scene.others.length === 0;
        comparison.textContent = scene.withoutDisturbance
          ? strings.withoutDisturbance
          : strings.comparisonText(rival, scene.comparison);
      }
      if (pinsChanged(scene.pins)) {
        for (const one of pinItems) one.remove();
        pinItems = model.pins.map(({ slot, name }, i) => {
          const one = item(legend, 'pin');
          one.append(createSwatch(styles[slot]), strings.comparisonText(name, scene.pins[i]));
          return one;
        });
      }
      if (posturesChanged(model.start, model.goal, moved, tried)) {
        start.textContent = `${strings.startName} ${strings.postureText(model.start)}`;
        goal.textContent = `${strings.goalName} ${strings.postureText(model.goal)}`;
        hint.hidden = moved || tried;
        restore.hidden = !moved && !tried;
        restore.textContent = tried ? strings.endTrial : strings.restorePostures;
      }
      const silent = !planeText.textContent;
      if (
        (model.atRest || silent) &&
        restChanged(
          scene.driving,
          scene.others,
          scene.pins,
          history,
          generation,
          model.time,
          model.start,
          model.goal,
        )
      )
        describe(model);
      say(strings.announcement(history[generation]));
    },
  };
}

/** @param {Scene} scene @param {number} population */
function othersText({ others, chosen }, population) {
  const arrived = others.some(isTracking) ? null : others.filter((run) => run.arrived).length;
  return chosen
    ? chosen.othersText(others.length, arrived)
    : strings.othersText({ others: others.length, population, arrived });
}

/** @param {HTMLElement} list @param {string} className */
function item(list, className) {
  const element = document.createElement('li');
  element.className = className;
  list.append(element);
  return element;
}

/** Speaks the newest sentence, at most every two seconds. @param {HTMLElement} region */
function createAnnouncer(region) {
  const pauseMilliseconds = 2000;
  let newest = '';
  let waiting = false;
  const speak = () => {
    waiting = false;
    if (region.textContent === newest) return;
    region.textContent = newest;
    waiting = true;
    setTimeout(speak, pauseMilliseconds);
  };
  return (/** @type {string} */ sentence) => {
    newest = sentence;
    if (!waiting) speak();
  };
}
