// The state with which the page begins.
/** @import { Engine, Preset } from '../core/engine.js' */
/** @import { RobotClock, State } from './state.js' */
import { boxAround } from '../kit/transform.js';
import { firstMaker, noExercise } from './exercise.js';
import { usualUntil } from './pace.js';
import { noPins } from './pins.js';
import { newWork, nothingDone } from './state.js';
import { noVersions } from './undo.js';
import { nobody } from './variant.js';

/** @type {State['tried']} */
export const usualTried = { kind: 'slip', linear: 0.1, angular: 0.2, seed: 1 };

export const noErrors = /** @type {const} */ (['', '', '']);

/** @param {Engine} engine @param {Preset} preset @param {RobotClock} robot @returns {State} */
export function firstState(engine, preset, robot) {
  const experiment = engine.experiment(preset);
  const { statistics, population } = engine.begin(experiment);
  return {
    ...nothingDone,
    page: 'lab',
    lastStep: 1,
    preset,
    experiment,
    history: [statistics],
    population,
    evolving: false,
    catchingUp: null,
    computing: null,
    pace: 8,
    until: usualUntil,
    untilError: '',
    restart: 'begin',
    gainErrors: noErrors,
    tried: usualTried,
    pins: noPins,
    unpinned: null,
    settings: { open: false, error: null },
    exercise: noExercise,
    refusals: 0,
    student: nobody,
    work: newWork(''),
    maker: firstMaker,
    versions: noVersions,
    robot,
    speed: 1,
    dragging: false,
    box: boxAround([experiment.starts[0], experiment.goal]),
    size: { width: 0, height: 0 },
    theme: 0,
    message: '',
    slices: {},
  };
}
