// What one can beat by hand: gains whose J is known before.
import { gainsOf } from '../../run/drivers.js';
import { yardOf } from './yard.js';

/** @import { Triple } from '../../core/engine.js' */
/** @import { Live } from '../page.js' */
/** @typedef {{ name: 'fives' | 'arbitrary' | 'ep', cost: number }} Mark */

/** @type {Triple} */
const fives = [5, 5, 5];

/** In the yard, the dearest first. @param {Pick<Live, 'engine' | 'state' | 'paper'>} live @returns {Mark[]} */
export function marksOf({ engine, state, paper }) {
  const yard = yardOf(engine);
  /** @type {[Mark['name'], Triple][]} */
  const known = [
    ['ep', gainsOf(state, 'paper-ep', paper)],
    ['arbitrary', gainsOf(state, 'paper-arbitrary', paper)],
    ['fives', fives],
  ];
  return known
    .map(([name, gains]) => ({ name, cost: yard.drive(state.experiment, gains)?.cost ?? 0 }))
    .sort((a, b) => b.cost - a.cost);
}

/** From the start of the experiment alone. @param {Pick<Live, 'engine' | 'state' | 'paper'>} live @returns {Mark[]} */
export function marksOfDrive({ engine, state, paper }) {
  const names = /** @type {const} */ (['arbitrary', 'ep']);
  const runs = engine.drive(
    state.experiment,
    names.map((name) => gainsOf(state, `paper-${name}`, paper)),
  );
  return names.map((name, i) => ({ name, cost: runs[i].cost.total })).sort((a, b) => b.cost - a.cost);
}
