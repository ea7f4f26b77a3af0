// Two clocks that never meet: the robot's bar and evolution's bar.
import { write } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { paces } from '../run/pace.js';
import { lab as strings } from '../words/index.js';

/** @typedef {import('../run/pace.js').Until} Until */

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
 * @property {HTMLButtonElement} back
 * @property {HTMLButtonElement} one
 * @property {HTMLInputElement} timeline
 * @property {HTMLSelectElement} pace
 * @property {HTMLSelectElement} until
 * @property {HTMLInputElement} untilValue
 * @property {HTMLElement} untilError
 * @property {HTMLButtonElement} reset
 * @property {HTMLButtonElement} seedButton
 * @property {HTMLElement} seed
 * @property {HTMLElement} generation
 * @property {HTMLElement} note
 */
/**
 * @typedef {object} EvolutionBarEvents
 * @property {() => void} onRun
 * @property {() => void} onOne
 * @property {() => void} onReset
 * @property {() => void} onNewSeed
 * @property {() => void} onBack
 * @property {(generation: number) => void} onShow
 * @property {(pace: number) => void} onPace
 * @property {(kind: Until['kind'], text: string) => void} onUntil
 */
/** @typedef {{ evolving: boolean, generation: number, newest: number, seed: number, pace: number, until: Until, untilError: string, note: string }} EvolutionBarModel */

/** @param {EvolutionBarElements} elements @param {EvolutionBarEvents} events */
export function createEvolutionBar(elements, events) {
  elements.run.addEventListener('click', events.onRun);
  elements.one.addEventListener('click', events.onOne);
  elements.reset.addEventListener('click', events.onReset);
  elements.seedButton.addEventListener('click', events.onNewSeed);
  elements.back.addEventListener('click', events.onBack);
  elements.timeline.addEventListener('input', () => events.onShow(elements.timeline.valueAsNumber));
  elements.pace.replaceChildren(...paces.map((pace) => new Option(strings.paceText(pace), String(pace))));
  elements.pace.addEventListener('change', () => events.onPace(Number(elements.pace.value)));
  elements.until.replaceChildren(...strings.untils.map(([kind, text]) => new Option(text, kind)));
  const { until, untilValue } = elements;
  const kind = () => /** @type {Until['kind']} */ (until.value);
  until.addEventListener('change', () => {
    // A start that fits the kind, to be changed.
    if (kind() === 'generation') untilValue.value = '100';
    if (kind() === 'cost') untilValue.value = '8';
    events.onUntil(kind(), untilValue.value);
  });
  untilValue.addEventListener('focus', () => untilValue.select());
  untilValue.addEventListener('change', () => events.onUntil(kind(), untilValue.value));
  const changed = watch();
  return {
    /** @param {EvolutionBarModel} model */
    draw(model) {
      if (!changed(...Object.values(model))) return;
      const verb = model.evolving ? strings.pauseEvolution : strings.run;
      write(elements.run, verb);
      elements.generation.textContent = String(model.generation);
      elements.seed.textContent = String(model.seed);
      elements.note.textContent = model.note;
      elements.back.disabled = model.generation === 0;
      elements.timeline.max = String(Math.max(1, model.newest));
      elements.timeline.value = String(model.generation);
      elements.timeline.setAttribute(
        'aria-valuetext',
        strings.generationText(model.generation, model.newest),
      );
      elements.timeline.style.setProperty('--to', `${(100 * model.generation) / Math.max(1, model.newest)}%`);
      elements.pace.value = String(model.pace);
      if (!model.untilError) until.value = model.until.kind;
      untilValue.hidden = until.value === 'every';
      untilValue.setAttribute('aria-invalid', String(model.untilError !== ''));
      elements.untilError.textContent = model.untilError;
      elements.untilError.hidden = model.untilError === '';
    },
  };
}
