// Python computes with the core's own bits: its answers are those of the core under Node, its refusals say the same.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { areBuilt } from '../../../.tasks/examples.mjs';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';
import { anyDrive, createChance } from '../share/any-drive.js';
import { asPython, askPython, valuesFrom } from './python.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */

const options = { skip: !areBuilt() && 'npm test builds the wheel where Python is' };
const readme = await readFile(new URL('../../../README.md', import.meta.url), 'utf8');
const golden = JSON.parse(await readFile(new URL('../../golden.json', import.meta.url), 'utf8'));

/** Experiments as different as drives are, and the gains of some robots. @param {number} count @returns {{ experiment: Experiment, gains: number[][] }[]} */
function anyTasks(count) {
  const chance = createChance(11);
  return Array.from({ length: count }, () => {
    const [experiment, gains] = anyDrive(chance);
    const others = Array.from({ length: 6 }, () => anyDrive(chance)[1]);
    return { experiment, gains: [gains, ...others].map((triple) => [...triple]) };
  });
}

test('J of random robots in random experiments has the bits that it has under Node', options, () => {
  const tasks = anyTasks(150);
  const values = valuesFrom(
    tasks.map((given) => ({ expression: "ep.evaluate(given['experiment'], given['gains'])", given })),
  );
  tasks.forEach(({ experiment, gains }, i) => {
    assert.deepEqual(values[i], [...core.evaluate(experiment, gains.flat())]);
  });
});

test('a drive, and whatever else is asked of a task, is what it is under Node', options, () => {
  const landscape = {
    x: { gain: 'kx', from: 0, to: 8, count: 5 },
    y: { gain: 'ktheta', from: 1, to: 9, count: 4 },
    gains: [3, 1, 4],
  };
  const range = { from: -2, to: 2, count: 3 };
  const grid = { gains: [3, 1, 4], x: range, y: range, headings: 4 };
  const circle = { x: 1, y: 2, radius: 3, count: 7, seed: 5 };
  for (const { experiment, gains } of anyTasks(12)) {
    const [triple] = gains;
    const given = { experiment, triple, landscape, grid, circle };
    const asked = /** @type {const} */ ([
      ["ep.simulate(given['experiment'], given['triple'])", core.simulate(experiment, triple)],
      ["ep.Task(given['experiment']).experiment", core.experiment(experiment)],
      ["ep.Task(given['experiment']).fares(given['triple'])", core.fares(experiment, triple)],
      ["ep.Task(given['experiment']).stability(given['triple'])", core.stability(experiment, triple)],
      [
        "ep.Task(given['experiment']).landscape(given['landscape'])",
        core.landscape(experiment, /** @type {any} */ (landscape)),
      ],
      ["ep.Task(given['experiment']).robustness(given['grid'])", core.robustness(experiment, grid)],
      ["ep.starts_on_circle(given['circle'])", core.startsOnCircle(circle)],
    ]);
    const values = valuesFrom(asked.map(([expression]) => ({ expression, given })));
    asked.forEach(([expression, value], i) => {
      assert.deepEqual(values[i], asPython(value), expression);
    });
  }
});

test('the core that Python runs asks nothing of whoever runs it', options, async () => {
  const path = new URL('../../../pkg/ep_locomotion_bytes.wasm', import.meta.url);
  const module = await WebAssembly.compile(await readFile(path));
  assert.deepEqual(WebAssembly.Module.imports(module), []);
});

test('tables of fields, the paper’s results and trials are those of the core', options, () => {
  const trials = { seeds: [3, 6], drives: 200 };
  const starts = { x: { from: 0, to: 1, count: 2 }, y: { from: 0, to: 1, count: 2 }, headings: 3 };
  const given = { trials, starts };
  const asked = /** @type {const} */ ([
    ['ep.fields()', core.fields()],
    ['ep.word_fields()', core.wordFields()],
    ['ep.paper()', core.paper()],
    ['ep.experiment()', core.experiment('velocity-limits')],
    ["ep.starts_on_grid(given['starts'])", core.startsOnGrid(starts)],
    ["ep.Task({}).trials(given['trials'])", core.trials({}, /** @type {any} */ (trials))],
  ]);
  const values = valuesFrom(asked.map(([expression]) => ({ expression, given })));
  asked.forEach(([expression, value], i) => {
    assert.deepEqual(values[i], asPython(value), expression);
  });
});

