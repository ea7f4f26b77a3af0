// For whom an exercise is made.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { openMaker } from './making.js';

pageTest(
  'an exercise is made for whoever opens it, and a student’s own link says who works on it',
  async (page) => {
    const values = (/** @type {string[]} */ ...ids) =>
      page.evaluate(
        (names) =>
          names.map(
            (id) => /** @type {HTMLInputElement | null} */ (document.getElementById(id))?.value ?? '',
          ),
        ids,
      );
    await openMaker(page, '?who=s4711#lab&v=1&aim=J%3C8');
    for (const value of await values('maker-link', 'maker-frame')) {
      assert.match(value, /aim=J%3C8/);
      assert.doesNotMatch(value, /who=/);
    }
    await page.click('#maker-preview-size-400x300');
    const shown = await page.until(
      'the figure is there',
      () => /** @type {HTMLIFrameElement | null} */ (document.getElementById('maker-figure'))?.src,
    );
    assert.match(shown, /\?embed#[^?]*aim=J%3C8$/);
    await page.press(Key.ESCAPE);
    await page.click('#keep-button');
    await page.until('Share is there', () => document.getElementById('keep-link')?.checkVisibility());
    assert.match((await values('keep-link'))[0], /\/#lab&v=1&aim=J%3C8&who=s4711$/);
  },
);
