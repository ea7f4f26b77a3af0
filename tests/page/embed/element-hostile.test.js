// An element that is removed, misused, or answered by nobody.
import assert from 'node:assert/strict';
import * as en from '../../../www/words/en/element.js';
import { engineTest } from '../harness/browsers.js';
import { evolve, experiment } from '../harness/core.js';
import { serveHost } from '../harness/host.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Opens a page of another host with what stands in it. @param {Page} page @param {string} html @param {(address: string) => Promise<void>} body */
async function inPage(page, html, body) {
  const errors = `<script>
    errors = [];
    addEventListener('error', ({ message }) => errors.push(message));
    addEventListener('unhandledrejection', ({ reason }) => errors.push(String(reason)));
  </script>`;
  const host = await serveHost(`${errors}${html}<script type="module" src="/dist/embed.js"></script>`);
  try {
    await page.visit(host.address);
    await body(host.address);
    assert.deepEqual(await page.evaluate(() => Reflect.get(window, 'errors')), []);
  } finally {
    await page.leave();
    host.close();
  }
}

/** @param {Page} page @param {string} id */
const isReady = (page, id) =>
  page.until(`${id} is ready`, (name) => Reflect.get(document.getElementById(name) ?? {}, 'state'), id);

engineTest(
  'a figure that is removed while it computes leaves nothing behind, and begins anew',
  async (page) => {
    const html = '<ep-locomotion id="own" link="lab&amp;v=1&amp;seed=7"></ep-locomotion>';
    await inPage(page, html, async () => {
      await isReady(page, 'own');
      const { refused, hash } = await page.evaluate(async () => {
        const own = /** @type {any} */ (document.getElementById('own'));
        const open = Promise.allSettled([own.step(10_000), own.read()]);
        // It has begun.
        await new Promise((resolve) => own.addEventListener('generation', resolve, { once: true }));
        own.remove();
        const results = await open;
        document.body.append(own);
        const { hash } = await own.step(5);
        return { refused: results.map((one) => String(Reflect.get(one, 'reason')?.message)), hash };
      });
      assert.deepEqual(refused, [en.gone, en.gone]);
      assert.equal(hash, evolve(experiment({ evolution: { seed: 7 } }), 5).hash);
    });
  },
);

engineTest('hostile attributes of the element do no harm', async (page) => {
  const html = `
    <div style="display: grid; grid-template-columns: repeat(4, 1fr); align-items: start">
    <ep-locomotion id="script" src="javascript:parent.errors.push('it ran')"></ep-locomotion>
    <ep-locomotion id="high" height="1e9"></ep-locomotion>
    <ep-locomotion id="marks" link='lab&amp;v=1"><img src=x onerror="errors.push(1)">' label='"><script>errors.push(2)</script>'></ep-locomotion>
    <ep-locomotion id="long"></ep-locomotion>
    </div>
    <script>
      const long = document.getElementById('long');
      long.setAttribute('link', 'lab&v=1&' + 'k'.repeat(5e6));
      long.setAttribute('label', 'x'.repeat(1e6));
    </script>`;
  await inPage(page, html, async () => {
    for (const id of ['high', 'marks', 'long']) await isReady(page, id);
    const said = await page.evaluate(() =>
      Object.fromEntries(
        ['script', 'high'].map((id) => [
          id,
          document.getElementById(id)?.shadowRoot?.querySelector('p')?.textContent,
        ]),
      ),
    );
    assert.equal(said.script, `<ep-locomotion>: ${en.noAddress("javascript:parent.errors.push('it ran')")}`);
    assert.equal(said.high, `<ep-locomotion>: ${en.noHeight(300, 5000, '1e9')}`);
    const refused = await page.evaluate(async () => {
      const marks = /** @type {any} */ (document.getElementById('marks'));
      // What cannot be sent is refused where it is asked, and the next question is answered.
      const refused = await marks
        .set({ experiment: { law() {} } })
        .catch((/** @type {Error} */ { name }) => name);
      await marks.read();
      return refused;
    });
    assert.equal(refused, 'DataCloneError');
    // Mended, it shows its figure.
    await page.evaluate(() => document.getElementById('script')?.setAttribute('src', '/dist/index.html'));
    await isReady(page, 'script');
  });
});

engineTest('where nothing answers, it is said, and no question stays open', async (page) => {
  const html = `
    <ep-locomotion id="absent" src="/absent.html"></ep-locomotion>
    <script>
      const usual = setTimeout;
      // Nobody is to wait until the silence is long enough.
      setTimeout = (done, longest) => usual(done, [15000, 60000].includes(longest) ? 100 : longest);
    </script>`;
  await inPage(page, html, async (address) => {
    const asked = () =>
      page.evaluate(() =>
        /** @type {any} */ (document.getElementById('absent'))
          .read()
          .catch((/** @type {Error} */ error) => error.message),
      );
    const silent = en.silent(`${address}absent.html`);
    assert.equal(await asked(), silent);
    await page.until('it is said', () =>
      document.getElementById('absent')?.shadowRoot?.querySelector('p')?.textContent?.includes('absent'),
    );
    assert.equal(await asked(), silent, 'asked once more, when it is known');
  });
});
