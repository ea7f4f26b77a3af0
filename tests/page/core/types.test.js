// The types that the package declares are those of what it gives: the same keys, each of a kind that its type allows.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';

const text = await readFile(new URL('../../../pkg/ep_locomotion.d.ts', import.meta.url), 'utf8');

/** The fields of each interface, by their names: the text of their type. */
const interfaces = new Map(
  [...text.matchAll(/export interface (\w+) \{\n([\s\S]*?)\n\}/g)].map(([, name, body]) => [
    name,
    new Map([...body.matchAll(/^ +(\w+\??): (.*);$/gm)].map(([, key, type]) => [key, type])),
  ]),
);
/** What each function and each method is said to give back. */
const returned = new Map([
  ...[...text.matchAll(/^export function (\w+)\(.*\): (.*);$/gm)].map(
    ([, name, type]) => /** @type {const} */ ([name, type]),
  ),
  ...[...text.matchAll(/^export class (\w+) \{\n([\s\S]*?)\n\}/gm)].flatMap(([, of, body]) =>
    [...body.matchAll(/^ +(?:readonly )?(\w+)(?:\(.*\))?: (.*);$/gm)].map(
      ([, name, type]) => /** @type {const} */ ([`${of}.${name}`, type]),
    ),
  ),
]);
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
const [range, axis] = [
  { from: 0, to: 1, count: 2 },
  { gain: /** @type {const} */ ('kx'), from: 1, to: 2, count: 2, log: false },
];
const task = new core.Task(e);
const evolution = new core.Evolution(e);

/** Generation 1 of a rival. @param {import('../../../pkg/ep_locomotion.js').Method} method */
function rival(method) {
  const rival = new core.Evolution({ evolution: { method, crossover: 0.5 } });
  rival.step();
  return rival.record(1);
}

/** A robot at its first sample, and where it has arrived. @param {number} steps */
function robot(steps) {
  const robot = new core.Simulation(e, gains, 0);
  for (let i = 1; i < steps; i++) robot.step();
  return robot.step();
}

/** What may be given for each of these, whole. */
const inputs = {
  Landscape: { x: axis, y: { ...axis, gain: /** @type {const} */ ('ky') }, gains, rows: [0, 2] },
  StartGrid: { x: range, y: range, headings: 2, part: [0, 8], gains },
  Grid: { x: range, y: range, headings: 2, part: [0, 8] },
  SeedRuns: { seeds: [1, 3], generations: 1 },
  Trials: { seeds: [1, 3], drives: 30 },
  Circle: { x: 0, y: 0, radius: 1, count: 3, seed: 1 },
  Axis: axis,
  Range: range,
};
/** @typedef {any} Given Also what its type forbids. */
/** Who reads it. @type {Record<string, (given: Given) => unknown>} */
const readers = {
  Landscape: (given) => core.landscape(e, given),
  StartGrid: (given) => core.robustness(e, given),
  Grid: (given) => core.startsOnGrid(given),
  SeedRuns: (given) => core.seedRuns(e, given),
  Trials: (given) => core.trials(e, given),
  Circle: (given) => core.startsOnCircle(given),
  Axis: (given) => core.landscape(e, /** @type {Given} */ ({ ...inputs.Landscape, x: given })),
  Range: (given) => core.startsOnGrid(/** @type {Given} */ ({ ...inputs.Grid, y: given })),
};

