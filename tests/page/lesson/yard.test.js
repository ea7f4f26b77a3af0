// The task of the duel: what a hand can do there, and what only evolution does.
import assert from 'node:assert/strict';
import { evaluate, fares, seedRuns } from '../harness/core.js';
import { contest, evolvedBest, yard } from './duel-task.js';
import { test } from '../harness/once.js';

test('the yard is the mean over its starts, as the core has it', () => {
  for (const gains of /** @type {const} */ ([
    [5, 5, 5],
    [1, 1, 1],
    [7, 180, 7],
  ])) {
    const seen = yard.drive(contest, gains);
    assert.ok(seen);
    assert.ok(Math.abs(seen.cost / evaluate(contest, [...gains])[0] - 1) < 1e-12);
    const { arrived } = fares({ ...contest, evolution: { ...contest.evolution, population: 1 } }, [...gains]);
    assert.equal(
      seen.parked,
      [...arrived].reduce((a, b) => a + b, 0),
    );
  }
});

test('the task of the duel is made once, also while another is on the stage', () => {
  const [one, other] = [{ ...contest }, { ...contest }];
  const first = yard.experimentOf(one);
  yard.experimentOf(other);
  assert.equal(yard.experimentOf(one), first);
});

test('no hand within the sliders does what evolution does in 20 to 60 generations, at a ky beyond them', () => {
  const steps = [0.01, 1.5, 3, 4.5, 6, 7.5, 9, 10.5, 12];
  const grid = steps.flatMap((kx) => steps.flatMap((ky) => steps.map((kt) => [kx, ky, kt])));
  const costs = [...evaluate(contest, grid.flat())];
  const best = Math.min(...costs);
  assert.ok(best > 13 && best < 13.1, `${best}`);
  const hand = yard.drive(contest, /** @type {any} */ (grid[costs.indexOf(best)]));
  assert.equal(hand?.parked, 26);
  for (const seed of [1, 2, 3, 4]) {
    assert.ok(evolvedBest(seed, 20).cost < best, `seed ${seed} after 20`);
    const { cost, gains } = evolvedBest(seed, 60);
    assert.ok(cost < 11.8 && gains[1] > 12 * 10, `seed ${seed}: ${cost}, ${gains}`);
    assert.equal(yard.drive(contest, gains)?.parked, 32);
  }
});

test('random search cannot go there: evolution is ahead of it with every seed', () => {
  for (const seed of [1, 2, 3, 4, 5]) {
    const [{ best, random }] = seedRuns(contest, { seeds: [seed, seed + 1], generations: 60 });
    assert.ok(best[60] < random[60] - 1);
    assert.equal(best[0], random[0]);
  }
});
