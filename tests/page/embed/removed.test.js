// A figure that is taken away, or not shown, while it loads, as a page that changes does.
import assert from 'node:assert/strict';
import { engineTest } from '../harness/browsers.js';

engineTest('a frame that is taken away while it loads does not hold the page around it', async (page) => {
  await page.visit(page.site.blank);
  const left = await page.evaluate(async (src) => {
    for (let wait = 0; wait < 200; wait += 5) {
      const frame = document.createElement('iframe');
      Object.assign(frame, { src, width: '640', height: '420' });
      document.body.append(frame);
      await new Promise((resolve) => setTimeout(resolve, wait));
      frame.remove();
    }
    return document.querySelectorAll('iframe').length;
  }, `${page.site.address}?embed#training`);
  assert.equal(left, 0);
});

engineTest(
  'a page that is left while a figure in it loads throws nothing that nobody catches',
  async (page) => {
    for (let wait = 0; wait < 80; wait += 8) {
      await page.visit(page.site.blank);
      await page.evaluate(
        async (src, pause) => {
          const frame = document.createElement('iframe');
          Object.assign(frame, { src, width: '640', height: '420' });
          document.body.append(frame);
          await new Promise((resolve) => setTimeout(resolve, pause));
        },
        `${page.site.address}?embed#training`,
        wait,
      );
      await page.leave();
      assert.equal(page.uncaught, '', `after ${wait} ms`);
    }
  },
);

engineTest('a figure that is not shown while it opens opens all the same', async (page) => {
  await page.visit(page.site.blank);
  await page.evaluate((src) => {
    document.body.innerHTML = '<iframe hidden width="640" height="420"></iframe>';
    Object.assign(document.body.firstElementChild ?? {}, { src });
  }, `${page.site.address}?embed#lab`);
  // No frame is drawn yet.
  await page.until('it is made', () =>
    Boolean(document.querySelector('iframe')?.contentDocument?.getElementById('gain-kx')),
  );
  await page.evaluate(() => document.querySelector('iframe')?.removeAttribute('hidden'));
  await page.until(
    'it is ready',
    () => document.querySelector('iframe')?.contentDocument?.documentElement.dataset.ready,
  );
  await page.leave();
});
