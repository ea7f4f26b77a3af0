// What there is to do: to park from every start of a circle; turning is cheap.
/** @import { Engine, Experiment, PaperResult, Run, Triple } from '../../core/engine.js' */
/** @import { Links } from '../../link/link.js' */
/** @import { Group } from '../../run/exercise.js' */
/** @import { State } from '../../run/state.js' */
import { isFree } from '../../run/guard.js';
import { drivesOf } from '../../run/state.js';
import { parkSlice } from './state.js';

/** A robot's drive, and how far its wheels have rolled at each sample, in metres. @typedef {{ run: Run, left: Float64Array, right: Float64Array }} Drive */

/** Around the goal. */
export const circle = { x: 2, y: 2, radius: 2.83, count: 32, seed: 1 };
export const preset = /** @type {const} */ ('velocity-limits');
/** Between the wheels, in metres: as the robots are drawn. */
export const axle = 0.24;

/** @param {Engine} engine */
export function createTask(engine) {
  const starts = engine.startsOnCircle(circle);
  const usual = engine.experiment(preset);
  const base = engine.experiment({
    ...usual,
    starts,
    weights: { ...usual.weights, velocity: [1, 0.1] },
  });
  const lone = base.starts.map((start) => ({ ...base, starts: [start] }));
  return {
    starts,
    goal: base.goal,
    tolerance: base.tolerance,
    radius: circle.radius,
    population: base.evolution.population,

    /** @param {number} seed @returns {Experiment} */
    experiment: (seed) => ({ ...base, evolution: { ...base.evolution, seed } }),

    /** From one start. @param {number} start */
    alone: (start) => lone[start],

    /** From every start, for each triple of gains. @param {readonly Triple[]} gains @returns {Drive[][]} */
    drive(gains) {
      const runs = lone.map((experiment) => engine.drive(experiment, gains));
      return gains.map((_, i) => runs.map((run) => withWheels(run[i])));
    },
  };
}

/** The lab with one of these drives. @param {State} state @param {Experiment} experiment @param {Triple} gains @returns {State} */
export const driveInLab = (state, experiment, gains) => ({
  ...state,
  ...{ page: 'lab', preset, experiment, generation: 0, driver: 'hand', handGains: gains, found: 'hand' },
});

/** The lab with what was found here: by evolution, as far as it came, else by hand; null where nobody has tried. @param {State} state @param {(seed: number) => Experiment} experimentOf @returns {State | null} */
export function inLab(state, experimentOf) {
  const { bred, gains, seed } = parkSlice.of(state);
  const experiment = experimentOf(seed);
  const found = bred.at(-1);
  if (found)
    return { ...state, page: 'lab', preset, experiment, generation: found.generation, driver: 'evolved' };
  return gains && driveInLab(state, experiment, gains);
}

/** The link to it; null where an exercise holds some of what it changes. @param {State} state @param {State} run @param {{ engine: Engine, links: Links }} tools */
export function linkInLab(state, run, { engine, links }) {
  /** @type {Group[]} */
  const changed = [
    'parts',
    'postures',
    'settings',
    'seed',
    'drives',
    run.driver === 'hand' ? 'gains' : 'run',
  ];
  if (!changed.every((group) => isFree(state, group))) return null;
  // What was driven in the lab counts on, in a run that is another.
  const work = { ...state.work, tries: 0, spent: drivesOf({ ...state, driver: 'hand' }) };
  return links.linkOf({ ...run, history: [], work }, engine.experiment);
}

/** With these the sliders begin where the paper's are hidden. @type {Triple} */
export const anyGains = [1, 1, 1];

/** The gains that the sliders begin with. @param {PaperResult[]} paper */
export const firstGains = (paper) =>
  /** @type {PaperResult} */ (paper.find((row) => row.preset === preset && row.method === 'ep')).gains;

/** @param {readonly Drive[]} drives */
export const parkedOf = (drives) => drives.filter(({ run }) => run.arrived).length;

/** @param {Run} run @returns {Drive} */
function withWheels(run) {
  const [left, right] = [new Float64Array(run.time.length), new Float64Array(run.time.length)];
  for (let i = 1; i < run.time.length; i++) {
    const seconds = run.time[i] - run.time[i - 1];
    const turn = (run.angular[i - 1] * axle) / 2;
    left[i] = left[i - 1] + (run.linear[i - 1] - turn) * seconds;
    right[i] = right[i - 1] + (run.linear[i - 1] + turn) * seconds;
  }
  return { run, left, right };
}
