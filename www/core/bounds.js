// What may be computed at once, on the page's own thread: so little that it never holds the page for 50 ms.
/** @import { Experiment } from '../../pkg/ep_locomotion.js' */

/** Samples of generations, at about 6 ns each. */
const mostOfGeneration = 1.5e6;
/** Samples of runs that are kept whole, at about 300 ns each: of one call, and of one run, because a scene asks for several. */
const mostOfDrives = 100_000;
const mostOfRun = 10_000;
/** In samples: a bout, an individual that is handed over, and a number of a record that is. */
const bout = 4;
const individual = 300;
const number = 40;
/** Kept by the core: so many bytes of populations, of so many bytes an individual. */
const snapshots = 8 * 2 ** 20;
const bytes = 56;

/** In samples: what workers may be asked for at one press, which takes two of them about half an hour. */
const mostOfSurvey = 5e11;

/** At most, for a robot that never arrives. @param {Experiment} experiment */
export const samplesOfDrive = ({ horizon, sampleTime }) => horizon / sampleTime;

/** A robot drives from every start. @param {Experiment} experiment */
export const samplesOfRobot = (experiment) => experiment.starts.length * samplesOfDrive(experiment);

/** One generation. @param {Experiment} experiment */
function workOfGeneration(experiment) {
  const { population, opponents } = experiment.evolution;
  return population * (samplesOfRobot(experiment) + 2 * opponents * bout + individual);
}

/** A recorded generation, which is computed again from the last one that the core has kept. @param {Experiment} experiment @param {number} newest @param {number} generation */
function workOfReplay(experiment, newest, generation) {
  if (generation === newest) return 0;
  const kept = snapshots / (bytes * experiment.evolution.population);
  const interval = 2 ** Math.max(0, Math.ceil(Math.log2(newest / kept)));
  return (generation % interval) * workOfGeneration(experiment);
}

/** Whether evolution goes on in a worker. @param {Experiment} experiment */
export const isLongEvolution = (experiment) => workOfGeneration(experiment) > mostOfGeneration;

/** @param {Experiment} experiment @param {number} newest @param {number} generation */
export const isLongReplay = (experiment, newest, generation) =>
  workOfReplay(experiment, newest, generation) > mostOfGeneration;

/** With all meetings of its tournament. @param {Experiment} experiment @param {number} newest @param {number} generation */
export function isLongRecord(experiment, newest, generation) {
  const { population, opponents } = experiment.evolution;
  const handed = 2 * population * (individual + opponents * number);
  const parents = Math.max(0, generation - 1);
  const computed = workOfReplay(experiment, newest, parents) + workOfGeneration(experiment);
  return computed + handed > mostOfGeneration;
}

/** @param {Experiment} experiment @param {number} count How many robots drive from its first start. */
export const isLongDrive = (experiment, count = 1) =>
  samplesOfDrive(experiment) > mostOfRun || count * samplesOfDrive(experiment) > mostOfDrives;

/** Whether so many robots are too many for one press. @param {Experiment} experiment @param {number} robots */
export const isTooLongSurvey = (experiment, robots) => robots * samplesOfRobot(experiment) > mostOfSurvey;
