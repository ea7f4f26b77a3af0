import assert from 'node:assert/strict';
import { pageTest } from './browsers.js';

pageTest('the page opens without errors and asks no other host', async (page) => {
  assert.deepEqual(await page.problems(), []);
});
