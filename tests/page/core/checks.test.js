// The program's checks of its own numbers: all pass, and each of them fails when what it checks is wrong.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { groupNames } from '../../../www/core/checks/check.js';
import { resultsOf } from '../../../www/core/checks/checks.js';
import { allResults } from '../../../www/core/checks/run.js';
import * as en from '../../../www/share/checks/words/en.js';
import * as ko from '../../../www/share/checks/words/ko.js';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../../../www/core/checks/check.js').Core} Core */
/** @typedef {import('../../../www/core/checks/check.js').Golden} Golden */
/** @typedef {import('../../../www/core/checks/check.js').Result} Result */
/** @typedef {import('../../../www/core/engine.js').Engine} Engine */
/** @typedef {import('../../../pkg/ep_locomotion.js').GenerationRecord} GenerationRecord */
/** @typedef {import('../../../pkg/ep_locomotion.js').Run} Run */
/** @typedef {import('../../../pkg/ep_locomotion.js').Sample} Sample */

const goldenText = await readFile(new URL('../../golden.json', import.meta.url), 'utf8');
/** @type {Golden} */
const golden = JSON.parse(goldenText);

/** @param {Core} [from] @param {Golden} [known] */
const results = (from = core, known = golden) =>
  groupNames.flatMap((group) => resultsOf(from, group, known, () => {}));

/** The names of those that fail, each once. @param {Result[]} all */
const failing = (all) => [...new Set(all.filter(({ passed }) => !passed).map(({ name }) => name))];

test('every check passes in Node, and says in both languages what it is', () => {
  const all = results();
  assert.ok(all.length >= 20);
  assert.deepEqual(
    all.filter(({ passed }) => !passed),
    [],
  );
  const names = new Set([...all.map(({ name }) => name), 'worker']);
  for (const words of [en, ko]) {
    assert.deepEqual(Object.keys(words.sentences).sort(), [...names].sort());
    const sentences = all.map(({ name, about }) =>
      /** @type {(...about: any[]) => readonly string[]} */ (words.sentences[name])(...about),
    );
    assert.equal(new Set(sentences.map(([law]) => law)).size, all.length, 'no two say the same');
    for (const result of all) {
      const said = [words.expectedText(result), words.valuesText(result.found, result)];
      for (const text of [...said, ...sentences.flat()])
        assert.match(text, /^(?!.*(undefined|NaN|null|Infinity)).+$/);
    }
  }
});

test('every known value is looked at: if it were another, its check would fail, and no other', () => {
  const rows = golden.runs.rows.flatMap(({ end }, i) => [
    ['runs', 'rows', i, 'cost'],
    ['runs', 'rows', i, 'finalTime'],
    ...(end ?? []).map((_, j) => ['runs', 'rows', i, 'end', j]),
  ]);
  const { opponents, parent, gains, sigmas, noise } = golden.draws;
  const triples = Object.entries({ opponents, parent, gains, sigmas, noise });
  /** @type {(readonly [string, (string | number)[][]])[]} */
  const places = [
    [
      'command',
      golden.commands.rows.flatMap((_, i) => [0, 1].map((j) => ['commands', 'rows', i, 'command', j])),
    ],
    ['run', rows],
    [
      'draws',
      [['draws', 'common'], ...triples.flatMap(([name, all]) => all.map((_, i) => ['draws', name, i]))],
    ],
    ['hash', golden.evolutions.map((_, i) => ['evolutions', i, 'hash'])],
  ];
  for (const [name, paths] of places)
    for (const path of paths) {
      const changed = structuredClone(golden);
      /** @type {any} */
      let holder = changed;
      for (const key of path.slice(0, -1)) holder = holder[key];
      const last = path[path.length - 1];
      const value = holder[last];
      holder[last] =
        typeof value === 'string'
          ? value.replace(/^./, (digit) => (digit === '0' ? '1' : '0'))
          : value * 1.00001 + 1e-9;
      const group = /** @type {const} */ ({ command: 'motion', run: 'cost', draws: 'bits', hash: 'bits' })[
        name
      ];
      assert.ok(group);
      const failed = resultsOf(core, group, changed).filter(({ passed }) => !passed);
      assert.deepEqual(
        failed.map((one) => one.name),
        [name],
        path.join('.'),
      );
    }
  for (const cost of /** @type {const} */ ([
    [7.0, 7.6],
    [7.75, 7.8],
  ])) {
    const changed = { ...golden, optimum: { ...golden.optimum, cost } };
    assert.deepEqual(failing(results(core, changed)), ['optimum']);
  }
});

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
    change(run, experiment.sampleTime ?? 0.01);
    return run;
  },
  simulateAll(experiment, gains, start) {
    const runs = core.simulateAll(experiment, gains, start);
    for (const run of runs) change(run, experiment.sampleTime ?? 0.01);
    return runs;
  },
});

/** A core whose every record from generation 1 on is changed. @param {(record: GenerationRecord) => void} change */
const withRecord = (change) =>
  withEvolution((evolution) => {
    const recordOf = evolution.record.bind(evolution);
    evolution.record = (generation) => {
      const record = recordOf(generation);
      if (generation > 0) change(record);
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
const sabotages = {
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
        core.evaluate(experiment, gains).map((cost) => (Number(experiment.goal?.y) < 0 ? next(cost) : cost)),
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

for (const [what, [broken, names]] of Object.entries(sabotages))
  test(`a core with a fault is found out: ${what}`, () => {
    const found = failing(results(broken));
    for (const name of names) assert.ok(found.includes(name), `${name} passes; these fail: ${found}`);
  });

test('there is a fault for every check', () => {
  const found = new Set(Object.values(sabotages).flatMap(([, names]) => names));
  const all = new Set(results().map(({ name }) => name));
  assert.deepEqual(
    [...all].filter((name) => !found.has(name)),
    [],
  );
});

test('what is no number passes nowhere', () => {
  const silent = { ...core, evaluate: () => new Float64Array(1).fill(Number.NaN) };
  const found = failing(results(silent));
  for (const name of /** @type {const} */ (['paperOrder', 'lanes', 'offspringCosts']))
    assert.ok(found.includes(name));
});

test('a worker that computes something else is found out', async () => {
  for (const [hash, passed] of /** @type {const} */ ([
    ['here', true],
    ['there', false],
  ])) {
    const surveys = { channel: () => ({}), checks: async () => [[], []], evolve: async () => ({ hash }) };
    const engine = { surveys, hashOf: () => 'here', experiment: core.experiment };
    const groups = await allResults(/** @type {Engine} */ (/** @type {unknown} */ (engine)), golden, {});
    assert.deepEqual(
      groups.flat().map((one) => [one.name, one.passed]),
      [['worker', passed]],
    );
  }
});
