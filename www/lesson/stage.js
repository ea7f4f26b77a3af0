// What a step is about stays in sight beside its words: in the place of the plane, beside it or under it.
import { byId, create } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { isPredicted } from './blocks.js';
import words from './words/index.js';

/** @import { State } from '../run/state.js' */
/** @import { Block, Live, Tools } from './page.js' */
/** @import { Step } from './steps.js' */

/** Whether it is in sight now. @param {Step | undefined} step @param {State} state */
export function stageOf(step, state) {
  const stage = step?.stage;
  if (!step || !stage || (stage.pages && !stage.pages.includes(state.page))) return null;
  return stage.after && !isPredicted(state, step, stage.after) ? null : stage;
}

/** @param {Tools} tools */
export function createStage(tools) {
  const picture = { 'data-picture': 'step', 'aria-label': words.stage };
  const element = create('section', { id: 'stage', class: 'stage', hidden: '', ...picture });
  byId('sights').after(element);
  /** @type {Block | null} */
  let block = null;
  const stepChanged = watch();
  const placeChanged = watch();

  return {
    /** @param {Step | undefined} step @param {State} state */
    open(step, state) {
      const stage = stageOf(step, state);
      if (placeChanged(stage?.place)) {
        element.hidden = !stage;
        if (stage) document.body.dataset.stage = stage.place;
        else delete document.body.dataset.stage;
      }
      if (!stage) {
        block?.leave?.();
        block = null;
        stepChanged(null);
      } else if (step && stepChanged(step)) {
        block?.leave?.();
        block = stage.create(tools, words.steps[step.name]);
        element.replaceChildren(block.element);
        element.dataset.drawn = step.name;
      }
    },

    /** @param {Live} live */
    draw(live) {
      block?.draw(live);
    },
  };
}
