// A part is loaded when it is opened. Where that fails it is said, everything else goes on, and one can try again.
import assert from 'node:assert/strict';
import { parseHTML } from 'linkedom';
import { askFor, createParts } from '../../../www/parts/load.js';
import { Key, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** The files of scripts that the page has asked for, without their hashes. @param {Page} page @returns {Promise<string[]>} */
const asked = (page) =>
  page.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .map(({ name }) => /assets\/(\w+)-[^/]*\.js$/.exec(name)?.[1])
      .filter((name) => name !== undefined),
  );

/** What stands in the place of the open part. @param {Page} page */
const inPlace = (page) =>
  page.evaluate(() => {
    return {
      failed: /** @type {HTMLElement | null} */ (document.querySelector('.part-failed'))?.innerText ?? '',
      isThere: document.getElementById('luck-run')?.checkVisibility() ?? false,
    };
  });

test('a part is asked for once, by its address and when it is opened', async (t) => {
  const { document } = globalThis;
  t.after(() => {
    globalThis.document = document;
  });
  globalThis.document = parseHTML('<main><section id="cost"></section></main>').document;
  let count = 0;
  const part = /** @type {import('../../../www/parts/part.js').Part} */ (
    /** @type {unknown} */ ({
      name: 'one',
      load: async () => {
        count += 1;
        return () => ({ element: globalThis.document.createElement('section'), draw() {} });
      },
    })
  );
  const tools = /** @type {import('../../../www/parts/part.js').Tools} */ ({});
  for (const address of ['#another', '#one&v=1', '#one']) askFor([part], address);
  const pages = createParts([part], tools, () => {});
  for (let i = 0; i < 2; i += 1) await pages.open('one');
  assert.equal(count, 1);
  assert.equal(pages.size, 1);
});

pageTest('a part is loaded when it is opened, in the language of the page alone', async (page) => {
  await page.open('#lab&lang=ko');
  const first = await asked(page);
  assert.ok(first.includes('ko'));
  assert.ok(!first.includes('en'), 'the other language is loaded');
  await page.click('#page-luck');
  await page.until('Luck is there', () => document.getElementById('luck-run')?.checkVisibility());
  const more = (await asked(page)).slice(first.length);
  assert.ok(more.length >= 2 && more.length <= 8, `for Luck ${more.join(', ')} were loaded`);
  assert.ok(!more.includes('en'));
  assert.deepEqual(await page.problems(), []);
});

pageTest('nothing is shown before the open part is there: the first picture is whole', async (page) => {
  for (const link of ['park', 'training', 'lesson&step=3']) {
    await page.visit(page.site.blank);
    const waits = await page.evaluate((src) => {
      const frame = document.createElement('iframe');
      Object.assign(frame, { src, width: '1000', height: '700' });
      document.body.replaceChildren(frame);
      return new Promise((resolve) => {
        const look = () => {
          const instrument = frame.contentDocument?.getElementById('instrument');
          if (!instrument) return setTimeout(look, 1);
          const shown = () => resolve(frame.contentDocument?.querySelectorAll('.part-waits').length);
          new MutationObserver(shown).observe(instrument, { attributeFilter: ['hidden'] });
        };
        look();
      });
    }, `${page.site.address}#${link}`);
    assert.equal(waits, 0, link);
  }
});

pageTest('Share and the checks are loaded when they are opened, and open at once', async (page) => {
  await page.open('#lab&lang=ko');
  const first = await asked(page);
  const { isOpen, said } = await page.evaluate(() => {
    document.getElementById('keep-button')?.click();
    const dialog = /** @type {HTMLDialogElement} */ (document.getElementById('keep'));
    return { isOpen: dialog.open, said: dialog.textContent };
  });
  assert.ok(isOpen);
  assert.match(String(said), /이 실험의 공유와 저장.*불러오는 중/s);
  assert.match(await page.text('#keep-status'), /지문/);
  const more = (await asked(page)).slice(first.length);
  assert.ok(more.length >= 2 && more.length <= 10, `for Share ${more.join(', ')} were loaded`);
  await page.click('#keep-checks');
  await page.until('the checks run', () => document.getElementById('checks-progress'));
  assert.deepEqual(await page.problems(), []);
});

pageTest('where Share cannot be loaded its sheet says so, and all else goes on', async (page) => {
  const site = await serve(undefined, {
    send: (name, content) => (/dialog-.*\.js$/.test(name) ? null : content),
  });
  try {
    await page.visit(`${site.address}#lab&v=1`);
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    for (const [button, sheet] of [
      ['keep-button', 'keep'],
      ['keys-button', 'keys'],
    ]) {
      await page.click(`#${button}`);
      if (sheet === 'keys') await page.click('#keys-checks');
      const wanted = sheet === 'keys' ? 'checks' : sheet;
      assert.match(await page.text(`#${wanted} .part-failed`), /could not be loaded.*Try again/s);
      await page.click(`#${wanted}-close`);
    }
    await page.click('#one-generation');
    assert.equal(await page.text('#generation'), '1');
  } finally {
    await page.leave();
    await site.close();
  }
});

pageTest(
  'where what is handed in cannot be loaded the exercise says so, and its figure works',
  async (page) => {
    const site = await serve(undefined, {
      send: (name, content) => (/work-.*\.js$/.test(name) ? null : content),
    });
    try {
      await page.visit(`${site.address}#lab&v=1&task=Park.&aim=J%3C8`);
      await page.until('it is said', () =>
        document.querySelector('#exercise .part-failed')?.checkVisibility(),
      );
      assert.match(await page.text('#exercise'), /Park\..*could not be loaded.*Try again/s);
      await page.click('#one-generation');
      assert.equal(await page.text('#generation'), '1');
    } finally {
      await page.leave();
      await site.close();
    }
  },
);

