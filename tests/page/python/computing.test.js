// Python computes with the core's own bits: its answers are those of the core under Node.
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
  /** @type {import('./python.js').Question[]} */
  const questions = [];
  /** @type {unknown[]} */
  const expected = [];
  for (const { experiment, gains } of anyTasks(12)) {
    const [triple] = gains;
    const given = { experiment, triple, landscape, grid, circle };
    for (const [expression, value] of /** @type {const} */ ([
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
    ])) {
      questions.push({ expression, given });
      expected.push(asPython(value));
    }
  }
  valuesFrom(questions).forEach((value, i) => {
    assert.deepEqual(value, expected[i], questions[i].expression);
  });
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

test('a range stands for its two ends, and what is made says what it is', options, () => {
  const [named, listed, rows, part, evolution, task] = valuesFrom(
    [
      "ep.Task({}).trials({'seeds': range(1, 3), 'drives': 40})",
      "ep.Task({}).trials({'seeds': [1, 3], 'drives': 40})",
      "(lambda axis: ep.Task({}).landscape({'x': {'gain': 'kx', **axis}, 'y': {'gain': 'ky', **axis}, 'gains': [3, 1, 4], 'rows': range(1, 3)}))({'from': 1, 'to': 2, 'count': 3})",
      "ep.starts_on_grid({**dict.fromkeys('xy', {'from': 0, 'to': 1, 'count': 2}), 'headings': 1, 'part': range(0, 2)})",
      "repr(ep.Evolution({'evolution': {'seed': 7}}))",
      "repr(ep.Task('acceleration-limits'))",
    ].map((expression) => ({ expression })),
  );
  assert.equal(named.length, 2);
  assert.deepEqual(named, listed);
  assert.equal(rows.length, 6);
  assert.equal(part.length, 2);
  const best = new core.Evolution({ evolution: { seed: 7 } }).statistics().best.cost;
  assert.equal(evolution, `<Evolution: ep, seed 7, generation 0, J ${Number(best.toPrecision(6))}>`);
  assert.equal(task, '<Task of 1 start, shim-kim>');
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
    const plain = [
      'ep.evaluate({}, (10, 10, 10.0))',
      `ep.evaluate({}, ${triples})`,
      `ep.evaluate("velocity-limits", iter(map(tuple, ${triples})))`,
      'ep.evaluate({}, [])',
      "(lambda p, e, t: (e.step(9), p.loads(p.dumps(e)).hash() == e.hash(), p.loads(p.dumps(t)).evaluate([3, 1, 4])))(__import__('pickle'), ep.Evolution({}), ep.Task({}))[1:]",
      `(lambda task: list(__import__('concurrent.futures').futures.ThreadPoolExecutor(4).map(task.evaluate, ${triples} * 50)))(ep.Task({}))`,
    ];
    const ofNumpy = [
      `ep.evaluate({}, numpy.array(${triples}, dtype=float))`,
      `ep.evaluate({}, numpy.array(${triples}, dtype='int32'))`,
      `ep.evaluate({}, numpy.asfortranarray(${triples}))`,
      'ep.evaluate({}, numpy.array([10, 10, 10], dtype="float32"))',
      'ep.evaluate({}, [numpy.float32(10)] * 3)',
      `ep.evaluate({}, list(numpy.array(${triples})))`,
      'ep.evaluate({}, numpy.zeros((0, 3)))',
      `(lambda rows: (rows.__setitem__(slice(None), ${triples} * 2), ep.evaluate({}, rows))[1])(numpy.empty(4, object))`,
      'ep.evaluate({"starts": numpy.zeros((2, 3)), "sampleTime": numpy.float64(0.01)}, [10, 10, 10])',
      'ep.Evolution({}).step(numpy.int64(2))["generation"]',
    ];
    const shapes = ['(3, 2)', '(20,)', '(1, 1, 3)'];
    const [absent, ...answers] = askPython(
      [
        'numpy is None',
        ...plain,
        ...ofNumpy,
        ...shapes.map((shape) => `ep.evaluate({}, numpy.zeros(${shape}))`),
      ].map((expression) => ({ expression })),
    );
    const values = answers.map(({ value, message }) => value ?? message);
    assert.deepEqual(values.splice(0, plain.length), [
      costs[0],
      costs,
      costs,
      [],
      [true, costs[1]],
      Array(50).fill(costs).flat(),
    ]);
    if (absent.value) return;
    assert.deepEqual(values.splice(0, ofNumpy.length), [
      ...Array(3).fill({ array: costs }),
      costs[0],
      costs[0],
      costs,
      { array: [] },
      [...costs, ...costs],
      costs[0],
      2,
    ]);
    assert.deepEqual(
      values.map((message) => String(message).split('but was ')[1]),
      shapes.map((shape) => `an array of shape ${shape}`),
    );
  },
);
