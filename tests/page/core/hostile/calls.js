// Every function of the core, and what no caller means well with.
import assert from 'node:assert/strict';
/** @typedef {Omit<typeof import('../../../../pkg/ep_locomotion.js'), 'default' | '__wbg_init'>} Core */

/** @typedef {(...given: any[]) => unknown} Call */

/** Every function of a core, each with arguments that it takes. @param {Core} core @returns {readonly (readonly [string, Call, readonly unknown[]])[]} */
export function callsOf(core) {
  const { Evolution, Simulation } = core;
  const evolution = new Evolution({});
  evolution.step();
  return [
    ['experiment', core.experiment, [core.experiment('acceleration-limits')]],
    ['simulate', core.simulate, [{ horizon: 0.1 }, [3, 0.1, 5], 0]],
    ['simulateAll', core.simulateAll, [{ horizon: 0.1 }, [3, 0.1, 5, 1, 1, 1], 0]],
    ['evaluate', core.evaluate, [{ horizon: 0.1 }, Float64Array.of(3, 0.1, 5)]],
    ['fares', core.fares, [{ starts: [{}, { x: 1 }] }, [3, 0.1, 5]]],
    ['stability', core.stability, [{ horizon: 0.1 }, [3, 0.1, 5], 0]],
    ['errorParts', core.errorParts, [{ horizon: 0.1 }, [3, 0.1, 5]]],
    ['remainingErrors', core.remainingErrors, [{ horizon: 0.1 }, [3, 0.1, 5], 0.05]],
    [
      'landscape',
      core.landscape,
      [
        { horizon: 0.1 },
        {
          x: { gain: 'kx', from: 1, to: 9, count: 3, log: true },
          y: { gain: 'ky', from: 0, to: 1, count: 2 },
          gains: [1, 2, 3],
          rows: [0, 2],
        },
      ],
    ],
    [
      'robustness',
      core.robustness,
      [
        { horizon: 0.1 },
        {
          gains: [3, 2, 5],
          x: { from: 0, to: 1, count: 2 },
          y: { from: 0, to: 1, count: 1 },
          headings: 3,
          part: [0, 6],
        },
      ],
    ],
    [
      'seedRuns',
      core.seedRuns,
      [
        { horizon: 0.1, evolution: { population: 2 } },
        { seeds: [1, 3], generations: 1 },
      ],
    ],
    ['startsOnCircle', core.startsOnCircle, [{ x: 0, y: 0, radius: 1, count: 3, seed: 1 }]],
    [
      'startsOnGrid',
      core.startsOnGrid,
      [{ x: { from: 0, to: 1, count: 2 }, y: { from: 0, to: 1, count: 1 }, headings: 3, part: [0, 6] }],
    ],
    ['lawTerms', core.lawTerms, [{}, [3, 0.1, 5], { x: 1, y: -1, theta: 0.5 }]],
    ['winsBout', core.winsBout, [1, 2]],
    ['Simulation', (...given) => new Simulation(given[0], given[1], given[2]).step(), [{}, [3, 0.1, 5], 0]],
    ['Evolution', (given) => new Evolution(given).hash(), [{ horizon: 0.1, evolution: { population: 3 } }]],
    ['statistics', (given) => evolution.statistics(given), [1]],
    ['record', (given) => evolution.record(given), [1]],
    ['population', (given) => evolution.population(given), [1]],
  ];
}

class Trap extends Error {}
export const spring = () => {
  throw new Trap('sprung');
};
/** Every way to look at an object throws, or every one but the first. */
export const traps = Object.fromEntries(
  ['get', 'has', 'ownKeys', 'getOwnPropertyDescriptor', 'getPrototypeOf'].map((name) => [name, spring]),
);
export const revoked = Proxy.revocable({}, {});
revoked.revoke();
const detached = new Float64Array(3);
structuredClone(detached.buffer, { transfer: [detached.buffer] });

