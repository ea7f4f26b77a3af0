// The part of the page that shows one generation phase by phase, and what its controls do.
/** @import { Page, Tools } from '../part.js' */
/** @import { DetailsModel } from './details.js' */
/** @import { Anatomy, Phase } from './record.js' */
import './style.css';
import './chosen.css';
import './places.css';
import { html, render } from 'lit-html';
import { whenThere } from '../../core/pending.js';
import { byIdIn } from '../../kit/elements.js';
import { segmentedOf } from '../../kit/fields.js';
import { watch } from '../../kit/memo.js';
import { unless } from '../../kit/templates.js';
import { showTable } from '../../lab/table-sheet.js';
import { playsPhases } from '../../run/pace.js';
import { orSay } from '../../words/errors.js';
import words from './words/index.js';
import { createSection } from '../section.js';
import { ratesOf } from './birth.js';
import { detailsOf } from './details.js';
import { successesIn } from './detail-methods.js';
import { phasesOf, phasesOfMethod } from './phases.js';
import { createPicture } from './picture.js';
import { chosenOf, createAnatomy, createChosenDrives, isInitial, phaseAfter, phaseOf } from './record.js';
import { generationSlice } from './state.js';
import { createSteps } from './steps.js';
import { generationTable } from './table.js';

/** @param {Tools} tools @returns {Page} */
export function createPage({ engine, store, actions }) {
  const element = createSection('generation', 'generation-section');
  const anatomyOf = createAnatomy(engine.record);
  const steps = createSteps({ store, actions, anatomyOf });
  const choose = (/** @type {number} */ chosen) => {
    generationSlice.update(store, { chosen });
    actions.driveAgain();
  };
  const onTable = () =>
    whenThere(
      orSay(() => showTable(generationTable(anatomyOf(store.get()))), actions.say),
      () => store.get().page === 'generation',
    );
  const onBegin = () => {
    // The button goes away with generation 0.
    byIdIn(element, 'generation-next').focus();
    steps.begin();
  };
  const paperRates = engine.learningRates();
  const on = { choose, steps, onTable, onBegin };
  const changed = watch();
  /** @type {ReturnType<typeof createPicture> | null} */
  let picture = null;

  return {
    element,
    tick: steps.tick,
    drives: createChosenDrives(anatomyOf),

    draw(state, scene) {
      const anatomy = anatomyOf(state);
      const phase = phaseOf(anatomy, generationSlice.of(state).phase);
      const chosen = chosenOf(anatomy, generationSlice.of(state));
      const hurries = state.evolving && !playsPhases(state);
      const starts = state.experiment.starts.length;
      // Only in one phase the drive itself is told.
      const fallen = steps.fallenBefore(state);
      const driving = phase === 'drive' ? scene.driving : null;
      if (changed(anatomy, phase, chosen, fallen, hurries, starts, driving)) {
        const successes = successesIn(anatomy, state.history);
        const rates = ratesOf(paperRates, state.experiment.evolution.adaptation);
        render(
          contentOf({ anatomy, phase, chosen, fallen, run: scene.driving, starts, successes }, hurries, {
            ...on,
            rates,
          }),
          element,
        );
      }
      picture ??= createPicture(element, { onChoose: choose });
      picture.draw({ anatomy, phase, chosen, still: hurries });
    },
  };
}

/**
 * @param {DetailsModel} model @param {boolean} hurries Evolution runs, and not phase by phase: then there is too much to say.
 * @param {Parameters<typeof detailsOf>[1] & { steps: ReturnType<typeof createSteps>, onTable: () => void, onBegin: () => void }} on
 */
function contentOf(model, hurries, { steps, onTable, onBegin, ...context }) {
  const { anatomy, phase } = model;
  const initial = isInitial(anatomy.record);
  const isFirst = initial && phase === 'parents';
  return html`
    <div class="heading">
      <h2 id="generation-title">${words.title(anatomy.record.generation)}</h2>
      <p id="generation-key" class="generation-key muted" data-picture="generation" .hidden=${initial}><span
        class="key parent">${words.keyOf(anatomy, 'parent')}</span><span class="key offspring">${words.keyOf(anatomy, 'offspring')}</span></p>
      <button id="generation-table" type="button" class="link muted" @click=${onTable}>${words.texts.generationTable}</button>
    </div>
    <div class="phases not-in-small-figure">
      ${segmentedOf('generation-phases', words.phaseLegend, choices(anatomy), phase, steps.show)}
      <button id="generation-begin" type="button" class="primary" .hidden=${!initial} @click=${onBegin}>${words.beginText(anatomy)}</button>
    </div>
    <fieldset id="generation-step" class="bar generation-step" aria-label=${words.texts.generationStep}>
      <p id="generation-sentence" aria-live=${hurries ? 'off' : 'polite'}>${words.sentence(anatomy, phase)}</p>
      <button id="generation-back" type="button" class="icon" aria-label=${words.texts.generationBack}
        aria-disabled=${String(isFirst)} @click=${unless(isFirst, steps.back)}>
        <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><path d="M12 2L2 8l10 6z"/></svg>
      </button>
      <button id="generation-next" type="button" class=${initial ? '' : 'primary'} data-other=${allNext(anatomy)} @click=${steps.next}>${words.next}<span>${whereNext(anatomy, phase)}</span></button>
    </fieldset>
    <div id="generation-picture" class="generation-picture picture" data-picture="generation"
      data-name=${words.texts.generationPicture} data-drawn=${phase} role="slider" tabindex="0"
      aria-label=${words.pictureLabel}></div>
    <div id="generation-details" class="generation-details large-figure-only" role="group" aria-label=${words.texts.generationDetails}>
      ${detailsOf(model, context)}
    </div>`;
}

/** Not each generation has all: generation 0 is still to have the others. @param {Anatomy} anatomy */
function choices(anatomy) {
  const there = phasesOf(anatomy);
  const shown = isInitial(anatomy.record) ? there : phasesOfMethod(anatomy.method);
  return shown.map((value) => ({
    value,
    text: words.phaseName(anatomy, value),
    disabled: !there.includes(value),
  }));
}

/** What the button says in one phase or another, a line each. @param {Anatomy} anatomy */
const allNext = (anatomy) =>
  phasesOf(anatomy)
    .map((phase) => words.next + whereNext(anatomy, phase))
    .join('\n');

/** @param {Anatomy} anatomy @param {Phase} phase */
function whereNext(anatomy, phase) {
  const following = phaseAfter(anatomy, phase, 1);
  return following
    ? words.nextPhase(words.phaseName(anatomy, following))
    : words.nextGeneration(anatomy.record.generation + 1);
}
