// Two clocks that never meet: the robot's bar, evolution's bar, and the loop that turns real time into both.
import { watch } from './state.js';
import * as strings from './words/en/lab.js';

/** @typedef {import('./engine.js').Statistics} Statistics */

/** After a hidden tab or a long frame, no more than this much time is made up for. */
const longestFrame = 0.25;

/**
 * Calls `frame` once for each animation frame in which something was requested or is moving.
 * @param {(seconds: number) => boolean} frame Gets the real seconds since the last frame of an unbroken row; true asks for another.
 */
export function createFrameLoop(frame) {
  let requested = false;
  let last = Number.NaN;
  const run = (/** @type {number} */ now) => {
    requested = false;
    const seconds = Number.isNaN(last) ? 0 : Math.min(longestFrame, Math.max(0, (now - last) / 1000));
    const again = frame(seconds);
    last = again ? now : Number.NaN;
    if (again) request();
  };
  const request = () => {
    if (requested) return;
    requested = true;
    requestAnimationFrame(run);
  };
  return { request };
}

/** Whole generations out of real time. @param {number} perSecond */
export function createAccumulator(perSecond) {
  let owed = 0;
  return {
    /** @param {number} seconds */
    take(seconds) {
      owed += seconds * perSecond;
      const whole = Math.floor(owed);
      owed -= whole;
      return whole;
    },
  };
}

/** @typedef {{ play: HTMLButtonElement, speed: HTMLSelectElement, clock: HTMLElement, scrub: HTMLInputElement }} RobotBarElements */
/** @typedef {{ onPlay: () => void, onSpeed: (speed: number) => void, onScrub: (time: number) => void }} RobotBarEvents */

/** @param {RobotBarElements} elements @param {RobotBarEvents} events */
export function createRobotBar({ play, speed, clock, scrub }, events) {
  speed.replaceChildren(...strings.speeds.map(([value, text]) => new Option(text, String(value))));
  play.addEventListener('click', events.onPlay);
  speed.addEventListener('change', () => events.onSpeed(Number(speed.value)));
  scrub.addEventListener('input', () => events.onScrub(scrub.valueAsNumber));
  const changed = watch();
  return {
    /** @param {{ time: number, finalTime: number, playing: boolean, speed: number }} model */
    draw(model) {
      if (!changed(model.time, model.finalTime, model.playing, model.speed)) return;
      play.classList.toggle('playing', model.playing);
      play.setAttribute('aria-label', model.playing ? strings.pause : strings.play);
      speed.value = String(model.speed);
      const text = strings.clockText(model.time, model.finalTime);
      clock.textContent = text;
      scrub.max = String(model.finalTime);
      scrub.value = String(model.time);
      scrub.setAttribute('aria-valuetext', text);
      scrub.style.setProperty('--to', `${(100 * model.time) / model.finalTime}%`);
    },
  };
}

/**
 * @typedef {object} EvolutionBarElements
 * @property {HTMLButtonElement} run
 * @property {HTMLButtonElement} one
 * @property {HTMLButtonElement} reset
 * @property {HTMLButtonElement} seedButton
 * @property {HTMLElement} seed
 * @property {HTMLElement} generation
 * @property {HTMLElement} note
 */
/** @typedef {{ onRun: () => void, onOne: () => void, onReset: () => void, onNewSeed: () => void }} EvolutionBarEvents */

/** @param {EvolutionBarElements} elements @param {EvolutionBarEvents} events */
export function createEvolutionBar(elements, events) {
  elements.run.addEventListener('click', events.onRun);
  elements.one.addEventListener('click', events.onOne);
  elements.reset.addEventListener('click', events.onReset);
  elements.seedButton.addEventListener('click', events.onNewSeed);
  const changed = watch();
  return {
    /** @param {{ evolving: boolean, generation: number, seed: number, note: string }} model */
    draw(model) {
      if (!changed(...Object.values(model))) return;
      const verb = model.evolving ? strings.pauseEvolution : strings.run;
      // A press in which the text is written again is no click in WebKit.
      if (elements.run.textContent !== verb) elements.run.textContent = verb;
      elements.generation.textContent = String(model.generation);
      elements.seed.textContent = String(model.seed);
      elements.note.textContent = model.note;
    },
  };
}