/** What no caller means well with. @type {readonly (() => unknown)[]} */
export const hostile = [
  ...[undefined, null, true, '', '1', 'kx', Symbol('s'), 1n, 2n ** 64n, Number.NaN].map(
    (value) => () => value,
  ),
  ...[Infinity, -Infinity, -0, 5e-324, 1e308, -1e308, 0.5, 2 ** 32, -1].map((value) => () => value),
  ...[
    () => 0,
    class {},
    new Date(Number.NaN),
    new Map(),
    Promise.resolve(),
    /x/,
    new Number(1),
    new String('kx'),
  ].map((value) => () => value),
  ...[
    [],
    {},
    [[]],
    Object.assign([], { 1: 1, 3: 2 }),
    new Array(2 ** 32 - 1),
    Object.create(null),
    Object.create({ law: 'none' }),
  ].map((value) => () => value),
  ...[detached, new Float64Array(4e6), new BigInt64Array(3), new DataView(new ArrayBuffer(24))].map(
    (value) => () => value,
  ),
  ...[new Float64Array(new SharedArrayBuffer(24)), Object.create(Float64Array.prototype)].map(
    (value) => () => value,
  ),
  () => revoked.proxy,
  () => new Proxy({}, traps),
  () => new Proxy([1, 2, 3], traps),
  () =>
    new Proxy([1, 2, 3], { get: (target, key) => (key === 'length' ? 2 ** 40 : Reflect.get(target, key)) }),
  () => new Proxy({ x: 1, y: 1, law: 'kanayama' }, { getOwnPropertyDescriptor: spring }),
  () => new Proxy([1, 2, 3], { get: (target, key) => (key === '1' ? spring() : Reflect.get(target, key)) }),
  () => Object.defineProperty(new Float64Array(3), 'length', { value: 1e9 }),
  () => Object.defineProperty(new Float32Array(3), 'length', { value: '3' }),
  () => Object.defineProperty({}, 'x', { get: spring, enumerable: true }),
  () => Object.defineProperty([1], 0, { get: spring }),
  () => ({ toString: spring, valueOf: spring, toJSON: spring, [Symbol.toPrimitive]: spring }),
  () => Object.assign([1, 2, 3], { [Symbol.iterator]: spring, constructor: spring }),
  () => JSON.parse('{"__proto__": {"x": 1}, "constructor": {"prototype": {"x": 1}}}'),
  () => ({ ['x'.repeat(1e5)]: 1 }),
  () => {
    /** @type {any} */
    const itself = {};
    return Object.assign(itself, { goal: itself, starts: [itself], x: itself });
  },
];

/** Where a value can stand within another: every path of its objects and arrays, and the whole. @param {unknown} value @returns {string[][]} */
export const pathsOf = (value) =>
  value !== null && typeof value === 'object'
    ? [[], ...Object.entries(value).flatMap(([key, inner]) => pathsOf(inner).map((path) => [key, ...path]))]
    : [[]];

/** Every place within what these calls are given. @param {ReturnType<typeof callsOf>} calls */
export const placesIn = (calls) =>
  calls.flatMap(([, call, given]) =>
    pathsOf(given)
      .filter(({ length }) => length > 0)
      .map((path) => /** @type {const} */ ({ call, given, path })),
  );

/** A copy with something else at this path. @param {any} value @param {readonly string[]} path @param {unknown} other @returns {any} */
export function withOther(value, [key, ...rest], other) {
  if (key === undefined) return other;
  const copy = ArrayBuffer.isView(value) ? [.../** @type {any} */ (value)] : structuredClone(value);
  copy[key] = withOther(value[key], rest, other);
  return copy;
}

/** What the core says to good arguments, to the bit. */
export const answersTo = (/** @type {ReturnType<typeof callsOf>} */ calls) =>
  JSON.stringify(calls.map(([, call, given]) => call(...given)));

/** Calls with these arguments: there is an answer, or an Error that says what is wrong. @param {Call} call @param {readonly unknown[]} given @returns {string | null} */
export function refusal(call, given) {
  try {
    call(...given);
    return null;
  } catch (error) {
    assert.ok(error instanceof Error, String(error));
    assert.ok(!(error instanceof WebAssembly.RuntimeError), error.message);
    assert.doesNotMatch(error.message, /internal error|unreachable|recursive use/);
    assert.ok(error.message.length < 1000, error.message.slice(0, 1000));
    // Of freed objects the glue tells; of arguments the core does, also where an argument itself throws.
    assert.equal(error.constructor, Error, String(error));
    assert.match(error.message, / must be .*, but was /s);
    return error.message;
  }
}
