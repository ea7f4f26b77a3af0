// The types of the package for Python are those of the core, and its values are what they say.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { areBuilt, python } from '../../../.tasks/examples.mjs';
import { pythonTypes, target } from '../../../.tasks/python-types.mjs';
import { test } from '../harness/once.js';
import { valuesFrom } from './python.js';

const program = fileURLToPath(new URL('agree.py', import.meta.url));

test('the types for Python are written from the tables of the core', () => {
  assert.equal(readFileSync(target, 'utf8'), pythonTypes(), 'write them anew: node .tasks/python-types.mjs');
});

const skip = !areBuilt() && 'npm test builds the wheel where Python is';

test('what Python is given back has the fields that its types name, and no other', { skip }, () => {
  const task = "ep.Task({'starts': [{'x': 0, 'y': 0, 'theta': 0}, {'x': 1, 'y': 0, 'theta': 1}]})";
  const range = "{'from': -1, 'to': 1, 'count': 2}";
  const evolution = "(lambda one: (one.step(2), one)[1])(ep.Evolution('acceleration-limits'))";
  const rows = [
    ['ep.experiment()', 'Experiment'],
    ["ep.experiment({'law': 'kanayama', 'limits': {'speed': None}})", 'Experiment'],
    [`${task}.simulate([3, 1, 4])`, 'Run'],
    [`${task}.stability([3, 1, 4])`, 'Stability'],
    [`${task}.fares([3, 1, 4])`, 'Robustness'],
    [`${task}.robustness({'gains': [3, 1, 4], 'x': ${range}, 'y': ${range}, 'headings': 2})`, 'Robustness'],
    [`${task}.trials({'seeds': [1, 3], 'drives': 60})[0]`, 'Trial'],
    [`${evolution}.statistics()`, 'Statistics'],
    [`${evolution}.record()`, 'GenerationRecord'],
    [
      "ep.Evolution({'evolution': {'method': 'cma-es'}}).step() and ep.Evolution({'evolution': {'method': 'cma-es'}}).record()",
      'GenerationRecord',
    ],
    [`${evolution}.population()[0]`, 'Individual'],
    ['ep.fields()[0]', 'Field'],
    ['ep.word_fields()[0]', 'WordField'],
    ['ep.paper()[0]', 'PaperResult'],
    ["ep.starts_on_circle({'x': 0, 'y': 0, 'radius': 1, 'count': 3, 'seed': 1})[0]", 'Posture'],
  ].map(([expression, kind]) => `${JSON.stringify([expression, `types.${kind}`])}\n`);
  // A value that its type does not tell, so that the question is one.
  rows.push(`${JSON.stringify(["{'law': 'mine'}", 'types.Experiment'])}\n`);
  const output = execFileSync(python, ['-B', program], { input: rows.join(''), encoding: 'utf8' });
  const answers = output
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  assert.equal(answers.length, rows.length);
  assert.equal(answers.pop().length, 1);
  assert.deepEqual(answers.flat(), []);
});

test('what functions and methods take and give can be asked of them', { skip }, () => {
  const names = ['evaluate', 'experiment', 'fields', 'simulate', 'starts_on_grid', 'word_fields'];
  const methods = [
    'Task.evaluate',
    'Task.trials',
    'Evolution.__init__',
    'Evolution.step',
    'EpLocomotion.step',
  ];
  const asked = [...names, ...methods].map((name) => ({
    expression: `list(__import__('typing').get_type_hints(ep.${name}))[-1]`,
  }));
  assert.deepEqual(new Set(valuesFrom(asked)), new Set(['return']));
});

test('no name is listed but those of the package', { skip }, () => {
  const core = ['Evolution', 'InternalError', 'Task', 'evaluate', 'experiment', 'fields', 'paper'];
  const listed = [{ expression: "[name for name in dir(ep) if name[0] != '_']" }];
  assert.deepEqual(valuesFrom(listed), [
    [
      ...core,
      'EpLocomotion',
      'simulate',
      'starts_on_circle',
      'starts_on_grid',
      'types',
      'word_fields',
    ].sort(),
  ]);
});

test('the wheel names its authors as the citation does', { skip }, () => {
  const citation = readFileSync(new URL('../../../CITATION.cff', import.meta.url), 'utf8');
  const [, name] = /^authors:\n {2}- name: (.+)$/m.exec(citation) ?? [];
  const expression = "__import__('importlib.metadata').metadata.metadata('ep-locomotion')['Author']";
  assert.deepEqual(valuesFrom([{ expression }]), [name]);
});