/** Everything that can be called, some of it twice: what comes is not always of one kind. @type {Record<string, readonly (() => unknown)[]>} */
const calls = {
  experiment: [() => e, () => core.experiment('acceleration-limits')],
  evaluate: [() => core.evaluate(e, gains)],
  simulate: [() => core.simulate(e, gains)],
  simulateAll: [() => core.simulateAll(e, [...gains, ...gains])],
  landscape: [() => readers.Landscape(inputs.Landscape)],
  robustness: [() => readers.StartGrid(inputs.StartGrid)],
  lawTerms: [
    () => core.lawTerms(e, gains, { x: 1, y: 1, theta: 1 }),
    () => core.lawTerms({ law: 'kanayama' }, [1, 0, 1], { x: 1, y: 1, theta: 1 }),
  ],
  fares: [() => core.fares(e, gains)],
  stability: [() => core.stability(e, gains), () => core.stability({ law: 'kanayama' }, [1, 0, 1])],
  errorParts: [() => core.errorParts(e, gains)],
  remainingErrors: [() => core.remainingErrors(e, gains, 1)],
  seedRuns: [() => readers.SeedRuns(inputs.SeedRuns)],
  trials: [() => readers.Trials(inputs.Trials)],
  startsOnCircle: [() => readers.Circle(inputs.Circle)],
  startsOnGrid: [() => readers.Grid(inputs.Grid)],
  winsBout: [() => core.winsBout(1, 2)],
  fields: [core.fields],
  wordFields: [core.wordFields],
  paper: [core.paper],
  learningRates: [core.learningRates],
  version: [core.version],
  randomSeed: [core.randomSeed],
  'Task.experiment': [() => task.experiment],
  'Evolution.experiment': [() => new core.Evolution(e).experiment],
  'Simulation.step': [() => robot(1), () => robot(300)],
  'Evolution.generation': [() => evolution.generation],
  'Evolution.mostDrivenAgain': [() => evolution.mostDrivenAgain],
  'Evolution.step': [() => evolution.step()],
  'Evolution.statistics': [() => evolution.statistics(), () => evolution.statistics(0)],
  'Evolution.record': [() => evolution.record(0), () => rival('cma-es'), () => rival('de')],
  'Evolution.population': [() => evolution.population()],
  'Evolution.hash': [() => evolution.hash()],
};

test('whatever a function or a method gives has the keys and kinds of its type', () => {
  for (const [name, type] of returned) {
    if (type === 'void' || name === 'initSync') continue;
    // A method of a task is the function of its name, as another test holds.
    const of = calls[name] ?? calls[name.replace('Task.', '')];
    assert.ok(of, `${name} is not called here`);
    for (const call of of) assert.deepEqual(flaws(call(), type, name), []);
  }
});

test('whatever is read has the fields of its type, and only those may be left out that the type says', () => {
  for (const [name, whole] of Object.entries(inputs)) {
    const [read, fields] = [readers[name], [...(interfaces.get(name)?.keys() ?? [])]];
    const sorted = (/** @type {string[]} */ keys) => keys.sort().join();
    assert.equal(sorted(Object.keys(whole)), sorted(fields.map((key) => key.replace('?', ''))), name);
    assert.throws(
      () => read({ ...whole, stranger: 1 }),
      ({ message }) => {
        const known = /no fields but (.*), but was one with 'stranger'$/.exec(message)?.[1] ?? message;
        return sorted(known.split(', ')) === sorted(Object.keys(whole));
      },
      name,
    );
    read(whole);
    for (const key of fields) {
      const rest = { ...whole, [key.replace('?', '')]: undefined };
      if (key.endsWith('?')) read(rest);
      else assert.throws(() => read(rest), /^Error: .* must be /, `${name}.${key}`);
    }
  }
});

test('every type is of something that is given or read', () => {
  const names = [...returned.values(), ...Object.keys(inputs)].map((type) => type.replace('[]', ''));
  /** @type {Set<string>} */
  const known = new Set(['InitOutput']);
  const add = (/** @type {string} */ name) => {
    if (known.has(name)) return;
    known.add(name);
    for (const type of interfaces.get(name)?.values() ?? [])
      for (const one of type.split(' | ')) add(one.replaceAll('[]', ''));
  };
  names.forEach(add);
  assert.deepEqual(
    [...interfaces.keys(), ...aliases.keys()].filter((name) => !known.has(name)),
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
