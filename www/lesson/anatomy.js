// The generation that is shown, taken apart for the lesson, and the pair that is in question there.
import { generationSlice } from '../parts/generation/state.js';
import { chosenOf, dissect, isInitial } from '../parts/generation/record.js';
import { remember } from '../kit/memo.js';

/** @import { Engine, GenerationRecord, Individual, Statistics } from '../core/engine.js' */
/** @import { Anatomy } from '../parts/generation/record.js' */
/** @import { Live } from './page.js' */
/** @typedef {{ parent: Individual, child: Individual, draws: GenerationRecord['mutations'][number] }} Birth */

const dissected = remember((/** @type {Engine} */ engine, /** @type {Statistics} */ { generation }) =>
  dissect(engine.record(generation)),
);

/** @param {Pick<Live, 'engine' | 'state'>} live */
export const anatomyOf = ({ engine, state }) => dissected(engine, state.history[state.generation]);

/** The number of the individual that is chosen in the figure, whatever the phase. @param {Live} live */
export const chosenIn = (live) =>
  chosenOf(anatomyOf(live), {
    ...generationSlice.of(live.state),
    phase: isInitial(anatomyOf(live).record) ? 'parents' : 'survivors',
  });

/** How a parent had its offspring; null in generation 0, which has none, and in other searches, which draw in other ways. @param {Anatomy} anatomy @param {number} pair @returns {Birth | null} */
export const birthOf = ({ record }, pair) =>
  record.mutations.length === 0
    ? null
    : { parent: record.parents[pair], child: record.offspring[pair], draws: record.mutations[pair] };

/** The place by J alone, from 1. @param {Anatomy} anatomy @param {number} number */
export const placeByCost = ({ all }, number) => 1 + all.filter(({ cost }) => cost < all[number].cost).length;
