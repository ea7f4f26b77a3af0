// Whose gains drive.
/** @import { PaperResult, Triple } from '../core/engine.js' */
/** @import { Driver, State } from './state.js' */
import { hidesPaper } from './exercise.js';

/** From where to where a hand's sliders go. */
export const sliderRange = {
  'velocity-limits': /** @type {const} */ ([-2, 12]),
  'acceleration-limits': /** @type {const} */ ([-2, 32]),
};

/**
 * The gains that someone drives with.
 * @param {Pick<State, 'population' | 'handGains' | 'preset'>} state @param {Driver} driver @param {PaperResult[]} paper
 * @returns {Triple}
 */
export function gainsOf(state, driver, paper) {
  if (driver === 'evolved') return state.population[0].gains;
  if (driver === 'hand' && state.handGains) return state.handGains;
  const method = driver === 'paper-arbitrary' ? 'arbitrary' : 'ep';
  const row = paper.find((one) => one.preset === state.preset && one.method === method);
  if (!row) throw new Error(`paper: no ${method} gains for ${state.preset}`);
  return row.gains;
}

/** @param {State['experiment']} experiment */
const isLikePapers = ({ law, limits }) =>
  law === 'shim-kim' && limits.speed !== null && limits.turnRate !== null;

/**
 * Whom who drives is compared with: a choice with evolution, or, before it has begun, with what it found in the paper, for the law and
 * for wheels such as those; evolution with the paper's choice; or, where the paper is hidden, with what was found by hand.
 * @param {Pick<State, 'driver' | 'handGains' | 'exercise' | 'maker' | 'history' | 'experiment'>} state @returns {Driver}
 */
export function rivalOf(state) {
  const { driver, handGains, history, experiment } = state;
  if (driver === 'hand' || driver === 'paper-arbitrary')
    return history.length < 2 && isLikePapers(experiment) && !hidesPaper(state) ? 'paper-ep' : 'evolved';
  if (!hidesPaper(state)) return 'paper-arbitrary';
  return handGains ? 'hand' : 'evolved';
}
