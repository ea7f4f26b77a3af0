// The widget where its notebook takes its figure away: no Python is needed, only what it would send.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import { pageTest } from '../harness/browsers.js';
import { serveHost } from '../harness/host.js';
import { give, has, notebook, sentBy } from './notebook.js';

/** @param {string} path */
const read = (path) => readFile(new URL(`../../../${path}`, import.meta.url));

/** What Python sends of a widget. */
const traits = async () => ({
  _esm: `${await read('dist/embed.js')}\n${await read('python/ep_locomotion/widget.js')}`,
  _page: gzipSync(await read('dist/ep-locomotion.html')).toString('base64'),
  link: 'lab&v=1&seed=7',
  experiment: { goal: { x: 3 } },
  gains: null,
  _wanted: 5,
});

pageTest(
  'a figure that its notebook takes out and puts in again comes back as far as it was',
  async (page) => {
    const host = await serveHost(notebook);
    try {
      await page.visit(host.address);
      await give(page, 'show', await traits());
      const before = await sentBy(page, has(5));
      assert.equal(before.state.experiment.goal.x, 3);
      const moveAndForget = () =>
        page.evaluate(() => {
          const sent = Reflect.get(window, 'sent');
          for (const name of Object.keys(sent)) delete sent[name];
          const cell = /** @type {HTMLElement} */ (document.getElementById('cell'));
          const figure = /** @type {HTMLElement} */ (cell.querySelector('ep-locomotion'));
          cell.append(figure);
        });
      await moveAndForget();
      const { state, _statistics, error } = await sentBy(page, has(5));
      assert.equal(state.hash, before.state.hash);
      assert.deepEqual(_statistics, before._statistics);
      assert.ok(!error, error);
      // Before it is ready, too.
      await moveAndForget();
      await moveAndForget();
      assert.equal((await sentBy(page, has(5))).state.hash, before.state.hash);

      await page.evaluate(() => {
        Reflect.get(window, 'sent').error = '';
        Reflect.get(window, 'leave')();
      });
      assert.equal(await page.evaluate(() => Reflect.get(window, 'sent').error), '');
    } finally {
      await page.leave();
      await host.close();
    }
  },
);
