// No error is silent: what nobody has caught fails every test of the page, also when its page is left or loaded again.
import assert from 'node:assert/strict';
import { engineTest } from '../harness/browsers.js';

engineTest('an error that nobody catches is told after its page is left', async (page) => {
  await page.open('#lab');
  assert.equal(page.uncaught, '');
  await page.evaluate(() => {
    dispatchEvent(new ErrorEvent('error', { message: 'nobody catches it' }));
  });
  assert.match((await page.problems()).join(), /uncaught: nobody catches it/);
  await page.driver.navigate().refresh();
  await page.open('#lab');
  assert.match(page.uncaught, /^uncaught: nobody catches it/);
  // It was meant.
  page.uncaught = '';
});