test('what the README shows runs, and says what Node says', options, () => {
  const [, lines] = /```python\n(import ep_locomotion as ep\n.*?)```/s.exec(readme) ?? [];
  const expressions = /** @type {string} */ (lines)
    .split('\n')
    .filter((line) => /^(task|evolution)\./.test(line));
  const setUp = /** @type {string} */ (lines).split('\n').filter((line) => /^(task|evolution) =/.test(line));
  assert.equal(expressions.length + setUp.length, 6);
  const [, one, two, x, best] = valuesFrom([
    { expression: `exec(given, globals())`, given: setUp.join('\n') },
    ...expressions.map((expression) => ({ expression })),
  ]);
  const from = core.experiment({ goal: { x: 3, y: 1, theta: 0 } });
  const costs = [...core.evaluate(from, [10, 10, 10, 3, 0.1, 5])];
  assert.deepEqual([one, two], [costs[0], costs]);
  assert.deepEqual(x, [...core.simulate(from, [10, 10, 10]).x]);
  assert.deepEqual(best.gains, core.evolve(core.experiment('acceleration-limits'), 30).gains);
});

test('the hashes of whole evolutions are the known ones', options, () => {
  const evolved =
    "(lambda e: (e.step(given['generations']), e.hash(), e.generation))(ep.Evolution(ep.experiment(given['preset'], given['changes'])))";
  const values = valuesFrom(
    golden.evolutions.map((/** @type {any} */ given) => ({ expression: evolved, given })),
  );
  assert.ok(golden.evolutions.length > 5);
  golden.evolutions.forEach((/** @type {any} */ { hash, generations }, /** @type {number} */ i) => {
    assert.deepEqual(values[i].slice(1), [hash, generations]);
  });
});

test('statistics, records, populations and the history are those of Node', options, () => {
  const from = { evolution: { seed: 5, population: 8, opponents: 3 } };
  const evolution = new core.Evolution(core.experiment(/** @type {any} */ (from)));
  for (let i = 0; i < 12; i += 1) evolution.step();
  const [value] = valuesFrom([
    {
      expression:
        '(lambda e: [e.step(12), e.statistics(), e.statistics(3), e.record(7), e.population(), e.population(2), e.history])(ep.Evolution(given))',
      given: from,
    },
  ]);
  const history = value.pop();
  assert.deepEqual(
    value,
    asPython([
      evolution.statistics(),
      evolution.statistics(),
      evolution.statistics(3),
      evolution.record(7),
      evolution.population(),
      evolution.population(2),
    ]),
  );
  assert.deepEqual(
    history.map((/** @type {any} */ { generation, drives, best }) => [generation, drives, best]),
    Array.from({ length: 13 }, (_, i) => {
      const { evaluations, best } = evolution.statistics(i);
      return [i, evaluations, best.cost];
    }),
  );
});

/** What the core says under Node when it refuses. @param {() => unknown} call */
function refusal(call) {
  try {
    call();
  } catch (error) {
    return /** @type {Error} */ (error).message;
  }
  assert.fail('it was not refused');
}

test('what is wrong is a ValueError with the words that Node has for it', options, () => {
  const wrong = [
    { gaol: { x: 1, y: 1, theta: 0 } },
    { goal: { x: 1e9 } },
    { goal: { z: 1 } },
    { horizon: 'long' },
    { horizon: null },
    { limits: { speed: -1 } },
    { limits: true },
    { starts: [] },
    { starts: [{ x: 0, y: 0, theta: 'left' }] },
    { law: 'murphy' },
    { weights: { finalError: [1, 2] } },
    { evolution: { population: 1.5 } },
    { evolution: { population: 1e7 } },
    { x: 'a very long name that nobody would give to a field of an experiment' },
  ];
  const answers = askPython(
    wrong.flatMap((given) => [
      { expression: 'ep.evaluate(given, [1, 2, 3])', given },
      { expression: 'ep.Evolution(given)', given },
    ]),
  );
  wrong.forEach((given, i) => {
    const message = refusal(() => core.evaluate(/** @type {any} */ (given), [1, 2, 3]));
    for (const answer of answers.slice(2 * i, 2 * i + 2))
      assert.deepEqual(answer, { error: 'ValueError', message });
  });
});

