// Thousands of starts, which the page hands to the core in one list, or as the one from which a robot drives.
import assert from 'node:assert/strict';
import { createEngine, Evolution, experiment, Simulation, simulateAll, stability } from '../harness/core.js';
import { test } from '../harness/once.js';

/** @param {number} count */
const startsOf = (count) =>
  Array.from({ length: count }, (_, i) => ({ x: (i % 9) + 0.1, y: -i / 7, theta: i / count }));

/** @type {import('../../../www/core/engine.js').Triple} */
const gains = [3, 0.5, 4];

test('of many starts comes what the core makes of them one by one', () => {
  const engine = createEngine();
  for (const count of [1, 99, 100, 300]) {
    const from = experiment({ starts: startsOf(count), evolution: { population: 4 } });
    assert.deepEqual(engine.experiment(from), from);
    const { starts } = from;
    assert.deepEqual(engine.changed('acceleration-limits', { starts }).starts, starts);
    const begun = engine.begin(from);
    const alone = new Evolution(from);
    assert.deepEqual(begun, { statistics: alone.statistics(), population: alone.population() });
    engine.step();
    alone.step();
    assert.equal(engine.hash(), alone.hash());
    assert.deepEqual(engine.drive(from, [gains, gains]), simulateAll(from, [...gains, ...gains]));
    assert.deepEqual(engine.stability(from, gains), stability(from, gains));
    assert.deepEqual(engine.samples(from, gains).at(0), new Simulation(from, gains).step());
  }
});

test('a start that is none is refused by its name, or completed, among many as alone', () => {
  const engine = createEngine();
  const told = (/** @type {() => unknown} */ act) => {
    try {
      return act();
    } catch (error) {
      return String(error);
    }
  };
  for (const start of [
    { x: 1e9, y: 0, theta: 0 },
    { x: 0, y: Number.NaN, theta: 0 },
    { x: 0, y: 0, theta: '0' },
    { x: 0, y: 0, theta: 0, z: 0 },
    { x: 0, y: 0 },
    [0, 0, 0],
    null,
    7,
  ]) {
    const starts = /** @type {any} */ (startsOf(300).with(120, /** @type {any} */ (start)));
    const [engines, cores] = [engine, { experiment }].map((one) => told(() => one.experiment({ starts })));
    assert.deepEqual(engines, cores);
    if (typeof cores === 'string') assert.match(cores, /starts\[120\]/);
  }
  for (const from of /** @type {any[]} */ ([null, undefined, 7, 'none', []]))
    assert.deepEqual(
      told(() => engine.experiment(from)),
      told(() => experiment(from)),
    );
  for (const starts of [startsOf(10_001), [], {}, 'none', new Float64Array(301)])
    assert.equal(
      told(() => engine.experiment({ starts: /** @type {any} */ (starts) })),
      told(() => experiment({ starts: /** @type {any} */ (starts) })),
    );
});
