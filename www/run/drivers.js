// Whose gains drive.
/** @import { PaperResult, Triple } from '../core/engine.js' */
/** @import { Driver, State } from './state.js' */

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

/** Whom a driver is compared with: paper's choices with evolution, evolution with the paper. @param {Driver} driver @returns {Driver} */
export const rivalOf = (driver) =>
  driver === 'hand' || driver === 'paper-arbitrary' ? 'evolved' : 'paper-arbitrary';
