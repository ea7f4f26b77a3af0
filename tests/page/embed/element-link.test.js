// The first link of an element, which may ask for much, or be wrong, what is said of the later ones, and what its page must allow.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import * as en from '../../../www/words/en/element.js';
import { pageTest } from '../harness/browsers.js';
import { complaint, inPage, isReady, use } from './element.js';

/** As many as no figure comes to at once. */
const most = 100_000;

pageTest(
  'an element whose first link asks for many generations answers at once, and can be paused',
  async (page) => {
    await inPage(page, '', async () => {
      const told = await page.evaluate(async (link) => {
        await customElements.whenDefined('ep-locomotion');
        const own = /** @type {any} */ (document.createElement('ep-locomotion'));
        own.link = link;
        /** @type {string[]} */
        const told = [];
        own.addEventListener('ready', () => told.push('ready'));
        document.body.append(own);
        const { generations: first } = await own.read();
        told.push('read');
        const { generations, evolving } = await own.pause();
        const { generations: further } = await own.step(2);
        return { told, first, generations, further, evolving };
      }, `lab&v=1&seed=7&generation=${most}`);
      const { first, generations } = told;
      assert.deepEqual(told, {
        told: ['read', 'ready'],
        first,
        generations,
        further: generations + 2,
        evolving: false,
      });
      assert.ok(first <= generations && generations < most);
    });
  },
);

pageTest('a figure that can be asked is not called dead, however long its run takes', async (page) => {
  // It is asked twice as one that speaks of itself again, and asks no question a second time.
  const figure = `<script>
    const say = (message) => parent.postMessage({ ep: 1, ...message }, '*');
    const asked = [];
    onmessage = ({ data: { id, type } }) => {
      asked.push(type);
      if (type === 'run') say({ type: 'ready' });
      else if (type === 'read') say({ type: 'state', id, asked });
    };
    say({ type: 'loading' });
    say({ type: 'loading', hears: true });
  </script>`;
  const html = `<script>
    const [begin, end] = [setTimeout, clearTimeout];
    silences = new Set();
    setTimeout = (done, longest) => {
      const id = begin(done, longest);
      if ([15000, 60000].includes(longest)) silences.add(id);
      return id;
    };
    clearTimeout = (id) => {
      silences.delete(id);
      end(id);
    };
  </script>`;
  await inPage(page, html, async () => {
    const { asked, counts } = await page.evaluate(async (text) => {
      await customElements.whenDefined('ep-locomotion');
      const own = /** @type {any} */ (document.createElement('ep-locomotion'));
      own.src = URL.createObjectURL(new Blob([text], { type: 'text/html' }));
      document.body.append(own);
      own.step().catch(() => {});
      const counts = [Reflect.get(window, 'silences').size];
      await own.read();
      counts.push(Reflect.get(window, 'silences').size);
      own.run().catch(() => {});
      await new Promise((resolve) => own.addEventListener('ready', resolve, { once: true }));
      const { asked } = await own.read();
      return { asked, counts };
    }, figure);
    assert.deepEqual(asked, ['step', 'read', 'run', 'read']);
    assert.deepEqual(counts, [1, 0]);
  });
});

pageTest('what is wrong is said of each thing as long as it is wrong, and told once', async (page) => {
  const html = `
    <ep-locomotion id="own" link="lab&amp;seed=q&amp;flavour=red" height="12"></ep-locomotion>
    <script>
      told = [];
      for (const type of ['ready', 'error'])
        own.addEventListener(type, ({ detail }) => told.push(detail.message ?? detail.problems.join(' ')));
    </script>`;
  await inPage(page, html, async () => {
    await isReady(page, 'own');
    const height = en.noHeight(300, 5000, '12');
    const told = await use(page, 'own', 'told');
    const link = told.at(-1);
    assert.match(link, /seed.*flavour/);
    // What is ready says it, and what is said in sight is told.
    assert.deepEqual(told, [height, link, link]);
    /** @param {string} code @param {string[]} said */
    const isSaid = async (code, ...said) => {
      await use(page, 'own', code);
      const wanted = said.map((one) => `<ep-locomotion>: ${one}`).join('\n');
      assert.equal(await complaint(page, 'own'), wanted, code);
    };
    /** What follows the attribute is answered before what is asked after it. @param {string} text */
    const follow = (text) => `{ it.link = '${text}'; await it.step(); await it.read(); }`;
    await isSaid('it.read()', height, link);
    await isSaid(`it.set({ link: 'lab&v=1&seed=5' })`, height);
    await isSaid(follow('lab&seed=4'), height);
    await isSaid(follow('lab&seed=q&flavour=red'), height, link);
    await isSaid(`it.height = '400'`, link);
    await isSaid(`it.label = 'a figure'`, link);
    await isSaid(follow('lab&seed=4'));
    assert.equal(
      (await use(page, 'own', 'told')).filter((/** @type {string} */ one) => one === link).length,
      3,
    );
  });
});

pageTest('the policy that the document asks of a page is enough', async (page) => {
  const document = await readFile(new URL('../../../docs/embedding.md', import.meta.url), 'utf8');
  const [, policy = ''] = /^Content-Security-Policy: (.*your\.host.*)$/m.exec(document) ?? [];
  assert.match(policy, /script-src.*frame-src/);
  const { origin } = new URL(page.site.address);
  const strict = "; style-src 'none'; require-trusted-types-for 'script'; trusted-types 'none'";
  const html = (/** @type {string} */ value) => `
    <meta http-equiv="Content-Security-Policy" content="${value}">
    <ep-locomotion id="own" src="${page.site.address}" link="lab&amp;v=1&amp;seed=7"></ep-locomotion>`;
  const allowed = policy.replaceAll('https://your.host', `'self' ${origin}`);
  for (const more of ['', strict])
    await inPage(page, html(allowed + more), async () => {
      await isReady(page, 'own');
      assert.equal(await complaint(page, 'own'), '');
    });
});
