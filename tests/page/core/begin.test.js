// The core that is made ready in two ways at once.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { evolve, experiment, glue, wasm } from '../harness/core.js';
import { test } from '../harness/once.js';

test('made ready at once while init is on its way, the core is one, and what it has made lives on', async () => {
  /** @type {typeof import('../../../pkg/ep_locomotion.js')} */
  const core = await import(`${glue}?twice`);
  const module = await readFile(wasm);
  const begun = core.default({ module });
  const { memory } = core.initSync({ module });
  const usual = experiment('velocity-limits');
  const evolution = new core.Evolution(usual);
  evolution.step();
  assert.equal((await begun).memory, memory);
  evolution.step();
  assert.equal(evolution.hash(), evolve(usual, 2).hash);
  assert.equal((await core.default()).memory, memory);
});
