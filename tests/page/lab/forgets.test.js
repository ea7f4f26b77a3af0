// A search that forgets its best robot drives with the best of its generation, and it is that one's J which is shown.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { Evolution, experiment, shown } from '../harness/core.js';

const starts = [
  { x: 0, y: 0, theta: 0 },
  { x: 1, y: 0, theta: Math.PI / 2 },
];
const usual = experiment('velocity-limits');

pageTest('the J beside the robot is that of the robot which drives', async (page) => {
  for (const [method, forgets] of /** @type {const} */ ([
    ['random', true],
    ['ep', false],
  ])) {
    const evolution = new Evolution({ ...usual, starts, evolution: { ...usual.evolution, method } });
    for (let i = 0; i < 9; i += 1) evolution.step();
    const { cost } = evolution.population()[0];
    assert.equal(cost > evolution.statistics().best.cost, forgets);
    evolution.free();
    await page.open(`#lab&v=1&evolution.method=${method}&start=0,0,0;1,0,90deg&generation=9`);
    await page.until(
      'the generation is there',
      () => document.getElementById('generation')?.textContent === '9',
    );
    assert.equal(await page.text('#cost-note'), `mean over all 2 starts: ${shown(cost)}`);
    const title = forgets ? 'Cost of this generation’s best robot' : 'Cost of the best robot';
    assert.equal(await page.text('#cost-title'), title);
  }
});
