// What the pictures say in words: the legend on the plane, the two postures, and the texts for who cannot see them.
import { watch } from './state.js';
import * as strings from './words/en/lab.js';

/** @typedef {import('./engine.js').Posture} Posture */
/** @typedef {import('./engine.js').Run} Run */
/** @typedef {import('./engine.js').Statistics} Statistics */
/** @typedef {import('./state.js').Driver} Driver */
/** @typedef {import('./state.js').Scene} Scene */
/** @typedef {{ legend: HTMLElement, postures: HTMLElement, planeText: HTMLElement, curve: HTMLElement, announcer: HTMLElement }} NotesElements */
/**
 * @typedef {object} NotesModel
 * @property {Posture} start
 * @property {Posture} goal
 * @property {Scene} scene
 * @property {Driver} driver
 * @property {Statistics[]} history
 * @property {number} time
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

  const sceneChanged = watch();
  const posturesChanged = watch();
  const restChanged = watch();
  const say = createAnnouncer(announcer);

  /** @param {NotesModel} model */
  const describe = ({ scene, driver, history, time, start: from, goal: to }) => {
    const newest = history[history.length - 1];
    planeText.textContent = strings.planeText(
      strings.driverName(driver, newest.generation),
      scene.driving,
      from,
      to,
      strings.clockText(time, scene.driving.finalTime),
      scene.others.length ? othersText(scene.others) : '',
    );
    curve.setAttribute('aria-label', strings.curveLabel(history[0], newest));
  };

  return {
    /** @param {NotesModel} model */
    draw(model) {
      const { scene, driver, history, moved, tried } = model;
      const newest = history[history.length - 1];
      if (sceneChanged(scene.driving, scene.others, scene.comparison, driver, newest)) {
        driving.textContent = strings.driverName(driver, newest.generation);
        others.textContent = othersText(scene.others);
        others.hidden = scene.others.length === 0;
        comparison.textContent = strings.comparisonText(
          strings.driverName(scene.comparisonDriver, newest.generation),
          scene.comparison,
        );
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
        restChanged(scene.driving, scene.others, history, model.time, model.start, model.goal)
      )
        describe(model);
      say(strings.announcement(newest));
    },
  };
}

/** @param {Run[]} others */
const othersText = (others) => strings.othersText(others.length, others.filter((run) => run.arrived).length);

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
