// The part of the page that shows one generation phase by phase, and what its controls do.
import { generationSlice } from './state.js';
import { byId, create } from '../../kit/elements.js';
import { createSegmented } from '../../kit/segmented.js';
import { watch } from '../../kit/memo.js';
import { playsPhases } from '../../run/pace.js';
import { generation as words } from '../../words/index.js';
import { createDetails } from './details.js';
import { createPicture } from './picture.js';
import { chosenOf, createAnatomy, createChosenDrives, isInitial, phaseAfter, phaseOf } from './record.js';
import { createSteps } from './steps.js';
import { offerTable } from '../../kit/table.js';
import { generationTable } from './table.js';

/** @typedef {import('../part.js').Tools} PageParts */
/** @typedef {import('../../run/scene.js').Scene} Scene */
/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('./record.js').Anatomy} Anatomy */
/** @typedef {import('./record.js').Phase} Phase */

/** @param {PageParts} parts @returns {import('../part.js').Page} */
export function createGenerationPage({ engine, store, actions }) {
  const anatomyOf = createAnatomy(engine.record);
  const steps = createSteps({ store, actions, anatomyOf });
  const drives = createChosenDrives(anatomyOf);
  const choose = (/** @type {number} */ chosen) => {
    generationSlice.update(store, { chosen });
    actions.driveAgain();
  };
  const segmented = createSegmented(byId('generation-phases'), words.phaseLegend, words.phases, steps.show);
  const picture = createPicture(byId('generation-picture'), { onChoose: choose });
  const details = createDetails(byId('generation-details'), engine.learningRates(), choose);
  offerTable('generation-table', () => generationTable(anatomyOf(store.get())));
  byId('generation-back').addEventListener('click', steps.back);
  byId('generation-next').addEventListener('click', steps.next);
  drawKey(byId('generation-key'));
  const changed = watch();

  return {
    tick: steps.tick,
    drives,

    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const anatomy = anatomyOf(state);
      const phase = phaseOf(anatomy, generationSlice.of(state).phase);
      const chosen = chosenOf(anatomy, generationSlice.of(state));
      const hurries = state.evolving && !playsPhases(state);
      picture.draw({ anatomy, phase, chosen, still: hurries });
      details.draw({ anatomy, phase, chosen, run: scene.driving, starts: state.experiment.starts.length });
      segmented.draw(phase);
      if (changed(anatomy, phase, hurries)) drawTexts(anatomy, phase, hurries);
    },
  };
}

/** @param {Anatomy} anatomy @param {Phase} phase @param {boolean} hurries Evolution runs, and not phase by phase. */
function drawTexts(anatomy, phase, hurries) {
  const { generation } = anatomy.record;
  const initial = isInitial(anatomy.record);
  const sentence = byId('generation-sentence');
  // Then there is too much to say.
  sentence.setAttribute('aria-live', hurries ? 'off' : 'polite');
  sentence.textContent = words.sentence(anatomy, phase);
  byId('generation-title').textContent = words.title(generation);
  byId('generation-key').hidden = initial;
  for (const { value } of words.phases) {
    /** @type {HTMLInputElement} */
    const input = byId(`generation-phases-${value}`);
    input.disabled = initial && value !== 'parents' && value !== 'survivors';
  }
  /** @type {HTMLButtonElement} */
  const back = byId('generation-back');
  back.disabled = initial && phase === 'parents';
  const following = phaseAfter(anatomy, phase, 1);
  const where = following ? words.nextPhase(following) : words.nextGeneration(generation + 1);
  byId('generation-next').replaceChildren(words.next, create('span', '', where));
}

/** How parents and offspring are drawn. @param {HTMLElement} key */
function drawKey(key) {
  key.replaceChildren(
    create('span', 'key parent', words.parentKey),
    create('span', 'key offspring', words.offspringKey),
  );
}
