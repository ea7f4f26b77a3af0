// No error is silent: what nobody has caught fails every test of the page, also when its page is left or loaded again.
import assert from 'node:assert/strict';
import { createApart } from '../../../www/kit/loop.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';

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

test('what one throws in a frame keeps no other from its turn, and is told once', () => {
  /** @type {string[]} */
  const told = [];
  /** @type {string[]} */
  const drawn = [];
  const apart = createApart((error) => told.push(String(error)));
  for (let frame = 1; frame <= 4; frame += 1) {
    apart('curve', () => {
      if (frame !== 2) throw new Error(frame < 4 ? 'no curve' : 'no axis');
    });
    apart('notes', () => drawn.push(`notes ${frame}`));
  }
  apart('notes', () => {
    throw new Error('no curve');
  });
  assert.deepEqual(drawn, ['notes 1', 'notes 2', 'notes 3', 'notes 4']);
  assert.deepEqual(told, ['Error: no curve', 'Error: no axis', 'Error: no curve']);
});

test('what tells of an error may throw it on, at every turn', () => {
  const apart = createApart((error) => {
    throw error;
  });
  for (let frame = 1; frame <= 2; frame += 1)
    assert.throws(() =>
      apart('curve', () => {
        throw new Error('lost');
      }),
    );
});

pageTest('a view that cannot be drawn leaves all others theirs, and is told once', async (page) => {
  await page.open('#lab');
  await page.evaluate(() => {
    // A place in which the lab writes at every frame.
    const place = /** @type {HTMLElement} */ (document.getElementById('generation'));
    place.id = 'taken';
  });
  for (let i = 0; i < 3; i += 1) await page.click('#one-generation');
  await page.until('the timeline has all of them', () => {
    const { max, value } = /** @type {HTMLInputElement} */ (document.getElementById('timeline'));
    return max === '3' && value === '3';
  });
  await page.click('#settings-button');
  await page.until('the settings are open', () => document.getElementById('settings')?.checkVisibility());
  const told = (await page.problems()).filter((problem) => problem.startsWith('uncaught'));
  assert.equal(told.length, 1, told.join());
  await page.leave();
  assert.notEqual(page.uncaught, '');
  // It was meant.
  page.uncaught = '';
});

pageTest('a lab that cannot be made leaves the parts as they are', async (page) => {
  await page.open('');
  await page.evaluate(() => document.getElementById('gains')?.remove());
  for (const name of ['lab', 'luck']) {
    await page.click(`#page-${name}`);
    await page.until(`${name} is open`, (open) => document.body.dataset.open === open, name);
  }
  await page.until('Luck alone is in sight', () => {
    const [park, luck] = ['park', 'luck'].map((part) => document.querySelector(`section.${part}`));
    return luck?.checkVisibility() && !park?.checkVisibility();
  });
  await page.click('#page-lab');
  assert.equal(await page.evaluate(() => document.querySelectorAll('#curve canvas').length), 1);
  assert.match((await page.problems()).join(), /^uncaught: /);
  await page.leave();
  assert.notEqual(page.uncaught, '');
  // It was meant.
  page.uncaught = '';
});

pageTest('a click that would meet something else is an error of its test', async (page) => {
  await page.open('#lab');
  await page.evaluate(() => {
    const cover = document.createElement('div');
    Object.assign(cover.style, { position: 'fixed', inset: '0', zIndex: '1000' });
    document.body.append(cover);
  });
  await assert.rejects(page.click('#one-generation'), /intercepted/i);
  assert.equal(await page.text('#generation'), '0');
});