test('gains of every wrong shape are refused by name', options, () => {
  /** @type {readonly (readonly [string, RegExp])[]} */
  const rows = [
    ['[1, 2]', /^gains must be three numbers .* but was an array of 2$/],
    ['[[1, 2, 3], [1, 2]]', /^gains\[1\] must be three numbers .* but was an array of 2$/],
    ['[[1, 2, 3], 5]', /^gains\[1\] must be three numbers .* but was of type int$/],
    ['[[1, 2, 3], [1, 2, math.nan]]', /^kθ \(gains\[5\]\) must be a finite number, but was NaN$/],
    ['[1, math.inf, 1]', /^ky must be a finite number, but was Infinity$/],
    ['[10**400, 1, 1]', /^kx must be a finite number, but was Infinity$/],
    ['[1, "a", 3]', /^ky must be a number, but was 'a'$/],
    ['[True, 2, 3]', /^kx must be a number, but was true$/],
    ['[1, None, 3]', /^ky must be a number, but was null$/],
    ['[1, 2, {}]', /^kθ must be a number, but was of type object$/],
    ['[[1, 2, set()]]', /^kθ must be a number, but was of type set$/],
    ['"abc"', /^gains must be three numbers .* but was of type str$/],
    ['5', /^gains must be three numbers .* but was of type int$/],
    ['None', /^gains must be three numbers .* but was of type NoneType$/],
    ['{"kx": 1}', /^gains must be three numbers .* but was of type dict$/],
    ['[[1, 2, 3]] * 1_000_001', /^gains must be at most 3000000 numbers, but was 3000003 numbers$/],
    ['[[1, 2, 3]] * 3_000_000', /^what is given must be at most \d+ bytes/],
  ];
  const answers = askPython(rows.map(([gains]) => ({ expression: `ep.evaluate({}, ${gains})` })));
  rows.forEach(([gains, message], i) => {
    assert.equal(answers[i].error, 'ValueError', gains);
    assert.match(String(answers[i].message), message, gains);
  });
});

test('whatever else is wrong is refused, and nothing is lost by it', options, () => {
  const before = core.evaluate({}, [10, 10, 10])[0];
  /** @type {readonly (readonly [string, string, RegExp])[]} */
  const rows = [
    ['ep.evaluate("hello", [1, 2, 3])', 'ValueError', /^experiment must be 'velocity-limits' or/],
    ['ep.evaluate(5, [1, 2, 3])', 'ValueError', /^experiment must be an object, but was 5$/],
    [
      'ep.evaluate({"goal": ep}, [1, 2, 3])',
      'ValueError',
      /^goal must be an object, but was of type module$/,
    ],
    [
      '(lambda a: (a.append(a), ep.evaluate({"starts": a}, [1, 2, 3])))([])',
      'ValueError',
      /nested less deeply$/,
    ],
    ['ep.simulate({}, [1, 2, 3], 1)', 'ValueError', /^start must be a whole number from 0 to 0, but was 1$/],
    ['ep.simulate({}, [1, 2, 3], "0")', 'ValueError', /^start must be a number, but was '0'$/],
    ['ep.simulate({}, [[1, 2, 3]] * 2)', 'ValueError', /^gains must be three numbers/],
    [
      'ep.evaluate({"horizon": 1e5, "sampleTime": 1}, [[1, 2, 3]] * 5000)',
      'ValueError',
      /at most 4000 with 1 starts/,
    ],
    ['ep.Evolution({}).step(0)', 'ValueError', /^generations must be a whole number from 1, but was 0$/],
    [
      'ep.Evolution({}).statistics(1)',
      'ValueError',
      /^generation must be a whole number from 0 to 0, the newest, but was 1$/,
    ],
    ['ep.Evolution({}).record(0.5)', 'ValueError', /^generation must be a whole number/],
    ['ep.nothing', 'AttributeError', /no attribute 'nothing'/],
  ];
  const last = { expression: 'ep.evaluate({}, [10, 10, 10])' };
  const answers = askPython([...rows.map(([expression]) => ({ expression })), last]);
  rows.forEach(([expression, error, message], i) => {
    assert.equal(answers[i].error, error, expression);
    assert.match(String(answers[i].message), message, expression);
  });
  assert.equal(answers.at(-1)?.value, before);
});

