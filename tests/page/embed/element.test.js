// The element <ep-locomotion> in a page of another host.
import assert from 'node:assert/strict';
import { createServer } from 'node:net';
import { parts } from '../../../www/parts/parts.js';
import { wantedHeight } from '../../../www/embed/frame.js';
import { allowed } from '../../../www/embed/frame-line.js';
import * as en from '../../../www/words/en/element.js';
import * as ko from '../../../www/words/ko/element.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { evolve, experiment, historyOf } from '../harness/core.js';
import { complaint, inPage, isReady, use } from './element.js';

engineTest('an element shows a figure, does what its page asks, and tells what comes of it', async (page) => {
  const html = `
    <ep-locomotion id="own" link="lab&amp;v=1&amp;seed=7"></ep-locomotion>
    <ep-locomotion id="other" src="${page.site.address}" link="landscape&amp;v=1" height="400"></ep-locomotion>
    <div style="height: 9000px"></div>
    <ep-locomotion id="far" link="lab&amp;v=1&amp;seed=5"></ep-locomotion>
    <script>
      told = [];
      for (const type of ['ready', 'generation', 'state', 'error'])
        own.addEventListener(type, ({ detail }) => told.push({ type, detail }));
    </script>`;
  await inPage(page, html, async () => {
    await isReady(page, 'own');
    await isReady(page, 'other');
    const [width, height] = await use(page, 'own', '[it.offsetWidth, it.offsetHeight]');
    assert.equal(height, wantedHeight(parts, 'lab', 0, width));
    assert.equal(await use(page, 'other', 'it.offsetHeight'), 400);
    assert.equal((await use(page, 'own', 'it.state')).link, 'lab&v=1&seed=7');
    assert.equal(await use(page, 'other', `it.shadowRoot.querySelector('iframe').allow`), allowed);

    const goal = { x: 1.5, y: 1, theta: 0.5 };
    const moved = experiment({ goal, evolution: { seed: 3 } });
    const { hash } = evolve(moved, 20);
    const asked = `it.set({ experiment: { goal: ${JSON.stringify(goal)}, evolution: { seed: 3 } }, gains: [4, 1, 6] })`;
    const set = await use(page, 'own', asked);
    assert.deepEqual([set.experiment.goal, set.drive.gains, set.generations], [goal, [4, 1, 6], 0]);
    // Both at once, in their order.
    const both = await use(page, 'own', 'Promise.all([it.step(19), it.step()])');
    assert.deepEqual(
      both.map((/** @type {{ generations: number }} */ { generations }) => generations),
      [19, 20],
    );
    assert.equal(both[1].hash, hash);
    assert.equal(await use(page, 'own', 'it.state.hash'), hash);
    /** @type {{ type: string, detail: any }[]} */
    const told = await use(page, 'own', 'told');
    assert.deepEqual(
      told.filter(({ type }) => type === 'generation').map(({ detail }) => detail),
      [...historyOf(experiment({ evolution: { seed: 7 } }), 0), ...historyOf(moved, 20)],
    );
    assert.deepEqual(
      told.map(({ type }) => type).filter((type) => type !== 'generation'),
      ['ready', 'state', 'state', 'state'],
    );

    assert.equal((await use(page, 'other', 'it.run()')).evolving, true);
    assert.equal((await use(page, 'other', 'it.pause()')).evolving, false);
    for (const setting of [`'lab&v=1&seed=11'`, `{ link: 'lab&v=1&seed=12' }`]) {
      const { link } = await use(page, 'other', `it.set(${setting})`);
      assert.ok(setting.includes(link), link);
    }
    assert.match((await use(page, 'own', 'it.set({ experiment: { flavour: 1 } })')).refused, /flavour/);
    assert.match((await use(page, 'own', 'it.step(0.5)')).refused, /generations must be/);
    assert.equal((await use(page, 'own', 'told.at(-1)')).type, 'error');
    assert.equal(await complaint(page, 'own'), '');

    // A link that is changed is followed, and what is wrong with it is said.
    await use(page, 'own', `it.link = 'https://host/#curves&v=1&seed=9&generation=2'`);
    assert.match((await use(page, 'own', 'it.read()')).link, /^curves&v=1&seed=9/);
    await page.until(
      'the link is followed',
      () =>
        Reflect.get(document.getElementById('own') ?? {}, 'state').link === 'curves&v=1&seed=9&generation=2',
    );
    await use(page, 'own', `it.link = 'lab&seed=9&goal.x=1000000'`);
    await page.until('it is said', () =>
      /goal\.x/.test(document.getElementById('own')?.shadowRoot?.querySelector('p')?.innerText ?? ''),
    );

    // What nobody sees loads when it is asked for.
    assert.equal(await use(page, 'far', 'it.state'), null);
    assert.equal((await use(page, 'far', 'it.step(2)')).generation, 2);

    // Elsewhere in the page it begins anew, and no question stays open.
    assert.deepEqual(
      // WebKit takes what is refused meanwhile for uncaught.
      await use(
        page,
        'far',
        '{ const open = it.read().catch(({ message }) => message); document.body.prepend(it); return open; }',
      ),
      en.gone,
    );
    const { refused, generation } = await use(page, 'far', 'it.read()');
    assert.deepEqual({ refused, generation }, { refused: undefined, generation: 0 });
    // Out of the page nobody answers.
    assert.deepEqual(await use(page, 'far', '{ it.remove(); return it.read(); }'), { refused: en.gone });
  });
});

