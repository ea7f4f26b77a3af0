// An exercise in a frame: what its host hears is what *Check hand-ins* says, and no message of the host takes drives back.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { experiment, simulate } from '../harness/core.js';
import { ask, frameOf, heardFrom, inHost, within } from '../harness/host.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const gains = /** @type {const} */ ([3.2, 0, 4.5]);

/** @param {Page} page */
const tryGains = (page) =>
  within(page, 0, async () => {
    for (const [i, id] of /** @type {const} */ (['kx', 'ky', 'ktheta']).entries()) {
      await page.focus(`#gain-${id}`);
      await page.press(...String(gains[i]), Key.ENTER);
    }
  });

pageTest('what was driven counts on when the host sets an experiment, even the same', async (page) => {
  const link = 'lab&v=1&drives=hand&gains=3,1,1&task=x&aim=J%3C8.1%3Bdrives%3C%3D9';
  await inHost(page, frameOf(page, link, 800, 600), async () => {
    await tryGains(page);
    const { experiment: own, link: before } = await ask(page, 0, { type: 'read' });
    assert.match(before, /&spent=[23]/);
    const set = await ask(page, 0, { type: 'set', experiment: own, gains: [...gains] });
    assert.equal(/&spent=(\d)/.exec(set.link)?.[1], /&spent=(\d)/.exec(before)?.[1]);
  });
});

pageTest('a hand-in tells its host J as it is judged', async (page) => {
  const link = `lab&v=1&goal.x=1&given=velocity-limits&drives=hand&gains=${gains}&task=x&aim=J%3C8.1&who=s1`;
  await inHost(page, frameOf(page, link, 800, 600), async () => {
    await within(page, 0, async () => {
      await page.until('it can be handed in', () => document.getElementById('hand-in'));
      await page.click('#hand-in');
      await page.until('the receipt is there', () => document.getElementById('handin-text'));
    });
    const [handed] = (await heardFrom(page, 0)).filter(({ type }) => type === 'handin');
    const { cost } = simulate(experiment('velocity-limits'), [...gains]);
    assert.deepEqual([handed.cost, handed.met, handed.parked], [cost.total, cost.total < 8.1, 1]);
  });
});
