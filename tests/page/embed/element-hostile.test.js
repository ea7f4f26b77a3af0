// An element that is removed, misused, or answered by nobody, or by a figure that cannot go on.
import assert from 'node:assert/strict';
import * as en from '../../../www/words/en/element.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { evolve, experiment } from '../harness/core.js';
import { ask, heardFrom, within } from '../harness/host.js';
import { serve } from '../harness/server.js';
import { withTrap } from '../harness/trap.js';
import { inPage, isReady } from './element.js';

engineTest(
  'a figure that is removed while it computes leaves nothing behind, and begins anew',
  async (page) => {
    const html = '<ep-locomotion id="own" link="lab&amp;v=1&amp;seed=7"></ep-locomotion>';
    await inPage(page, html, async () => {
      await isReady(page, 'own');
      const { refused, hash } = await page.evaluate(async () => {
        const own = /** @type {any} */ (document.getElementById('own'));
        const open = Promise.allSettled([own.step(10_000), own.step()]);
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

pageTest('hostile attributes of the element do no harm', async (page) => {
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

pageTest('where nothing answers, no question waits once that is known', async (page) => {
  const html = `
    <ep-locomotion id="absent" src="/absent.html"></ep-locomotion>
    <script>
      const usual = setTimeout;
      // The silence ends soon, and once it is said no other does.
      const soon = (done) => absent.shadowRoot.querySelector('p').textContent || usual(done, 100);
      setTimeout = (done, longest) => [15000, 60000].includes(longest) ? soon(done) : usual(done, longest);
    </script>`;
  await inPage(page, html, async (address) => {
    const asked = () =>
      page.evaluate(() =>
        /** @type {any} */ (document.getElementById('absent')).read().then(
          ({ link = '' }) => link,
          (/** @type {Error} */ { message }) => message,
        ),
      );
    const silent = en.silent(`${address}absent.html`);
    assert.equal(await asked(), silent);
    assert.equal(await asked(), silent, 'asked once more, when it is known');
    // Whoever speaks there after all is asked.
    await page.evaluate((figure) => {
      const frame = document.getElementById('absent')?.shadowRoot?.querySelector('iframe');
      Reflect.get(frame?.contentWindow ?? {}, 'eval')(figure);
    }, `onmessage = ({ data: { id } }) => parent.postMessage({ ep: 1, type: 'state', id, link: 'late' }, '*'); parent.postMessage({ ep: 1, type: 'ready' }, '*')`);
    await isReady(page, 'absent');
    assert.equal(await asked(), 'late');
  });
});

pageTest('src set anew, even to the same page, is a figure of its own', async (page) => {
  // It says both before its page has heard the first.
  const other = `data:text/html,<script>for (const said of [{ mark: 1 }, { ep: 1, type: 'ready', link: 'other' }, { ep: 1, type: 'generation', generation: 99 }]) parent.postMessage(said, '*')</script>`;
  const html = `
    <script>
      addEventListener('message', ({ data }) => {
        if (data.mark) own.setAttribute('src', '/dist/index.html');
      });
    </script>
    <ep-locomotion id="own" src="${other}" link="lab&amp;v=1&amp;seed=7"></ep-locomotion>
    <script>
      told = [];
      for (const type of ['ready', 'generation', 'error'])
        own.addEventListener(type, ({ detail }) => told.push([type, detail.link ?? detail.generation ?? detail.message]));
    </script>`;
  await inPage(page, html, async () => {
    await page.until('the next figure is ready', () => Reflect.get(window, 'told').length >= 2);
    const first = [
      ['ready', 'lab&v=1&seed=7'],
      ['generation', 0],
    ];
    assert.deepEqual(await page.evaluate(() => Reflect.get(window, 'told')), first);

    const results = await page.evaluate(async () => {
      const own = /** @type {any} */ (document.getElementById('own'));
      const results = [];
      for (const [src, link] of [
        ['/dist/index.html', 'lab&v=1&seed=7'],
        ['/dist/index.html', 'curves&v=1&seed=9'],
        ['/dist/index.html#landscape', 'curves&v=1&seed=9'],
        ['/dist/index.html?', 'lab&v=1&seed=5'],
      ]) {
        const before = [own.step(10_000), own.read()];
        own.link = link;
        own.src = src;
        const after = own.step(2);
        const refused = await Promise.allSettled(before);
        const { link: opened, generations } = await after;
        results.push({
          refused: refused.map((one) => Reflect.get(one, 'reason')?.message),
          opened,
          generations,
          complaint: own.shadowRoot.querySelector('p').textContent,
        });
      }
      return results;
    });
    assert.deepEqual(
      results,
      ['lab&v=1&seed=7', 'curves&v=1&seed=9', 'curves&v=1&seed=9', 'lab&v=1&seed=5'].map((link) => ({
        refused: [en.replaced, en.replaced],
        opened: `${link}&generation=2`,
        generations: 2,
        complaint: '',
      })),
    );
    // Neither an old figure nor its end is told.
    const errors = await page.evaluate(() =>
      Reflect.get(window, 'told').filter((/** @type {unknown[]} */ [type]) => type === 'error'),
    );
    assert.deepEqual(errors, []);
  });
});

/** @param {(content: Buffer) => Buffer | null} change */
const coreThatIs = (change) => ({
  send: (/** @type {string} */ file, /** @type {Buffer} */ content) =>
    file.endsWith('.wasm') ? change(content) : content,
});

pageTest('a figure that cannot begin says why, and whoever asks is told', async (page) => {
  for (const [changes, link] of /** @type {const} */ ([
    [coreThatIs(() => null), 'lab'],
    [coreThatIs(() => Buffer.from('no module')), 'landscape&v=1'],
    [coreThatIs((content) => withTrap(content, 'evolution_step')), 'lab&v=1&seed=7&generation=3'],
  ])) {
    const site = await serve(undefined, changes);
    const html = `
      <iframe src="${site.address}?embed#${link.replaceAll('&', '&amp;')}" width="640" height="300"></iframe>
      <ep-locomotion id="own" src="${site.address}" link="${link.replaceAll('&', '&amp;')}"></ep-locomotion>`;
    try {
      await inPage(page, html, async () => {
        await page.until('the page around the frame is told', () =>
          Reflect.get(window, 'heard').some((/** @type {{ frame: number }} */ { frame }) => frame === 0),
        );
        const [{ message, ...told }, ...more] = await heardFrom(page, 0);
        assert.match(message, /^The robots cannot drive here: /);
        assert.deepEqual([told, more], [{ ep: 1, type: 'error' }, []]);
        const { id, ...answer } = await ask(page, 0, { type: 'read' });
        assert.deepEqual(answer, { ep: 1, type: 'error', message });

        const refused = () =>
          page.evaluate(async () => {
            const own = /** @type {any} */ (document.getElementById('own'));
            const said = await own.read().catch((/** @type {Error} */ error) => error.message);
            return [said, own.shadowRoot.querySelector('p').textContent];
          });
        assert.deepEqual(await refused(), [message, `<ep-locomotion>: ${message}`]);
        assert.deepEqual(await refused(), [message, `<ep-locomotion>: ${message}`], 'asked once more');
      });
    } finally {
      await site.close();
    }
  }
});

pageTest('a figure that begins badly and goes on is asked all the same', async (page) => {
  await inPage(page, '', async () => {
    const told = await page.evaluate(async () => {
      await customElements.whenDefined('ep-locomotion');
      const figure = `<script>
        addEventListener('message', ({ data: { id } }) => parent.postMessage({ ep: 1, type: 'state', id }, '*'));
        parent.postMessage({ ep: 1, type: 'error', message: 'A worker was lost' }, '*');
      </script>`;
      const own = /** @type {any} */ (document.createElement('ep-locomotion'));
      own.setAttribute('src', URL.createObjectURL(new Blob([figure], { type: 'text/html' })));
      /** @type {string[]} */
      const errors = [];
      own.addEventListener('error', (/** @type {CustomEvent} */ { detail }) => errors.push(detail.message));
      document.body.append(own);
      await own.read();
      await own.read();
      return [errors, own.shadowRoot.querySelector('p').textContent];
    });
    assert.deepEqual(told, [['A worker was lost'], '<ep-locomotion>: A worker was lost']);
  });
});

pageTest(
  'where the core has failed each question is answered by an error, and nothing more is thrown',
  async (page) => {
    // It takes gains by hand.
    const site = await serve(
      undefined,
      coreThatIs((content) => withTrap(content, 'simulation_new')),
    );
    const html = `
    <iframe src="${site.address}?embed#lab&amp;v=1&amp;seed=7" width="640" height="420"></iframe>
    <ep-locomotion id="own" src="${site.address}" link="lab&amp;v=1&amp;seed=7"></ep-locomotion>`;
    try {
      await inPage(page, html, async () => {
        await isReady(page, 'own');
        await page.until('the frame is ready', () =>
          Reflect.get(window, 'heard').some(
            (/** @type {{ frame: number, data: any }} */ { frame, data }) =>
              frame === 0 && data.type === 'ready',
          ),
        );
        const byHand = { type: 'set', experiment: {}, gains: [4, 1, 6] };
        const link = { type: 'set', link: 'lab&v=1' };
        for (const message of [byHand, { type: 'read' }, { type: 'step' }, link, { type: 'run' }, byHand]) {
          const answer = await ask(page, 0, message);
          assert.equal(answer.type, 'error', JSON.stringify(message));
          assert.match(answer.message, /error within the program has stopped it/);
        }
        const thrown = await within(page, 0, () => page.problems());
        assert.equal(thrown.length, 1, thrown.join());
        assert.match(thrown[0], /^uncaught: .*(unreachable|RuntimeError)/);

        const refused = await page.evaluate(async () => {
          const own = /** @type {any} */ (document.getElementById('own'));
          const asked = [own.set({ experiment: {}, gains: [4, 1, 6] }), own.read(), own.step(), own.pause()];
          const results = await Promise.allSettled(asked);
          return results.map((one) => String(Reflect.get(one, 'reason')?.message));
        });
        for (const said of refused) assert.match(said, /error within the program has stopped it/);
        assert.equal(refused.length, 4);
      });
    } finally {
      await site.close();
    }
  },
);
