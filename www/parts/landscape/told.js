// What is said of the landscape beside its picture.
/** @import { Run, Triple } from '../../core/engine.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Lowest } from './lowest.js' */
/** @import { Spec } from './request.js' */
/** @import { LandscapeState } from './state.js' */
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { isInSlice, thirdOf } from './request.js';
import { landscapeSlice } from './state.js';
import { countOutside } from './view.js';

/** @param {LandscapeState} landscape @param {Spec} spec */
export function noteText({ result, message }, spec) {
  if (message) return words.failed(message, result !== null);
  if (result?.spec !== spec) return words.computing;
  return words.drivesText(result.costs.length * spec.experiment.starts.length, result.milliseconds);
}

/** @param {Triple} gains */
const gainsText = (gains) =>
  lab.gains.map(({ name }, i) => words.gainText(name, gains[i]).replace(' ', '\u00a0')).join(', ');

/** Under the cursor, or of who drives. @param {State} state @param {Spec} spec @param {Run} run @param {Triple} gains */
export function readoutOf(state, spec, run, gains) {
  const { population, driver, generation, found, experiment } = state;
  const who = landscapeSlice.of(state).cursor ? '' : lab.driverName(driver, generation, found);
  const outside = countOutside(spec, population);
  return [
    words.readout(who, gainsText(gains), run, lab.outcomeText(run), experiment.starts.length > 1),
    ...(outside > 0 ? [words.outside(outside)] : []),
  ].join('. ');
}

/** What the marks are, beside their names. @param {State} state @param {Spec} spec @param {readonly { gains: Triple }[]} points Those that have names. */
export function legendOf({ experiment, population }, spec, points) {
  const isProjected = [...population, ...points].some(({ gains }) => !isInSlice(spec, gains));
  const third = lab.gains[thirdOf(spec)].name;
  // A cross of no size is none.
  const isStill = population.every(({ sigmas }) => sigmas.every((sigma) => sigma === 0));
  return [
    words.methodSketch(experiment.evolution.method, isStill),
    ...(isProjected ? [words.paler(third)] : []),
  ].join(' ');
}

/** @param {Lowest} lowest */
export const lowestText = ({ gains, cost, points }) => words.lowestText(points, gainsText(gains), cost);
