// How much a first visit loads, compressed as hosts do: budgets.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import { pageTest } from '../harness/browsers.js';
import { serve } from '../harness/server.js';

/** The address alone opens the parking place. @type {readonly (readonly [fragment: string, bytes: number])[]} */
const budgets = [
  ['', 235_000],
  ['#lab', 227_000],
  ['#lab&v=1&lang=ko', 229_000],
];

pageTest('a first visit loads no more than it may', async (page) => {
  for (const [fragment, budget] of budgets) {
    await page.open(fragment);
    const paths = await page.evaluate(() =>
      [...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')].map(
        ({ name }) => new URL(name).pathname,
      ),
    );
    const { pathname } = new URL(page.site.address);
    const files = paths
      .filter((path) => path.startsWith(pathname))
      .map((path) => path.slice(pathname.length) || 'index.html');
    const sizes = await Promise.all(
      files.map(async (file) => {
        const content = await readFile(new URL(`../../../dist/${file}`, import.meta.url));
        return { file, size: gzipSync(content, { level: 9 }).length };
      }),
    );
    const sum = sizes.reduce((before, { size }) => before + size, 0);
    for (const kind of ['.html', '.css', '.js', '.wasm'])
      assert.ok(
        files.some((file) => file.endsWith(kind)),
        `no ${kind} was loaded`,
      );
    const all = sizes.map(({ file, size }) => `\n  ${size} ${file}`).join('');
    assert.ok(
      sum <= budget,
      `${fragment || 'the address alone'} loads ${sum} bytes, of ${budget} that it may:${all}`,
    );
  }
});

pageTest('what is in sight while the page opens stays where it is', async (page) => {
  for (const width of [1200, 500]) {
    await page.resize(width, 900);
    for (const fragment of ['', '#lab', '#training', '#lesson&step=3', '#lab&v=1&lang=ko']) {
      await page.open(fragment);
      const moved = await page.evaluate(
        () =>
          /** @type {Promise<number>} */ (
            new Promise((resolve) => {
              const observer = new PerformanceObserver((list) =>
                resolve(
                  list
                    .getEntriesByType('layout-shift')
                    .reduce((sum, entry) => sum + Reflect.get(entry, 'value'), 0),
                ),
              );
              // Chromium alone knows what has moved; every engine tells of its navigation, so that there is an end.
              for (const type of ['layout-shift', 'navigation']) observer.observe({ type, buffered: true });
            })
          ),
      );
      assert.ok(moved < 0.05, `${fragment} at ${width} pixels: ${moved}`);
    }
  }
});

/** Whether the head ever told of a part whose picture was not there, and what of it was in sight before that. */
const watched = `
  const { dataset } = document.documentElement;
  const isThere = () => document.getElementById('instrument')?.hidden === false;
  new MutationObserver(() => {
    dataset.early = String(dataset.early === 'true' || !isThere());
  }).observe(document, { subtree: true, attributeFilter: ['data-open', 'data-lesson'] });
  dataset.controls = '';
  new MutationObserver(() => {
    if (isThere()) return;
    for (const id of ['preset', 'settings-button', 'keys-button'])
      if (document.getElementById(id)?.childNodes.length !== 0 && document.getElementById(id)?.checkVisibility()) dataset.controls += id;
  }).observe(document, { subtree: true, childList: true });
  dataset.over = '0';
  const measure = () => {
    if (isThere()) return;
    dataset.over = String(Math.max(Number(dataset.over), document.documentElement.scrollHeight - innerHeight));
    requestAnimationFrame(measure);
  };
  requestAnimationFrame(measure);`;

pageTest('the head changes together with the picture, so that nothing below it jumps', async (page) => {
  const site = await serve(undefined, { before: watched });
  try {
    // Lower than what is there to read, which nobody sees yet.
    await page.resize(1200, 600);
    for (const fragment of ['', '#training', '#lesson&step=3']) {
      await page.leave();
      await page.visit(site.address + fragment);
      await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
      const { early, controls, over } = await page.evaluate(() => ({ ...document.documentElement.dataset }));
      assert.equal(early, 'false', fragment);
      assert.equal(over, '0', `${fragment} is ${over} px too high while it opens`);
      assert.match(String(controls), /^(keys-button)*$/, fragment);
      assert.deepEqual([...(await page.problems()), ...site.problems], []);
    }
  } finally {
    await page.leave();
    await site.close();
  }
});

pageTest(
  'of the lab nothing is made before it is in sight, or an exercise hides some of it',
  async (page) => {
    const made = () => page.evaluate(() => document.querySelectorAll(':is(#drives, #gains) input').length);
    const openLab = async () => {
      await page.click('#page-lab');
      await page.until('it is there', () => document.getElementById('cost')?.checkVisibility());
    };
    for (const fragment of ['', '#park&v=1&lock=gains&task=Park.']) {
      await page.open(fragment);
      assert.equal(await made(), 0, fragment);
    }
    await openLab();
    const all = await made();
    assert.ok(all > 6, `${all} inputs`);
    await page.open('#park&v=1&hide=gains,drives,clock,run');
    await openLab();
    // What was taken out of the document before anybody saw it works when it is back.
    await page.evaluate(() => {
      location.hash = '#lab&v=1';
    });
    await page.until(
      'all of it is there',
      (count) => {
        const inputs = document.querySelectorAll(':is(#drives, #gains) input');
        return inputs.length === count && [...inputs].every((input) => input.checkVisibility());
      },
      all,
    );
    await page.click('#one-generation');
    assert.equal(await page.text('#generation'), '1');
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest(
  'before its words are there a figure has no head, and the page no heading of another language',
  async (page) => {
    let go = () => {};
    /** @type {Promise<void>} */
    let held = Promise.resolve();
    const site = await serve(undefined, {
      async send(name, content) {
        if (/(en|ko|page)-.*\.js$/.test(name)) await held;
        return content;
      },
    });
    const heading = () =>
      page.evaluate(() => {
        const element = document.querySelector('h1');
        return element?.checkVisibility() ? element.textContent : '';
      });
    try {
      for (const [address, shown] of /** @type {const} */ ([
        ['?embed#lab', ''],
        ['#lab&v=1&lang=ko', ''],
        ['#lab', 'Evolving a robot’s controller'],
      ])) {
        await page.leave();
        held = new Promise((resolve) => {
          go = resolve;
        });
        await page.visit(site.address + address);
        assert.equal(await heading(), shown, address);
        go();
        await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
        assert.deepEqual([...(await page.problems()), ...site.problems], []);
      }
    } finally {
      go();
      await page.leave();
      await site.close();
    }
  },
);

pageTest('a figure whose files are missing is a page to read', async (page) => {
  const site = await serve(undefined, {
    send: (name, content) => (/page-.*\.js$/.test(name) ? null : content),
  });
  try {
    await page.visit(`${site.address}?embed#lab`);
    await page.until('it is one', () => document.querySelector('h1')?.checkVisibility());
  } finally {
    await page.leave();
    await site.close();
  }
});