pageTest('what writes a file says so where it cannot be loaded', async (page) => {
  const site = await serve(undefined, {
    send: (name, content) => (/(park|package)-[^/]*\.js$/.test(name) ? null : content),
  });
  const isSaid = (/** @type {string} */ place) =>
    page.until(
      'it is said',
      (selector) => /불러오지 못했습니다.*나머지는/.test(document.querySelector(selector)?.textContent ?? ''),
      place,
    );
  try {
    await page.visit(`${site.address}#lesson&step=build&lang=ko`);
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.until('the step is there', () => document.getElementById('download-python'));
    await page.click('#download-python');
    await isSaid('.downloads .part-failed');
    assert.equal(await page.text('#message'), '');
    await page.click('#page-lab');
    await page.click('#keep-button');
    await page.until('Share is there', () => document.getElementById('keep-exercise'));
    await page.click('#keep-exercise');
    await page.until('the maker is open', () => document.getElementById('maker-scorm')?.checkVisibility());
    await page.click('#maker-scorm');
    await isSaid('#maker-status');
  } finally {
    await page.leave();
    await site.close();
  }
});

pageTest('what follows a try on Park says below the buttons where it cannot be loaded', async (page) => {
  const site = await serve(undefined, {
    send: (name, content) => (name.endsWith('.js') && content.includes('park-climb') ? null : content),
  });
  try {
    await page.visit(`${site.address}#park`);
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.focus('#park-ky');
    await page.press(Key.ARROW_RIGHT);
    await page.until('it is said', () => document.querySelector('.park-bar + div > .part-failed'));
  } finally {
    await page.leave();
    await site.close();
  }
});

pageTest('a part that cannot be loaded says so, and all else goes on until it can', async (page) => {
  /** What is not sent. @type {(name: string, content: Buffer) => boolean} */
  let refuses = (name, content) => /page-.*\.js$/.test(name) && content.includes('luck-finding');
  /** What is sent in its place. @type {Buffer | null} */
  let instead = null;
  const site = await serve(undefined, {
    send: (name, content) => (refuses(name, content) ? instead : content),
  });
  const isSaid = () =>
    page.until('it is said', () => {
      const box = /** @type {HTMLElement | null} */ (document.querySelector('.part-failed'));
      return box?.checkVisibility() && box.innerText;
    });
  try {
    await page.visit(`${site.address}#lab&v=1&seed=7&lang=ko`);
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.click('#page-luck');
    assert.match(await isSaid(), /불러오지 못했습니다.*다시 시도/s);
    assert.equal((await inPlace(page)).isThere, false);

    // Without a network nothing is lost by trying again, nor where another page asks to log in.
    refuses = () => true;
    for (const other of [null, Buffer.from('<h1>Log in</h1>')]) {
      instead = other;
      await page.click('.part-failed button');
      await page.until('it is said again', () =>
        document.querySelector('.part-failed')?.textContent?.includes('아직 불러올 수 없습니다'),
      );
    }
    await page.click('#page-lab');
    await page.click('#one-generation');
    await page.until('the lab goes on', () =>
      /1/.test(document.getElementById('generation')?.textContent ?? ''),
    );

    refuses = () => false;
    await page.click('#page-luck');
    await page.click('.part-failed button');
    await page.until('Luck is there', () => document.getElementById('luck-run')?.checkVisibility());
    assert.deepEqual(await inPlace(page), { failed: '', isThere: true });
    assert.match(await page.evaluate(() => location.hash), /seed=7&generation=1/);
  } finally {
    await page.leave();
    await site.close();
  }
});

pageTest(
  'the lesson is loaded when a step is opened; where it cannot be, its place says so',
  async (page) => {
    await page.open('#lab');
    const first = await asked(page);
    await page.click('#page-lesson');
    await page.until('the step is there', () => document.getElementById('lesson-title')?.checkVisibility());
    assert.ok((await asked(page)).length > first.length, 'the lesson was there before');
    const site = await serve(undefined, {
      send: (name, content) =>
        /page-.*\.js$/.test(name) && content.includes('id="lesson-title"') ? null : content,
    });
    try {
      await page.visit(`${site.address}#lesson&step=3`);
      await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
      await page.until('it is said', () =>
        document.querySelector('#instrument .part-failed')?.checkVisibility(),
      );
      await page.click('#page-lab');
      await page.until('the lab goes on', () => document.getElementById('one-generation')?.checkVisibility());
      assert.equal(await page.evaluate(() => 'lesson' in document.body.dataset), false);
    } finally {
      await page.leave();
      await site.close();
    }
  },
);

pageTest(
  'without a network the page stays, and says that the other language cannot be loaded',
  async (page) => {
    let isThere = true;
    const site = await serve(undefined, { send: (_, content) => (isThere ? content : null) });
    try {
      await page.visit(`${site.address}#lab&v=1&seed=3`);
      await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
      isThere = false;
      await page.click('#language');
      await page.until('it is said', () =>
        /other language cannot be loaded now/.test(document.getElementById('message')?.textContent ?? ''),
      );
      await page.until('it has its address again', () => location.hash === '#lab&v=1&seed=3');
      await page.click('#one-generation');
      await page.until('what changes is written', () => location.hash.endsWith('&generation=1'));
      isThere = true;
      await page.click('#language');
      await page.until(
        'it speaks Korean',
        () => document.documentElement.lang === 'ko' && document.documentElement.dataset.ready,
      );
      assert.equal(await page.text('#generation'), '1');
    } finally {
      await page.leave();
      await site.close();
    }
  },
);
