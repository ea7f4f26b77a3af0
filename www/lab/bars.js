// Two clocks that never meet: the robot's bar and evolution's bar.
/** @import { Actions } from '../run/actions/actions.js' */
/** @import { Until } from '../run/pace.js' */
import { html, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { isSeen } from '../kit/elements.js';
import { selectOf } from '../kit/fields.js';
import { watch } from '../kit/memo.js';
import { selectAll, styled, unless, valueIn } from '../kit/templates.js';
import { scrubStep } from '../run/clock.js';
import { nextRest, paces } from '../run/pace.js';
import { lab as strings, texts } from '../words/index.js';

/** @typedef {{ time: number, finalTime: number, playing: boolean, speed: number }} RobotBarModel */
/** `timeline`: the generation that is asked for, which may still be computed; `isMain`: nothing else on the page leads on. @typedef {{ open: string, isMain: boolean, evolving: boolean, generation: number, timeline: number, newest: number, pace: number, until: Until, untilError: string, note: string }} EvolutionBarModel */

const paceChoices = paces.map((one) => /** @type {const} */ ([one, strings.paceText(one)]));

/** How far a slider is filled. @param {number} part */
const filled = (part) => styled('--to', `${100 * part}%`);

/** @param {HTMLElement} root @param {Actions} actions */
export function createRobotBar(root, actions) {
  const changed = watch();
  return {
    /** @param {RobotBarModel} model */
    draw(model) {
      if (changed(...Object.values(model))) render(robotBar(model, actions), root);
    },
  };
}

/** @param {RobotBarModel} model @param {Actions} actions */
function robotBar({ time, finalTime, playing, speed }, actions) {
  const text = strings.clockText(time, finalTime);
  return html`
    <button id="play" type="button" class=${playing ? 'icon playing' : 'icon'}
      aria-label=${playing ? strings.pause : strings.play} @click=${() => actions.togglePlay()}>
      <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path class="when-paused" d="M4 2l10 6-10 6z"/><path class="when-playing" d="M3 2h4v12H3zM9 2h4v12H9z"/></svg>
    </button>
    ${selectOf('speed', texts.speed, strings.speeds, speed, (chosen) => actions.setSpeed(chosen))}
    <span id="clock" class="clock" translate="no">${text}</span>
    <input id="scrub" type="range" min="0" step=${scrubStep(finalTime)} aria-label=${texts.scrub} aria-valuetext=${text}
      .max=${String(finalTime)} .value=${live(String(time))} ${filled(finalTime > 0 ? time / finalTime : 1)}
      @input=${(/** @type {Event} */ event) => actions.scrub(Number(valueIn(event)))}>`;
}

/** @param {HTMLElement} root @param {Actions} actions */
export function createEvolutionBar(root, actions) {
  const changed = watch();
  /** The kind that is asked for, which may have been refused. @type {Until['kind']} */
  let kind = 'every';
  let shown = 0;
  const untilValue = () => /** @type {HTMLInputElement} */ (root.querySelector('#until-value'));
  const on = {
    /** @param {Until['kind']} chosen */
    onKind(chosen) {
      kind = chosen;
      // A start that fits the kind, to be changed.
      if (kind === 'generation') untilValue().value = String(nextRest(shown));
      if (kind === 'cost') untilValue().value = '8';
      on.onValue();
    },
    onValue: () => actions.setUntil(kind, untilValue().value),
  };
  return {
    /** @param {EvolutionBarModel} model */
    draw(model) {
      if (!changed(...Object.values(model))) return;
      if (!model.untilError) kind = model.until.kind;
      shown = model.generation;
      // What was refused stays until the refusal has gone.
      const typed = model.untilError ? untilValue().value : null;
      render(evolutionBar({ ...model, kind, typed }, actions, on), root);
    },
  };
}

/** Where that bar is not in sight, what runs is paused in the head. @param {HTMLElement} button @param {Actions} actions */
export function createPauseButton(button, { pauseEvolution }) {
  button.addEventListener('click', pauseEvolution);
  return {
    /** @param {boolean} evolving */
    draw(evolving) {
      const run = document.getElementById('run');
      button.hidden = !evolving || (run !== null && isSeen(run));
    },
  };
}

/** @param {EvolutionBarModel & { kind: Until['kind'], typed: string | null }} model @param {Actions} actions @param {{ onKind: (chosen: Until['kind']) => void, onValue: () => void }} on */
function evolutionBar(model, actions, { onKind, onValue }) {
  const { open, isMain, evolving, timeline, newest, pace, kind, until, untilError, typed, note } = model;
  const isElsewhere = open !== 'lab';
  const end = Math.max(1, newest);
  return html`
    <fieldset id="evolution-clock" class="bar" aria-label=${texts.evolutionClock}>
      <button id="run" type="button" class=${isMain ? 'primary' : ''}
        data-other=${evolving ? strings.run : strings.pauseEvolution} @click=${() => actions.toggleEvolution()}>${evolving ? strings.pauseEvolution : strings.run}</button>
      <button id="one-back" type="button" class="icon" aria-label=${texts.oneBack} aria-disabled=${String(timeline === 0)}
        @click=${unless(timeline === 0, actions.oneBack)}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="M12 2L2 8l10 6z"/></svg>
      </button>
      <button id="one-generation" type="button" @click=${() => actions.oneGeneration()}>${texts.oneGeneration}</button>
      <input id="timeline" type="range" min="0" step="1" aria-label=${texts.timeline}
        aria-valuetext=${strings.generationText(timeline, newest)}
        .max=${String(newest)} .value=${live(String(timeline))} ${filled(timeline / end)}
        @input=${(/** @type {Event} */ event) => actions.showGeneration(Number(valueIn(event)))}>
    </fieldset>
    <fieldset id="evolution-pace" class="bar" aria-label=${texts.evolutionSection}>
      <button id="reset" type="button" .hidden=${isElsewhere} @click=${() => actions.reset()}>${texts.reset}</button>
      <button id="new-seed" type="button" .hidden=${isElsewhere} @click=${() => actions.newSeed()}>${texts.newSeed}</button>
      ${selectOf('pace', texts.pace, paceChoices, pace, (chosen) => actions.setPace(chosen))}
      <div class="bar" .hidden=${isElsewhere}>
        ${selectOf('until', texts.until, strings.untils, kind, onKind)}
        <input id="until-value" type="text" inputmode="decimal" autocomplete="off" spellcheck="false"
          aria-label=${texts.untilValue} aria-describedby="until-error" aria-invalid=${String(untilError !== '')}
          .value=${typed ?? (until.kind === 'every' ? '' : String(until.value))} .hidden=${kind === 'every'} @change=${onValue}
          @focus=${selectAll}>
      </div>
    </fieldset>
    <p id="until-error" class="field-error" role="alert" .hidden=${untilError === ''}>${untilError}</p>
    <p id="evolution-note" class="muted note">${note}</p>`;
}
