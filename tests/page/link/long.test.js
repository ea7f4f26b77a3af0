// Links of thousands of starts, and links that are none.
import assert from 'node:assert/strict';
import { openLink as openOfPackage } from '../../../src/link.js';
import { links } from '../../../www/lesson/links.js';
import { createEngine } from '../harness/core.js';
import { test } from '../harness/once.js';

const engine = createEngine();

test('a run with thousands of starts opens whole', () => {
  const link = `lab&v=1&start=${Array(5000).fill('0.5,0.25,90deg').join(';')}&seed=3`;
  for (const { experiment, problems } of [
    openOfPackage(link),
    { ...links.openLink(link, engine).opened, problems: links.openLink(link, engine).problems },
  ])
    assert.deepEqual([experiment.starts.length, experiment.evolution.seed, problems], [5000, 3, []]);
});

test('of what is too long no value is cut through', () => {
  for (const rest of ['x'.repeat(300_000), `generation=${'1'.repeat(300_000)}`, 'x=&'.repeat(6000)]) {
    const link = `lab&v=1&seed=3&${rest}`;
    const { opened, problems } = links.openLink(link, engine);
    assert.match(problems[0], /longer than 200\u202f000 characters, or has more than 5\u202f000 keys/);
    assert.deepEqual([opened.experiment.evolution.seed, opened.generation], [3, 0]);
    const run = openOfPackage(link);
    assert.match(run.problems.join(), /longer than/);
    assert.deepEqual([run.experiment.evolution.seed, run.generation], [3, 0]);
  }
});
