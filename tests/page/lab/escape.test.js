// What is typed in a field is taken back with Escape.
import assert from 'node:assert/strict';
import { Key, engineTest, pageTest } from '../harness/browsers.js';

pageTest('Escape takes back what was typed of a gain, and of the name of a pin', async (page) => {
  // As the page itself writes it.
  await page.open('#curves&v=1&drives=hand&gains=3,1,5&view=compare&pin1=first~5,1,5');
  await page.until('the pin has a name', () => document.querySelector('#pin-name-1'));
  const told = () =>
    page.evaluate(() => {
      const fields = [...document.querySelectorAll('#gain-ky, #pin-name-1')];
      return [location.hash, ...fields.map((field) => /** @type {HTMLInputElement} */ (field).value)];
    });
  const before = await told();
  assert.deepEqual(before.slice(1).toSorted(), ['1.000', 'first']);
  for (const field of ['gain-ky', 'pin-name-1']) {
    await page.focus(`#${field}`);
    await page.press('9', '9', Key.ESCAPE, Key.TAB);
    assert.notEqual(await page.evaluate(() => document.activeElement?.id), field);
    assert.deepEqual(await told(), before, field);
  }
});

engineTest('Escape in the field of a gain leaves who drives, also while evolution goes on', async (page) => {
  await page.open('#lab&v=1&seed=3');
  await page.focus('#gain-ky');
  await page.press('9');
  // Without the pointer, which would leave the field.
  const before = await page.evaluate(() => {
    document.getElementById('run')?.click();
    return /** @type {HTMLInputElement} */ (document.getElementById('gain-kx')).value;
  });
  await page.until(
    'other gains drive by now',
    (kx) => /** @type {HTMLInputElement} */ (document.getElementById('gain-kx')).value !== kx,
    before,
  );
  await page.press(Key.ESCAPE, Key.TAB);
  assert.notEqual(await page.evaluate(() => document.activeElement?.id), 'gain-ky');
  assert.equal(
    await page.evaluate(() => document.querySelector('#drives input:checked')?.id),
    'drives-evolved',
  );
});
