// The types that the package declares are those of what it gives: the same keys, each of a kind that its type allows.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import * as core from '../harness/core.js';

const text = await readFile(new URL('../../../pkg/ep_locomotion.d.ts', import.meta.url), 'utf8');

/** The fields of each interface, by their names: the text of their type. */
const interfaces = new Map(
  [...text.matchAll(/export interface (\w+) \{\n([\s\S]*?)\n\}/g)].map(([, name, body]) => [
    name,
    new Map([...body.matchAll(/^ +(\w+)(\??): (.*);$/gm)].map(([, key, , type]) => [key, type])),
  ]),
);
const aliases = new Map(
  [...text.matchAll(/export type (\w+) = ('.*);/g)].map(([, name, type]) => [name, type]),
);

/** What keeps a value from being of a type, if anything. @param {unknown} value @param {string} type @param {string} at @returns {string[]} */
function flaws(value, type, at) {
  const union = type.split(' | ');
  if (union.length > 1) {
    const each = union.map((one) => flaws(value, one, at));
    return each.find((one) => one.length === 0) ?? each[0];
  }
  const wrong = (/** @type {boolean} */ is) => (is ? [] : [`${at} is no ${type}`]);
  if (type === 'null') return wrong(value === null);
  if (['number', 'string', 'boolean'].includes(type)) return wrong(typeof value === type);
  if (type === 'Float64Array') return wrong(value instanceof Float64Array);
  if (type === 'Uint8Array') return wrong(value instanceof Uint8Array);
  if (type.startsWith("'")) return wrong(`'${value}'` === type);
  if (aliases.has(type)) return flaws(value, aliases.get(type) ?? '', at);
  if (type.endsWith('[]')) {
    if (!Array.isArray(value)) return wrong(false);
    return value.flatMap((one, i) => flaws(one, type.slice(0, -2), `${at}[${i}]`));
  }
  if (type.startsWith('[')) {
    const types = type.slice(1, -1).split(', ');
    if (!Array.isArray(value) || value.length !== types.length) return wrong(false);
    return types.flatMap((one, i) => flaws(value[i], one, `${at}[${i}]`));
  }
  const fields = interfaces.get(type);
  if (!fields) return [`${type} is not declared`];
  if (typeof value !== 'object' || value === null) return wrong(false);
  const found = Object.keys(value).sort().join();
  const declared = [...fields.keys()].sort().join();
  if (found !== declared) return [`${at} has ${found}, ${type} has ${declared}`];
  return [...fields].flatMap(([key, one]) => flaws(Reflect.get(value, key), one, `${at}.${key}`));
}

const gains = Float64Array.of(3.23673, 0.09678, 5.17891);
const e = core.experiment('velocity-limits');
const range = { from: 0, to: 1, count: 2 };
const task = new core.Task(e);
const robot = new core.Simulation(e, gains, 0);
const evolution = new core.Evolution(e);

/** Generation 1 of a rival. @param {import('../../../pkg/ep_locomotion.js').Method} method */
function record(method) {
  const rival = new core.Evolution({ evolution: { method, crossover: 0.5 } });
  rival.step();
  return rival.record(1);
}

test('every object has the keys and kinds of its type', () => {
  const driving = robot.step();
  for (let i = 0; i < 300; i++) robot.step();
  /** @type {[string, unknown][]} */
  const given = [
    ['Experiment', e],
    ['Experiment', core.experiment('acceleration-limits')],
    ['Experiment', task.experiment],
    ['Run', core.simulate(e, gains)],
    ['Run[]', core.simulateAll(e, [...gains, ...gains])],
    ['Run', task.simulate(gains)],
    ['Sample', driving],
    ['Sample', robot.step()],
    ['Statistics', evolution.statistics()],
    ['Statistics', evolution.step()],
    ['GenerationRecord', evolution.record(0)],
    ['GenerationRecord', evolution.record(1)],
    ['Individual[]', evolution.population()],
    ['Float64Array', core.evaluate(e, gains)],
    ['Robustness', core.fares(e, gains)],
    ['Robustness', core.robustness(e, { gains, x: range, y: range, headings: 2 })],
    ['SeedRun[]', core.seedRuns(e, { seeds: [1, 3], generations: 1 })],
    ['Trial[]', core.trials(e, { seeds: [1, 3], drives: 30 })],
    ['GenerationRecord', record('cma-es')],
    ['GenerationRecord', record('de')],
    ['Stability', core.stability(e, gains)],
    ['Stability', core.stability({ law: 'kanayama' }, [1, 0, 1])],
    ['ErrorParts[]', core.errorParts(e, gains)],
    ['RemainingErrors', core.remainingErrors(e, gains, 1)],
    ['LawTerms', core.lawTerms(e, gains, { x: 1, y: 1, theta: 1 })],
    ['LawTerms', core.lawTerms({ law: 'kanayama' }, [1, 0, 1], { x: 1, y: 1, theta: 1 })],
    ['Posture[]', core.startsOnCircle({ x: 0, y: 0, radius: 1, count: 3, seed: 1 })],
    ['Posture[]', core.startsOnGrid({ x: range, y: range, headings: 2 })],
    ['Field[]', core.fields()],
    ['WordField[]', core.wordFields()],
    ['PaperResult[]', core.paper()],
    ['LearningRates', core.learningRates()],
  ];
  for (const [type, value] of given) assert.deepEqual(flaws(value, type, type), []);
  // A type of which nothing is given here must be one of those that only go in.
  const names = new Set(given.map(([type]) => type.replace('[]', '')));
  const inner = [...interfaces].flatMap(([name, fields]) => (names.has(name) ? [...fields.values()] : []));
  for (const type of inner) names.add(type.replace(/\[\]|( \| null)/g, ''));
  const others = [...interfaces.keys()].filter((name) => !names.has(name));
  assert.deepEqual(
    others.filter(
      (name) =>
        text.includes(`${name} {`) &&
        !/^(Init|Landscape|Axis|Grid|StartGrid|Range|SeedRuns|Trials|Circle)/.test(name),
    ),
    [],
  );
});

test('starts may be their numbers side by side', () => {
  const starts = core.startsOnCircle({ x: 2, y: 2, radius: 2, count: 5, seed: 3 });
  const flat = Float64Array.from(starts.flatMap(({ x, y, theta }) => [x, y, theta]));
  assert.deepEqual(core.experiment({ starts: flat }), core.experiment({ starts }));
  assert.throws(() => core.experiment({ starts: Float64Array.of(1, 2, 3, 4) }), {
    message: 'starts must be three numbers (x, y, θ) for each posture, but was 4 numbers',
  });
  assert.throws(() => core.experiment({ starts: Float64Array.of(1, 2, Number.NaN) }), {
    message: 'starts[0].theta must be a number from -100 to 100 rad, but was NaN',
  });
  assert.throws(() => core.experiment({ starts: new Float64Array(0) }), {
    message: 'starts must be a list of 1 to 10000 postures, but was a list of 0',
  });
  assert.throws(() => core.experiment({ starts: new Float64Array(30_003) }), {
    message: 'starts must be at most 30000 numbers, but was 30003 numbers',
  });
});

test('a task does what the functions of an experiment do', () => {
  assert.deepEqual(task.evaluate(gains), core.evaluate(e, gains));
  assert.deepEqual(task.simulate(gains, 0), core.simulate(e, gains, 0));
  assert.deepEqual(task.stability(gains), core.stability(e, gains));
  assert.throws(() => new core.Task({ horizon: -1 }), /^Error: horizon must be a number from/);
});
