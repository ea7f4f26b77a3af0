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

/** The core's SMALL_TURN: where the reference turns so far in a sample, each robot drives alone, and a sample takes so many times as long. */
const farTurn = 1 / 14;
const alone = 8;

/** In samples: what workers may be asked for at one press, which takes two of them about half an hour. */
const mostOfSurvey = 5e11;

/** In samples: what the core takes in one call, and what a drive counts there at least. */
const mostOfCall = 4e8;
const leastOfDrive = 20;

/** At most, for a robot that never arrives. @param {Experiment} experiment */
export const samplesOfDrive = ({ horizon, sampleTime }) => horizon / sampleTime;

/** A robot drives from every start. @param {Experiment} experiment */
export const samplesOfRobot = (experiment) => experiment.starts.length * samplesOfDrive(experiment);

/** One generation. @param {Experiment} experiment */
function workOfGeneration(experiment) {
  const { evolution, referenceVelocity, sampleTime } = experiment;
  const { population, opponents } = evolution;
  const times = Math.abs(referenceVelocity.angular) * sampleTime >= farTurn ? alone : 1;
  return population * (times * samplesOfRobot(experiment) + 2 * opponents * bout + individual);
}

/** Whether evolution goes on in a worker. @param {Experiment} experiment */
export const isLongEvolution = (experiment) => workOfGeneration(experiment) > mostOfGeneration;

/** The population of a recorded generation. @param {Experiment} experiment @param {number} again How many generations the core computes again for it. */
export const isLongReplay = (experiment, again) => again * workOfGeneration(experiment) > mostOfGeneration;

/** All that happened in a generation, with all meetings of its tournament. @param {Experiment} experiment @param {number} again How many generations the core computes again for the one before. */
export function isLongRecord(experiment, again) {
  const { population, opponents } = experiment.evolution;
  const handed = 2 * population * (individual + opponents * number);
  return (again + 1) * workOfGeneration(experiment) + handed > mostOfGeneration;
}

/** @param {Experiment} experiment @param {number} count How many robots drive from its first start. */
export const isLongDrive = (experiment, count = 1) =>
  samplesOfDrive(experiment) > mostOfRun || count * samplesOfDrive(experiment) > mostOfDrives;

/** Whether so many robots are too many for one press. @param {Experiment} experiment @param {number} robots */
export const isTooLongSurvey = (experiment, robots) => robots * samplesOfRobot(experiment) > mostOfSurvey;

/** How many robots the core drives in one call, each from every start. @param {Experiment} experiment */
export const mostRobotsOfCall = (experiment) =>
  Math.floor(
    mostOfCall / (Math.max(1, experiment.starts.length) * Math.max(leastOfDrive, samplesOfDrive(experiment))),
  );
