import * as core from '../harness/core.js';

/** @typedef {import('../../../www/core/checks/check.js').Core} Core */
/** @typedef {import('../../../www/core/checks/check.js').Result} Result */
/** @typedef {import('../../../pkg/ep_locomotion.js').GenerationRecord} GenerationRecord */
/** @typedef {import('../../../pkg/ep_locomotion.js').Run} Run */
/** @typedef {import('../../../pkg/ep_locomotion.js').Sample} Sample */

/** The next number after one that is over 0. @param {number} value */
const next = (value) => value * (1 + 2 ** -52);

/** A class whose every object is changed. @template {new (...args: any[]) => object} T @param {T} Class @param {(object: InstanceType<T>) => void} change */
const withObjects = (Class, change) =>
  new Proxy(Class, {
    construct(Original, args) {
      const object = /** @type {InstanceType<T>} */ (new Original(...args));
      change(object);
      return object;
    },
  });

/** @param {(evolution: InstanceType<Core['Evolution']>) => void} change @returns {Core} */
const withEvolution = (change) => ({ ...core, Evolution: withObjects(core.Evolution, change) });

/** A core whose every sample is changed. @param {(sample: Sample) => void} change @returns {Core} */
const withSample = (change) => ({
  ...core,
  Simulation: withObjects(core.Simulation, (robot) => {
    const step = robot.step.bind(robot);
    robot.step = () => {
      const sample = step();
      change(sample);
      return sample;
    };
  }),
});

/** A core whose every run is changed. @param {(run: Run, sampleTime: number) => void} change @returns {Core} */
const withRun = (change) => ({
  ...core,
  simulate(experiment, gains, start) {
    const run = core.simulate(experiment, gains, start);
    change(run, core.experiment(experiment).sampleTime);
    return run;
  },
  simulateAll(experiment, gains, start) {
    const runs = core.simulateAll(experiment, gains, start);
    for (const run of runs) change(run, core.experiment(experiment).sampleTime);
    return runs;
  },
});

/** A core whose every record from generation 1 on is changed. @param {(record: GenerationRecord) => void} change */
const withRecord = (change) =>
  withEvolution((evolution) => {
    const recordOf = evolution.record.bind(evolution);
    evolution.record = (generation) => {
      const record = recordOf(generation);
      if (record.generation > 0) change(record);
      return record;
    };
  });

/** A core whose every draw for a gain is changed. @param {(draw: number) => number} change */
const withGainDraws = (change) =>
  withRecord(({ mutations }) => {
    for (const mutation of mutations) {
      const [x, y, theta] = mutation.gains.map(change);
      mutation.gains = [x, y, theta];
    }
  });

/** What is wrong with a core, and which checks must find it. @type {Record<string, readonly [core: Core, names: Result['name'][]]>} */
export const sabotages = {
  'the command': [withSample((sample) => (sample.command.linear *= 1 + 1e-8)), ['command']],
  'the error posture': [withSample((sample) => (sample.error.y += 1e-9)), ['errorPosture']],
  'the rate of V': [withSample((sample) => (sample.lyapunovRate += 1e-3)), ['lyapunovRate']],
  'a motion by straight pieces': [
    withRun((run, sampleTime) => {
      run.x[run.x.length - 1] += 1e-6 * sampleTime;
    }),
    ['halfArcs', 'circle', 'parts'],
  ],
  'a speed over its limit': [
    withRun((run) => {
      run.linear[5] = 2.5;
    }),
    ['speeds', 'accelerations', 'limitsTwice', 'parts'],
  ],
  'a turn rate that nobody commanded': [
    withRun((run) => {
      run.angular[0] += 1e-3;
    }),
    ['limitsTwice', 'parked', 'parts'],
  ],
  'a cost that is right to six digits only': [
    withRun((run) => (run.cost.total *= 1 + 2e-6)),
    ['run', 'parts', 'lanes', 'lanesFromStarts'],
  ],
  'the last bit of a cost in lanes': [
    { ...core, evaluate: (experiment, gains) => core.evaluate(experiment, gains).map(next) },
    ['lanes', 'offspringCosts'],
  ],
  'a robot with a weak side': [
    {
      ...core,
      evaluate: (experiment, gains) =>
        core
          .evaluate(experiment, gains)
          .map((cost) => (core.experiment(experiment).goal.y < 0 ? next(cost) : cost)),
    },
    ['mirror'],
  ],
  'a start that has another disturbance': [
    {
      ...core,
      fares: (experiment, gains) => {
        const all = core.fares(experiment, gains);
        return { ...all, cost: all.cost.map((cost, i) => (i === 7 ? next(cost) : cost)) };
      },
    },
    ['lanesFromStarts'],
  ],
  'a row of a map': [
    {
      ...core,
      landscape: (experiment, map) =>
        core.landscape(experiment, map).map((cost) => (map.rows?.[0] === 3 ? next(cost) : cost)),
    },
    ['mapRows'],
  ],
  'the gains of the paper': [
    {
      ...core,
      paper: () => core.paper().map((row) => ({ ...row, method: row.method === 'ep' ? 'arbitrary' : 'ep' })),
    },
    ['paperOrder'],
  ],
  'the learning rates': [
    { ...core, learningRates: () => ({ own: 0.5373, common: 0.4082 }) },
    ['learningRates', 'offspringSigmas'],
  ],
  'the gains of an offspring': [
    withRecord(({ offspring }) => (offspring[0].gains[1] += 1e-9)),
    ['offspringGains', 'offspringCosts'],
  ],
  'the σ of an offspring': [
    withRecord(({ offspring }) => (offspring[0].sigmas[1] *= 1.001)),
    ['offspringSigmas'],
  ],
  'draws that lean to one side': [
    withGainDraws((draw) => draw + 0.2),
    ['drawMean', 'offspringGains', 'draws'],
  ],
  'draws that spread too far': [
    withGainDraws((draw) => 1.3 * draw),
    ['drawVariance', 'offspringGains', 'draws'],
  ],
  'the same draws for k and σ': [
    withRecord(({ mutations }) => {
      for (const mutation of mutations) mutation.sigmas = mutation.gains;
    }),
    ['drawCorrelation', 'offspringSigmas', 'draws'],
  ],
  'a bout with oneself': [withRecord(({ opponents }) => (opponents[39][9] = 39)), ['strangers']],
  'a win too many': [withRecord(({ wins }) => (wins[0] += 1)), ['wins']],
  'the wrong survivor': [
    withRecord(({ survivors }) => (survivors[19] = survivors.includes(39) ? 38 : 39)),
    ['survivors', 'parents'],
  ],
  'parents that nobody knows': [
    withRecord(({ parents }) => (parents[3].sigmas[0] *= 2)),
    ['parents', 'offspringGains'],
  ],
  'a best that gets worse': [
    withEvolution((evolution) => {
      const step = evolution.step.bind(evolution);
      evolution.step = () => {
        const statistics = step();
        statistics.best.cost += 0.01 * statistics.generation;
        return statistics;
      };
    }),
    ['neverWorse', 'optimum'],
  ],
  'a machine with other bits': [
    withEvolution((evolution) => {
      const hash = evolution.hash();
      evolution.hash = () => hash;
    }),
    ['hash'],
  ],
  'a run that minds being looked at': [
    withEvolution((evolution) => {
      const recordOf = evolution.record.bind(evolution);
      evolution.record = (generation) => {
        evolution.hash = () => '0123456789abcdef';
        return recordOf(generation);
      };
    }),
    ['watched'],
  ],
};