test(
  'a mistake of the core is told with its message, and what asked goes on with another core',
  options,
  () => {
    const expression = (/** @type {string} */ begin, /** @type {string} */ ask) =>
      `(names := globals(), names.__setitem__('it', ${begin}), ${ask})[2]`;
    const [begun, task, again, evolution, hash, shared, fields] = askPython([
      { expression: expression('ep.Task({})', 'it.evaluate([10, 10, 10])') },
      { expression: "it._core.call('nothing')" },
      { expression: 'it.evaluate([10, 10, 10])' },
      { expression: expression('ep.Evolution({})', "(it.step(5), it._core.call('nothing'))") },
      { expression: '(it.hash(), it.generation, it.step()["generation"])' },
      { expression: "__import__('ep_locomotion')._core._shared().call('nothing')" },
      { expression: 'len(ep.fields())' },
    ]);
    for (const { error, message } of [task, evolution, shared]) {
      assert.equal(error, 'InternalError');
      assert.match(String(message), /^ep-locomotion: internal error \(.*there is no call nothing\)$/s);
      assert.doesNotMatch(String(message), /unreachable/);
    }
    assert.deepEqual(again, begun);
    assert.deepEqual(hash.value, [core.evolve(core.experiment({}), 5).hash, 5, 6]);
    assert.equal(fields.value, core.fields().length);
  },
);

test(
  'a triple gives a number, a list a list, an array of numpy an array; threads and copies give the same',
  options,
  () => {
    const costs = [...core.evaluate({}, [10, 10, 10, 3, 1, 4])];
    const triples = '[[10, 10, 10], [3, 1, 4]]';
    const [single, list, tuples, empty, copied, threads] = valuesFrom([
      { expression: 'ep.evaluate({}, (10, 10, 10.0))' },
      { expression: `ep.evaluate({}, ${triples})` },
      { expression: `ep.evaluate("velocity-limits", iter(map(tuple, ${triples})))` },
      { expression: 'ep.evaluate({}, [])' },
      {
        expression:
          "(lambda p, e, t: (e.step(9), p.loads(p.dumps(e)).hash() == e.hash(), p.loads(p.dumps(t)).evaluate([3, 1, 4])))(__import__('pickle'), ep.Evolution({}), ep.Task({}))[1:]",
      },
      {
        expression: `(lambda task: list(__import__('concurrent.futures').futures.ThreadPoolExecutor(4).map(task.evaluate, ${triples} * 50)))(ep.Task({}))`,
      },
    ]);
    assert.equal(single, costs[0]);
    assert.deepEqual(list, costs);
    assert.deepEqual(tuples, costs);
    assert.deepEqual(empty, []);
    assert.deepEqual(copied, [true, costs[1]]);
    assert.deepEqual(threads, Array(50).fill(costs).flat());
    const [absent] = valuesFrom([{ expression: 'numpy is None' }]);
    if (absent) return;
    const arrays = valuesFrom([
      { expression: `ep.evaluate({}, numpy.array(${triples}, dtype=float))` },
      { expression: `ep.evaluate({}, numpy.array(${triples}, dtype='int32'))` },
      { expression: `ep.evaluate({}, numpy.asfortranarray(${triples}))` },
      { expression: 'ep.evaluate({}, numpy.array([10, 10, 10], dtype="float32"))' },
      { expression: 'ep.evaluate({}, [numpy.float32(10)] * 3)' },
      { expression: `ep.evaluate({}, list(numpy.array(${triples})))` },
      { expression: 'ep.evaluate({}, numpy.zeros((0, 3)))' },
      {
        expression:
          'ep.evaluate({"starts": numpy.zeros((2, 3)), "sampleTime": numpy.float64(0.01)}, [10, 10, 10])',
      },
    ]);
    assert.deepEqual(arrays, [
      ...Array(3).fill({ array: costs }),
      costs[0],
      costs[0],
      costs,
      { array: [] },
      costs[0],
    ]);
    const [shape] = askPython([{ expression: 'ep.evaluate({}, numpy.zeros((3, 2)))' }]);
    assert.match(String(shape.message), /^gains must be .* but was an array of shape \(3, 2\)$/);
  },
);
