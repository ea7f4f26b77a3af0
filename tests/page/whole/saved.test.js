// A copy of the page that a browser has saved with all that stands in it says what it is, and does not run over it.
import assert from 'node:assert/strict';
import { engineTest, pageTest } from '../harness/browsers.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Under which the one file runs. */
const policy = {
  'script-src': "'self' 'unsafe-inline' 'wasm-unsafe-eval'",
  'style-src': "'self' 'unsafe-inline'",
};

/** What the saved document shows, in the place of the file. @param {Page} page @param {string} file @param {string} saved @param {boolean} hasScripts */
async function copyOf(page, file, saved, hasScripts) {
  const site = await serve(undefined, {
    policy,
    send: (name, content) =>
      name === file ? Buffer.from(saved) : !hasScripts && /\.js$/.test(name) ? null : content,
  });
  try {
    await page.visit(`${site.address}${file}#lab&v=1&seed=7&lang=ko`);
    await page.until('all is there', () => document.readyState === 'complete');
    const seen = await page.evaluate(async () => {
      // Longer than the page takes to begin, if it did.
      for (let i = 0; i < 60; i += 1) await new Promise(requestAnimationFrame);
      const messages = [
        .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('.message')),
      ].filter((one) => one.checkVisibility({ visibilityProperty: true }));
      return {
        said: messages.map((one) => one.innerText),
        links: messages.flatMap((one) => [...one.querySelectorAll('a')].map(({ href }) => href)),
        head: document.querySelector('h1')?.innerText,
        pages: document.querySelectorAll('#pages a').length,
        inputs: document.querySelectorAll('#gains input').length,
      };
    });
    // What is not there without scripts is no problem of the page.
    return { ...seen, problems: hasScripts ? await page.problems() : [] };
  } finally {
    await page.leave();
    await site.close();
  }
}

engineTest('a copy that a browser has saved says so, with its scripts and without', async (page) => {
  const site = await serve(undefined, { policy });
  try {
    for (const [file, lang, said] of /** @type {const} */ ([
      ['index.html', 'en', /^A browser saved this copy: .*Evolving a robot’s controller$/],
      ['ep-locomotion.html', 'ko', /^브라우저가 저장한 사본이라 .*[가-힣]$/],
    ])) {
      await page.leave();
      await page.visit(`${site.address}${file}#lab&v=1&seed=7&lang=${lang}`);
      await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
      await page.click('#one-generation');
      await page.until('the address says so', () => location.hash.includes('generation=1'));
      const open = await page.evaluate(() => ({
        address: location.href,
        saved: `<!doctype html>${document.documentElement.outerHTML}`,
        isSeen: /** @type {HTMLElement} */ (document.querySelector('#copy p')).checkVisibility(),
        height: /** @type {HTMLElement} */ (document.getElementById('copy')).offsetHeight,
        head: document.querySelector('h1')?.innerText,
        pages: document.querySelectorAll('#pages a').length,
        inputs: document.querySelectorAll('#gains input').length,
      }));
      assert.deepEqual([open.isSeen, open.height], [false, 0], 'it is seen in the page itself');
      await page.leave();
      for (const hasScripts of [true, false]) {
        // The server adds its own again.
        const saved = open.saved.replace(/<script src="\/collector.*?<\/script>/, '');
        const copy = await copyOf(page, file, saved, hasScripts);
        assert.equal(copy.said.length, 1, copy.said.join('\n'));
        assert.match(copy.said[0], said);
        assert.deepEqual([copy.links, copy.problems], [[open.address], []]);
        assert.deepEqual([copy.pages, copy.inputs], [open.pages, open.inputs], `${file} runs doubled`);
        assert.equal(copy.head, open.head);
      }
    }
  } finally {
    await site.close();
  }
});

pageTest('its link leads to what is open, and is called so, also after Back', async (page) => {
  const isOf = (/** @type {string} */ part) =>
    page.until(
      part,
      (name) => {
        const link = /** @type {HTMLAnchorElement} */ (document.querySelector('#copy a'));
        const isThere = document.body.dataset.open === name && location.hash.startsWith(`#${name}`);
        return isThere && link.href === location.href && link.textContent === document.title;
      },
      part,
    );
  await page.open('#curves');
  await isOf('curves');
  await page.click('#page-lab');
  await isOf('lab');
  await page.evaluate(() => history.back());
  await isOf('curves');
});
