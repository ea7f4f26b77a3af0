// What the map shows, and asking the workers for it.
/** @import { Engine, Experiment, PaperResult, Robustness, Triple } from '../../core/engine.js' */
/** @import { Driver, State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Grid, Tally } from './grid.js' */
import { robustnessSlice } from './state.js';
import { createRefining } from '../../core/refine.js';
import { once, remember } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { messageAround } from '../around.js';
import { gridAround, tally } from './grid.js';

/** @typedef {'share' | 'time' | 'cost'} Quantity What a colour means. */
/** @typedef {{ experiment: Experiment, gains: Triple, half: number }} Spec */
/** @typedef {{ spec: Spec, grid: Grid, runs: Robustness, tally: Tally, milliseconds: number }} Survey */

/** Positions on an edge, of which one is the goal's. */
const coarse = 25;
export const fine = 81;

/** @param {Survey} survey */
export const isFine = ({ grid }) => grid.x.count === fine;

/** The survey that somebody's gains ask for; the same object while nothing that matters has changed. @param {PaperResult[]} paper */
export function createSpec(paper) {
  const spec = remember(
    /** @param {Experiment} experiment @param {number} half @param {number} kx @param {number} ky @param {number} ktheta @returns {Spec} */
    (experiment, half, kx, ky, ktheta) => ({ experiment, gains: [kx, ky, ktheta], half }),
  );
  return (/** @type {State} */ state, /** @type {Driver} */ driver) =>
    spec(state.experiment, robustnessSlice.of(state).half, ...gainsOf(state, driver, paper));
}

/** @param {Engine} engine @param {Store} store */
export function createSurveyRequests(engine, store) {
  // One for both, so that what is compared never keeps the map itself waiting.
  const channel = once(() => engine.surveys.channel());

  /** @param {Spec} spec @param {number} count @returns {Promise<Survey>} */
  const compute = async (spec, count) => {
    const began = performance.now();
    const grid = gridAround(spec.experiment.goal, spec.half, count);
    const asked = { ...grid, gains: [...spec.gains] };
    const runs = await engine.surveys.robustness(spec.experiment, asked, { channel: channel() });
    return { spec, grid, runs, tally: tally(runs), milliseconds: performance.now() - began };
  };
  const { now, update } = robustnessSlice.at(store);
  const onFailure = (/** @type {unknown} */ error) => update({ message: messageAround(error) });
  const own = createRefining({
    counts: [coarse, fine],
    compute,
    onResult: (survey) => update({ survey, message: '' }),
    onFailure,
  });
  const rival = createRefining({
    counts: [fine],
    compute,
    onResult: (survey) => update({ rival: survey, message: '' }),
    onFailure,
  });

  return {
    /** @param {Spec} spec @param {Spec} compared @param {boolean} moving */
    follow(spec, compared, moving) {
      own.follow(spec, moving);
      const { survey } = now();
      if (survey?.spec === spec && isFine(survey) && !moving) rival.follow(compared, false);
    },

    retry() {
      own.retry();
      rival.retry();
    },
  };
}
