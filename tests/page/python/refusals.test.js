// What Python gives in vain is refused by name, in the words that the core has for it under Node.
import assert from 'node:assert/strict';
import { areBuilt } from '../../../.tasks/examples.mjs';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';
import { askPython } from './python.js';

const options = { skip: !areBuilt() && 'npm test builds the wheel where Python is' };

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
    ['[[1, 2, 3], [1, 2, math.nan]]', /^kθ \(gains\[1\]\) must be a finite number, but was NaN$/],
    [
      '[[1, 2, 3]] * 4 + [[1, "(gains[13])", 3]]',
      /^ky \(gains\[4\]\) must be a number, but was '\(gains\[13\]\)'$/,
    ],
    ['[1, math.inf, 1]', /^ky must be a finite number, but was Infinity$/],
    ['[10**400, 1, 1]', /^kx must be a finite number, but was Infinity$/],
    ['[1, "a", 3]', /^ky must be a number, but was 'a'$/],
    ['[True, 2, 3]', /^kx must be a number, but was true$/],
    ['[1, None, 3]', /^ky must be a number, but was null$/],
    ['[1, 2, {}]', /^kθ must be a number, but was of type object$/],
    ['[[1, 2, set()]]', /^kθ must be a number, but was of type set$/],
    ['[{"kx": 1}] * 20', /^gains\[0\] must be three numbers \(kx, ky, kθ\), but was of type dict$/],
    ['ep.Evolution({}).population()[:3]', /^gains\[0\] must be three numbers .* but was of type dict$/],
    ['[1] * 20', /^gains must be three numbers .* but was an array of 20$/],
    ['"abc"', /^gains must be three numbers .* but was of type str$/],
    ['5', /^gains must be three numbers .* but was of type int$/],
    ['None', /^gains must be three numbers .* but was of type NoneType$/],
    // They would stand in any order.
    ['{3, 0.1, 5}', /^gains must be three numbers .* but was of type set$/],
    ['[frozenset([3, 0.1, 5])]', /^gains\[0\] must be three numbers .* but was of type frozenset$/],
    ['[[3, 0.1, 5], {3, 0.1, 5}]', /^gains\[1\] must be three numbers .* but was of type set$/],
    ['{"kx": 1}', /^gains must be three numbers .* but was of type dict$/],
    ['[[1, 2, 3]] * 1_000_001', /^gains must be at most 3000000 numbers, but was 3000003 numbers$/],
  ];
  const answers = askPython(rows.map(([gains]) => ({ expression: `ep.evaluate({}, ${gains})` })));
  rows.forEach(([gains, message], i) => {
    assert.equal(answers[i].error, 'ValueError', gains);
    assert.match(String(answers[i].message), message, gains);
  });
});

test('what is masked is missing, whatever number stands under the mask', options, () => {
  const row = 'numpy.ma.array([3, 0.1, 5], mask=[0, 1, 0])';
  const table = 'numpy.ma.array([[10, 10, 10], [3, 0.1, 5]], mask=[[0, 0, 0], [0, 1, 0]])';
  const kinds = "dtype=[('kx', float), ('ky', float), ('ktheta', float)]";
  /** @type {readonly (readonly [string, RegExp])[]} */
  const rows = [
    [`ep.evaluate({}, ${table})`, /^ky .*must be a number, but was null$/],
    [`ep.evaluate({}, ${row})`, /^ky must be a number, but was null$/],
    [`ep.evaluate({}, [list(${row})])`, /^ky must be a number, but was null$/],
    [`ep.evaluate({}, numpy.ma.array([(3, 0.1, 5)], mask=[(0, 1, 0)], ${kinds}))`, /^ky must be .* null$/],
    [`ep.simulate({}, ${row})`, /^ky must be a number, but was null$/],
    [`ep.EpLocomotion(gains=${row}).gains`, /^ky must be a finite number, but was None$/],
    [`ep.Task({'starts': [list(${row})]}).experiment`, /^starts\[0\]\.y must be .*, but was null$/],
    ["ep.Task({'goal': {'x': numpy.ma.masked}}).experiment", /^goal\.x must be .*, but was null$/],
  ];
  const [absent, none, scalars, ...answers] = askPython(
    [
      'numpy is None',
      'ep.evaluate({}, numpy.ma.array([[10, 10, 10], [3, 0.1, 5]]))',
      'ep.evaluate({}, [[numpy.array(10)] * 3, [3, numpy.float64(0.1), numpy.int64(5)]])',
      ...rows.map(([expression]) => expression),
    ].map((expression) => ({ expression })),
  );
  if (absent.value) return;
  rows.forEach(([expression, message], i) => {
    assert.equal(answers[i].error, 'ValueError', expression);
    assert.match(String(answers[i].message), message, expression);
  });
  const costs = [...core.evaluate({}, [10, 10, 10, 3, 0.1, 5])];
  assert.deepEqual([none.value, scalars.value], [{ array: costs }, costs]);
});