pageTest('what the author of a page has wrong is said in sight', async (page) => {
  const old = `data:text/html,<script>parent.postMessage({ ep: 2, type: 'ready' }, '*')</script>`;
  // Side by side, for what is far below loads later.
  const html = `
    <div style="display: grid; grid-template-columns: repeat(5, 1fr); align-items: start">
    <div lang="kok"><ep-locomotion id="low" height="100"></ep-locomotion></div>
    <ep-locomotion id="nowhere" src="https://"></ep-locomotion>
    <ep-locomotion id="absent" src="/absent.html"></ep-locomotion>
    <ep-locomotion id="old" src="${old}"></ep-locomotion>
    <div lang="KO-kr"><ep-locomotion id="korean" height="high"></ep-locomotion></div>
    </div>
    <script>
      const usual = setTimeout;
      // Nobody is to wait until the silence is long enough.
      setTimeout = (done, longest) => usual(done, Math.min(longest, 100));
    </script>`;
  await inPage(page, html, async (address) => {
    for (const id of ['low', 'korean']) await isReady(page, id);
    for (const [id, text] of [
      ['low', en.noHeight(300, 5000, '100')],
      ['nowhere', en.noAddress('https://')],
      ['absent', en.silent(`${address}absent.html`)],
      ['old', en.otherVersion(2, 1)],
      ['korean', ko.noHeight(300, 5000, 'high')],
    ]) {
      const wanted = `<ep-locomotion>: ${text}`;
      await page.until(
        `${id} says what is wrong`,
        (name, words) =>
          document.getElementById(name)?.shadowRoot?.querySelector('p')?.innerText.trim() === words,
        id,
        wanted,
      );
    }
    // Once it is mended, nothing is said.
    await use(page, 'low', `it.height = '500'`);
    assert.equal(await complaint(page, 'low'), '');
    assert.equal(await use(page, 'low', 'it.offsetHeight'), 500);
    await use(page, 'absent', `it.src = 'dist/index.html'`);
    await isReady(page, 'absent');
    assert.equal(await complaint(page, 'absent'), '');
    // Nor is anybody to wait for an answer that will not come.
    for (const [id, why] of [
      ['old', en.otherVersion(2, 1)],
      ['nowhere', en.noAddress('https://')],
    ])
      assert.deepEqual(await use(page, id, 'it.read()'), { refused: why });
    // Who has spoken is not called silent.
    assert.equal(await complaint(page, 'old'), `<ep-locomotion>: ${en.otherVersion(2, 1)}`);
  });
});

pageTest('a figure says that it is on its way, and who says so is given time', async (page) => {
  const slow = `data:text/html,<script>parent.postMessage({ ep: 1, type: 'loading' }, '*')</script>`;
  const html = `
    <ep-locomotion id="slow" src="${slow}"></ep-locomotion>
    <script>
      said = [];
      addEventListener('message', ({ data }) => said.push(data.type));
      const usual = setTimeout;
      // Nobody is to wait until the silence is long enough, but for who is given time.
      setTimeout = (done, longest) => usual(done, longest === 15000 ? 100 : longest);
    </script>`;
  await inPage(page, html, async (address) => {
    await page.until('it has said so', () => Reflect.get(window, 'said').includes('loading'));
    await page.evaluate(() => {
      Reflect.get(window, 'said').length = 0;
      for (const [id, src] of [
        ['absent', '/absent.html'],
        ['own', '/dist/index.html'],
      ]) {
        const figure = Object.assign(document.createElement('ep-locomotion'), { id });
        figure.setAttribute('src', src);
        document.body.prepend(figure);
      }
    });
    const silent = `<ep-locomotion>: ${en.silent(`${address}absent.html`)}`;
    await page.until(
      'the silent one is called so',
      (text) => document.getElementById('absent')?.shadowRoot?.querySelector('p')?.textContent === text,
      silent,
    );
    assert.equal(await complaint(page, 'slow'), '');
    await isReady(page, 'own');
    assert.deepEqual((await use(page, 'own', 'said')).slice(0, 3), ['loading', 'loading', 'ready']);
    assert.equal(await complaint(page, 'own'), '');
  });
});

pageTest('of a server that never answers it is said, and no question to it stays open', async (page) => {
  /** @type {import('node:net').Socket[]} */
  const held = [];
  const server = createServer((socket) => held.push(socket));
  await new Promise((resolve) => server.listen(0, '127.0.0.1', () => resolve(null)));
  const bound = server.address();
  const silent = `http://127.0.0.1:${typeof bound === 'object' ? bound?.port : ''}/`;
  const html = `<p></p><script>
      const usual = setTimeout;
      // Nobody is to wait until the silence is long enough: here that is as long as a frame may load.
      setTimeout = (done, longest) => usual(done, longest === 60000 ? 100 : longest);
    </script>`;
  try {
    await inPage(page, html, async () => {
      // The page has loaded before the frame begins to. One figure is asked before it is in the page.
      for (const isEarly of [false, true]) {
        const refused = await page.evaluate(
          async (src, early) => {
            await customElements.whenDefined('ep-locomotion');
            const figure = /** @type {any} */ (document.createElement('ep-locomotion'));
            Object.assign(figure, { id: 'silent' }).setAttribute('src', src);
            const asked = early && figure.read();
            document.body.append(figure);
            return (asked || figure.read()).catch((/** @type {Error} */ { message }) => message);
          },
          silent,
          isEarly,
        );
        assert.equal(refused, en.silent(silent));
        assert.equal(await complaint(page, 'silent'), `<ep-locomotion>: ${en.silent(silent)}`);
        // So that the page can be left.
        await page.evaluate(() => document.getElementById('silent')?.remove());
      }
    });
  } finally {
    for (const socket of held) socket.destroy();
    server.close();
  }
});
