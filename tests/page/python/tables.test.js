// Tables whose columns have names, and rows that have none.
import assert from 'node:assert/strict';
import { areBuilt } from '../../../.tasks/examples.mjs';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';
import { askPython, valuesFrom } from './python.js';

const options = { skip: !areBuilt() && 'npm test builds the wheel where Python is' };

test(
  'columns that are named as the gains are, or the parts of a posture, may stand in any order',
  options,
  () => {
    const [cost] = core.evaluate({}, [3, 0.1, 5]);
    const absent = 'no numpy';
    const ofNumpy = (/** @type {string} */ expression) => `'${absent}' if numpy is None else ${expression}`;
    const records = "numpy.array([(5, 3, 0.1)] * 4, dtype=[('ktheta', float), ('kx', float), ('ky', float)])";
    const axes =
      "'x': {'gain': 'kx', 'from': 3, 'to': 3, 'count': 1}, 'y': {'gain': 'ky', 'from': 0.1, 'to': 0.1, 'count': 1}";
    const costs = [
      'ep.evaluate({}, Frame(ktheta=[5], kx=[3], ky=[0.1]))[0]',
      'ep.evaluate({}, Frame(kx=[3], ky=[0.1], ktheta=[5]))[0]',
      'ep.evaluate({}, Frame(first=[3], second=[0.1], third=[5]))[0]',
      'ep.evaluate({}, Series(ktheta=5, kx=3, ky=0.1))',
      'ep.evaluate({}, [Series(ktheta=5, kx=3, ky=0.1)])[0]',
      "ep.simulate({}, Series(ktheta=5, kx=3, ky=0.1))['cost']['total']",
      "ep.evaluate({}, [namedtuple('Row', 'ktheta kx ky')(5, 3, 0.1)])[0]",
      "ep.evaluate({}, namedtuple('Row', 'ktheta kx ky')(5, 3, 0.1))",
      ofNumpy(`ep.evaluate({}, ${records})[3]`),
      ofNumpy(`ep.evaluate({}, ${records}[0])`),
      ofNumpy(`ep.evaluate({}, [${records}[0]])[0]`),
      ...['Series(ktheta=5, kx=3, ky=0.1)', '[[3, 0.1, 5]]', 'map(float, (3, 0.1, 5))'].map(
        (gains) => `ep.Task({}).landscape({${axes}, 'gains': ${gains}})[0]`,
      ),
    ];
    const starts = [
      'Frame(theta=[3], x=[1], y=[2])',
      'Frame(a=[1], b=[2], c=[3])',
      '[Series(theta=3, x=1, y=2)]',
      "[namedtuple('Row', 'theta x y')(3, 1, 2)]",
      "numpy.array([(3, 1, 2)], dtype=[('theta', float), ('x', float), ('y', float)])",
    ].map((given) => `ep.Task({'starts': ${given}}).experiment['starts']`);
    starts.push(ofNumpy(String(starts.pop())));
    const values = valuesFrom([...costs, ...starts].map((expression) => ({ expression })));
    const told = (/** @type {unknown[]} */ some) => some.filter((value) => value !== absent);
    for (const value of told(values.slice(0, costs.length))) assert.equal(value, cost);
    for (const value of told(values.slice(costs.length))) assert.deepEqual(value, [{ x: 1, y: 2, theta: 3 }]);
  },
);

test('names of which one is known, but stands elsewhere, are refused', options, () => {
  const answers = askPython([
    { expression: 'ep.evaluate({}, Series(ktheta=5, kx=3, k=0.1))' },
    { expression: "ep.Task({'starts': Frame(heading=[3], x=[1], y=[2])})" },
  ]);
  assert.deepEqual(
    answers.map(({ message }) => message),
    [
      'names must be kx, ky, ktheta, in any order, or all be others, but were ktheta, kx, k',
      'names must be x, y, theta, in any order, or all be others, but were heading, x, y',
    ],
  );
});

test('start postures may be rows of three numbers', options, () => {
  const answers = askPython(
    [
      '[[0, 1, 2], [3, 4, 5.0]]',
      '((0, 1, 2), [3, 4, 5])',
      "[[0, 1, 2], {'x': 3, 'y': 4, 'theta': 5}]",
      '[[0, 0, 0], [0, 0, None]]',
      "[[0, 0, 0], ['1', 0, 0]]",
      '[[0, 0, 0], [0, 0]]',
    ].map((starts) => ({ expression: `ep.Task({'starts': ${starts}}).experiment['starts']` })),
  );
  const postures = [
    { x: 0, y: 1, theta: 2 },
    { x: 3, y: 4, theta: 5 },
  ];
  assert.deepEqual(
    answers.slice(0, 3).map(({ value }) => value),
    Array(3).fill(postures),
  );
  const wrong = [/^starts\[1\]\.theta /, /^starts\[1\]\.x /, /^starts\[1\] .*array of 2$/];
  for (const [i, said] of wrong.entries()) assert.match(String(answers[3 + i].message), said);
});

test('a figure is given the plain values of an experiment', options, () => {
  const [value] = valuesFrom([
    {
      expression:
        "ep.EpLocomotion(experiment={'starts': Frame(theta=[3], x=[1], y=[2]), 'goal': {'x': 3}, 'limits': {'speed': None}}).experiment",
    },
  ]);
  assert.deepEqual(value, {
    starts: [{ x: 1, y: 2, theta: 3 }],
    goal: { x: 3 },
    limits: { speed: null },
  });
});
