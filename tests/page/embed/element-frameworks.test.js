// An element in the hands of a framework, which sets properties to nothing, and moves and removes what it likes.
import assert from 'node:assert/strict';
import * as en from '../../../www/words/en/element.js';
import * as ko from '../../../www/words/ko/element.js';
import { linkIn } from '../../../www/embed/link-in.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { figureOf } from './figure.js';
import { complaint, inPage, isReady, use } from './element.js';

const told = `<script>
    told = [];
    own.addEventListener('error', ({ detail }) => told.push(detail.message));
  </script>`;

pageTest('a property that is set to nothing is left out, and so is an empty one', async (page) => {
  await inPage(page, `<ep-locomotion id="own" link="lab&amp;v=1"></ep-locomotion>${told}`, async () => {
    await isReady(page, 'own');
    const frame = `it.shadowRoot.querySelector('iframe')`;
    const before = await use(page, 'own', `[${frame}.src, it.offsetHeight]`);
    for (const value of ['null', 'undefined', "''"]) {
      const code = `{ for (const name of ['height', 'label', 'src']) it[name] = ${value}; await it.read(); return [${frame}.src, it.offsetHeight, ${frame}.title]; }`;
      assert.deepEqual(await use(page, 'own', code), [...before, en.label], value);
      if (value !== "''") assert.deepEqual(await use(page, 'own', 'it.getAttributeNames()'), ['id', 'link']);
      assert.equal(await complaint(page, 'own'), '', value);
    }
    await use(page, 'own', '{ it.height = it.height; it.link = null; }');
    assert.match((await use(page, 'own', 'it.read()')).link, /^lab/);
    assert.equal(await complaint(page, 'own'), '');
    assert.deepEqual(await use(page, 'own', 'told'), []);
  });
});

pageTest('to be moved or removed is no error of a figure', async (page) => {
  const html = `<ep-locomotion id="own" link="lab&amp;v=1"></ep-locomotion><div id="there"></div>${told}`;
  await inPage(page, html, async () => {
    await isReady(page, 'own');
    await use(page, 'own', 'it.step(3)');
    // Kept with its frame, where the browser can.
    const kept = await use(
      page,
      'own',
      '{ if (!there.moveBefore) return 3; there.moveBefore(it, null); return (await it.read()).generation; }',
    );
    assert.equal(kept, 3);
    assert.equal((await use(page, 'own', '{ document.body.append(it); return it.read(); }')).generation, 0);
    assert.deepEqual(await use(page, 'own', '{ it.remove(); return it.read(); }'), { refused: en.gone });
    assert.deepEqual(await page.evaluate(() => Reflect.get(window, 'told')), []);
  });
});

pageTest(
  'an element is as wide as what holds it, also where others would be as narrow as they can',
  async (page) => {
    const html = [
      'display: flex; flex-direction: column; align-items: center',
      'display: flex',
      'display: grid; place-items: center',
      '',
    ]
      .map(
        (style, i) =>
          `<div style="width: 700px; ${style}"><ep-locomotion id="own${i}" style="margin: 0 50px"></ep-locomotion></div>`,
      )
      .join('');
    await inPage(page, html, async () => {
      for (const i of [0, 1, 2, 3]) {
        await page.until('the element is there', (id) => document.getElementById(id)?.shadowRoot, `own${i}`);
        assert.equal(await use(page, `own${i}`, 'it.offsetWidth'), 600, html.split('</div>')[i]);
      }
    });
  },
);

pageTest('in a shadow tree too an element speaks the language around it', async (page) => {
  const html = `<div lang="ko"><p id="host"></p></div><script>
    host.attachShadow({ mode: 'open' }).innerHTML = '<ep-locomotion height="1"></ep-locomotion>';
  </script>`;
  await inPage(page, html, async () => {
    await page.until(
      'it is said',
      (text) =>
        document
          .getElementById('host')
          ?.shadowRoot?.querySelector('ep-locomotion')
          ?.shadowRoot?.querySelector('p')?.textContent === text,
      `<ep-locomotion>: ${ko.noHeight(300, 5000, '1')}`,
    );
  });
});

test('a link is what follows the # of an address, and who works on it also what stands before', () => {
  for (const [address, link] of [
    ['lab&v=1', 'lab&v=1'],
    ['#lab&v=1', 'lab&v=1'],
    ['lab&task=who?', 'lab&task=who?'],
    ['https://host/?lang=ko#lab&v=1', 'lab&v=1'],
    ['https://host/ep/?embed&who=A%20%26%20B#lab&task=x', 'lab&task=x&who=A%20%26%20B'],
    ['?who=a#lab&who=b', 'lab&who=b'],
    ['?who=a#lab&task=x?who=b', 'lab&task=x?who=b'],
    ['https://host/?who=#lab', 'lab'],
  ])
    assert.equal(linkIn(address), link, address);
});

test('a link that is set draws for whom its address names', async () => {
  const { asked } = figureOf();
  const { link } = await asked({ type: 'set', link: 'https://host/?who=s7#lab&v=1&task=x&vary=seed' });
  assert.match(link, /&who=s7$/);
});
