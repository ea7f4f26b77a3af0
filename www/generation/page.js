// The part of the page that shows one generation phase by phase, and what its controls do.
import { byId, create } from '../elements.js';
import { createSegmented } from '../segmented.js';
import { watch } from '../state.js';
import { generation as words } from '../words/index.js';
import { createDetails } from './details.js';
import { createPicture } from './picture.js';
import { chosenOf, isInitial, phaseOf, phases } from './record.js';
import { createTable } from './table.js';

/** @typedef {import('../pages.js').PageParts} PageParts */
/** @typedef {import('../state.js').Scene} Scene */
/** @typedef {import('../state.js').State} State */
/** @typedef {import('./record.js').Anatomy} Anatomy */
/** @typedef {import('./record.js').GenerationState} GenerationState */
/** @typedef {import('./record.js').Phase} Phase */

/** @param {PageParts} parts @returns {import('../pages.js').Page} */
export function createGenerationPage({ engine, store, actions, anatomyOf }) {
  /** @param {Partial<GenerationState>} patch */
  const update = (patch) => store.update({ anatomy: { ...store.get().anatomy, ...patch } });
  const choose = (/** @type {number} */ chosen) => {
    update({ chosen });
    actions.driveAgain();
  };
  const steps = createSteps({ store, actions, anatomyOf }, update);
  const segmented = createSegmented(byId('generation-phases'), words.phaseLegend, words.phases, steps.show);
  const picture = createPicture(byId('generation-picture'), { onChoose: choose });
  const details = createDetails(byId('generation-details'), engine.learningRates(), choose);
  const table = createTable(() => anatomyOf(store.get()));
  byId('generation-table').addEventListener('click', table.show);
  byId('generation-back').addEventListener('click', steps.back);
  byId('generation-next').addEventListener('click', steps.next);
  drawKey(byId('generation-key'));
  const changed = watch();

  return {
    name: 'generation',
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const anatomy = anatomyOf(state);
      const phase = phaseOf(anatomy, state.anatomy.phase);
      const chosen = chosenOf(anatomy, state.anatomy);
      picture.draw({ anatomy, phase, chosen, still: state.evolving });
      details.draw({ anatomy, phase, chosen, run: scene.driving, starts: state.experiment.starts.length });
      segmented.draw(phase);
      if (changed(anatomy, phase, state.evolving)) drawTexts(anatomy, phase, state.evolving);
    },
  };
}

/** @param {Anatomy} anatomy @param {Phase} phase @param {boolean} evolving */
function drawTexts(anatomy, phase, evolving) {
  const { generation } = anatomy.record;
  const initial = isInitial(anatomy.record);
  const sentence = byId('generation-sentence');
  // While evolution runs there is too much to say.
  sentence.setAttribute('aria-live', evolving ? 'off' : 'polite');
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

/** The phase before or after one, among those that the generation has. @param {Anatomy} anatomy @param {Phase} phase @param {1 | -1} step @returns {Phase | undefined} */
function phaseAfter({ record }, phase, step) {
  /** @type {readonly Phase[]} */
  const there = isInitial(record) ? ['parents', 'survivors'] : phases;
  return there[there.indexOf(phase) + step];
}

/**
 * From phase to phase, and over the last one into the next generation with whoever is chosen.
 * @param {Pick<PageParts, 'store' | 'actions' | 'anatomyOf'>} parts @param {(patch: Partial<GenerationState>) => void} update
 */
function createSteps({ store, actions, anatomyOf }, update) {
  /** @param {Phase} phase */
  const show = (phase) => {
    store.update({ evolving: false });
    update({ phase });
    actions.driveAgain();
  };
  const shown = () => {
    const state = store.get();
    const anatomy = anatomyOf(state);
    return { state, anatomy, phase: phaseOf(anatomy, state.anatomy.phase) };
  };
  return {
    show,

    next() {
      const { state, anatomy, phase } = shown();
      const following = phaseAfter(anatomy, phase, 1);
      if (following) return show(following);
      actions.oneGeneration();
      if (store.get().generation === state.generation) return;
      const place = anatomy.record.survivors.indexOf(chosenOf(anatomy, state.anatomy));
      update({ phase: 'parents', chosen: state.anatomy.chosen === null || place < 0 ? null : place });
    },

    back() {
      const { state, anatomy, phase } = shown();
      const before = phaseAfter(anatomy, phase, -1);
      if (before) return show(before);
      const chosen = chosenOf(anatomy, state.anatomy);
      actions.oneBack();
      const after = shown();
      if (after.state.generation === state.generation) return;
      const { survivors } = after.anatomy.record;
      update({ phase: 'survivors', chosen: state.anatomy.chosen === null ? null : survivors[chosen] });
      actions.driveAgain();
    },
  };
}

/** How parents and offspring are drawn. @param {HTMLElement} key */
function drawKey(key) {
  key.replaceChildren(
    create('span', 'key parent', words.parentKey),
    create('span', 'key offspring', words.offspringKey),
  );
}