test('a table of starts has rows of three numbers, or is refused by name', options, () => {
  const table = (/** @type {string} */ rows, width = 3) =>
    `__import__('types').SimpleNamespace(ndim=2, shape=(len(${rows}), ${width}), tolist=lambda: ${rows})`;
  const ofPandas = (/** @type {string} */ rows) =>
    `__import__('types').SimpleNamespace(ndim=2, to_numpy=lambda: ${table(rows)})`;
  const startsOf = (/** @type {string} */ starts) => ({
    expression: `ep.Task({'starts': ${starts}}).experiment['starts']`,
  });
  const postures = [
    { x: 0, y: 1, theta: 2 },
    { x: 3, y: 4, theta: 5 },
  ];
  const rows = '[[0, 1, 2.0], [3, 4, 5]]';
  /** @type {readonly (readonly [string, RegExp])[]} */
  const wrong = [
    [
      table('[[0, 0], [1, 0], [0, 1]]', 2),
      /^starts\[0\] must be three numbers \(x, y, θ\), but was an array of 2$/,
    ],
    [
      table('[[0, 1, 2, 3]] * 3', 4),
      /^starts\[0\] must be three numbers \(x, y, θ\), but was an array of 4$/,
    ],
    ['[[0, 0, 0], [1, 1]]', /^starts\[1\] must be three numbers \(x, y, θ\), but was an array of 2$/],
    ['[0, 1, 2]', /^starts\[0\] must be an object, but was 0$/],
    [table("[['0', '1', '2']]"), /^starts\[0\]\.x must be a number .*, but was '0'$/],
    [table('[[True, False, True]]'), /^starts\[0\]\.x must be a number .*, but was true$/],
    [table('[[1, 2, 3j]]'), /^starts\[0\]\.theta must be a number .*, but was /],
    [ofPandas("[['a', 1, None]]"), /^starts\[0\]\.x must be a number .*, but was 'a'$/],
    [table('[[0, 1, 10**400]]'), /^starts\[0\]\.theta must be a number from .*, but was Infinity$/],
    ["__import__('types').SimpleNamespace(ndim=2, shape=(1, 3))", /^starts must be .* SimpleNamespace$/],
  ];
  const [one, other, ...answers] = askPython(
    [table(rows), ofPandas(rows), ...wrong.map(([starts]) => starts)].map(startsOf),
  );
  assert.deepEqual([one.value, other.value], [postures, postures]);
  wrong.forEach(([starts, message], i) => {
    assert.equal(answers[i].error, 'ValueError', starts);
    assert.match(String(answers[i].message), message, starts);
  });
});

test('whatever else is wrong is refused, and nothing is lost by it', options, () => {
  const before = core.evaluate({}, [10, 10, 10])[0];
  /** @type {readonly (readonly [string, string, RegExp])[]} */
  const rows = [
    ['ep.evaluate("hello", [1, 2, 3])', 'ValueError', /^experiment must be 'velocity-limits' or/],
    [
      "ep.Task({}).trials({'seeds': range(1, 5, 2), 'drives': 40})",
      'ValueError',
      /^seeds must be a range of every one, but was range\(1, 5, 2\)$/,
    ],
    ['ep.evaluate("x" * (1 << 26), [1, 2, 3])', 'ValueError', /^what is given must be at most \d+ bytes/],
    ['ep.evaluate(5, [1, 2, 3])', 'ValueError', /^experiment must be an object, but was 5$/],
    [
      'ep.evaluate({"goal": ep}, [1, 2, 3])',
      'ValueError',
      /^goal must be an object, but was of type module$/,
    ],
    [
      '(lambda a: (a.append(a), ep.evaluate({"goal": a}, [1, 2, 3])))([])',
      'ValueError',
      /nested less deeply$/,
    ],
    ['ep.simulate({}, [1, 2, 3], 1)', 'ValueError', /^start must be a whole number from 0 to 0, but was 1$/],
    ['ep.simulate({}, [1, 2, 3], "0")', 'ValueError', /^start must be a number, but was '0'$/],
    ['ep.simulate({}, [[1, 2, 3]] * 2)', 'ValueError', /^gains must be three numbers/],
    [
      'ep.evaluate({"horizon": 1e5, "sampleTime": 1}, [[1, 2, 3]] * 5000)',
      'ValueError',
      /at most 4000 with 1 start and/,
    ],
    ...['robustness', 'landscape'].map(
      (name) =>
        /** @type {const} */ ([
          `ep.Task({}).${name}({'gains': None})`,
          'ValueError',
          /^gains must be three numbers .* or rows of three, but was of type NoneType$/,
        ]),
    ),
    ['ep.EpLocomotion(gains=[[1, 2, 3]])', 'ValueError', /^gains must be .*, but was rows of three$/],
    [
      'ep.EpLocomotion(gains=[1, 2, object()])',
      'ValueError',
      /^kθ must be a finite number, but was 'object'$/,
    ],
    ['ep.Evolution({}).step(0)', 'ValueError', /^generations must be a whole number from 1, but was 0$/],
    ['ep.Evolution({}).step(1.5)', 'ValueError', /^generations must be a whole number from 1, but was 1\.5$/],
    ['ep.Evolution({}).step(True)', 'ValueError', /^generations must be .*, but was True$/],
    [
      'ep.starts_on_circle({})',
      'ValueError',
      /^circle\.x must be a number from -1000 to 1000 m, but was missing$/,
    ],
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
