// The generation that is shown, taken apart for the lesson, and the pair that is in question there.
import { generationSlice } from '../parts/generation/state.js';
import { chosenOf, dissect, isInitial } from '../parts/generation/record.js';
import { remember } from '../kit/memo.js';

/** @import { Engine, Experiment, Statistics } from '../core/engine.js' */
/** @import { Anatomy } from '../parts/generation/record.js' */
/** @import { Live } from './page.js' */

const dissected = remember(
  /** @param {Engine} engine @param {Statistics} shown @param {Experiment} experiment */
  (engine, { generation }, experiment) =>
    dissect(engine.record(generation, experiment), experiment.evolution),
);

/** @param {Pick<Live, 'engine' | 'state'>} live */
export const anatomyOf = ({ engine, state: { history, generation, experiment } }) =>
  dissected(engine, history[generation], experiment);

/** The number of the individual that is chosen in the figure, whatever the phase. @param {Live} live */
export const chosenIn = (live) =>
  chosenOf(anatomyOf(live), {
    ...generationSlice.of(live.state),
    phase: isInitial(anatomyOf(live).record) ? 'parents' : 'survivors',
  });

/** The place by J alone, from 1. @param {Anatomy} anatomy @param {number} number */
export const placeByCost = ({ all }, number) => 1 + all.filter(({ cost }) => cost < all[number].cost).length;
