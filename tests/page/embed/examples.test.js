// The examples, as they stand in examples/, opened in a browser.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { relative } from 'node:path';
import { areBuilt, book } from '../../../.tasks/examples.mjs';
import { top } from '../../../.tasks/run.mjs';
import { frameText } from '../../../www/embed/frame-line.js';
import { Key, pageTest } from '../harness/browsers.js';
import { evolve, experiment, historyOf, shown, shownGains } from '../harness/core.js';
import { serveHost, within } from '../harness/host.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const seed7 = experiment({ evolution: { seed: 7 } });

/** Opens a file of the project. @param {Page} page @param {string} path @param {() => Promise<unknown>} body */
async function inExample(page, path, body) {
  const host = await serveHost('');
  try {
    await page.visit(host.address + path);
    await body();
    const strangers = await page.evaluate(() =>
      performance
        .getEntriesByType('resource')
        .map(({ name }) => name)
        .filter((name) => new URL(name).origin !== location.origin && !name.startsWith('data:')),
    );
    assert.deepEqual(strangers, []);
  } finally {
    await page.leave();
    await host.close();
  }
}

/** In a frame: waits until it is the figure of a link. @param {Page} page @param {string} link */
const isFigureOf = (page, link) =>
  page.until(
    `the figure is that of ${link}`,
    (wanted) =>
      /** @type {HTMLAnchorElement | null} */ (document.getElementById('embed-full'))?.hash === `#${wanted}`,
    link,
  );

const landscape = 'landscape&v=1&seed=7&generation=5';

test('the frame of the example is as Share writes it', async () => {
  const text = frameText({
    address: `../../dist/index.html?embed#${landscape}`,
    title: 'Evolving a robot’s controller: Landscape',
    width: 640,
    height: 420,
  });
  assert.ok(
    (await readFile(new URL('../../../examples/plain/frame.html', import.meta.url), 'utf8')).includes(text),
  );
  const inBook = text.replace('../../dist/', 'ep/');
  assert.ok(
    (await readFile(new URL('../../../examples/book/intro.md', import.meta.url), 'utf8')).includes(inBook),
  );
});

pageTest('examples/plain/frame.html shows a figure', (page) =>
  inExample(page, 'examples/plain/frame.html', () => within(page, 0, () => isFigureOf(page, landscape))),
);

pageTest('examples/plain/element.html asks its figure and says what it hears', (page) =>
  inExample(page, 'examples/plain/element.html', async () => {
    /** @param {string} button @param {import('../harness/core.js').Experiment} from @param {number} generation */
    const press = async (button, from, generation) => {
      const { best } = historyOf(from, generation)[generation];
      await page.click(button);
      const text = `Generation ${generation}: J = ${shown(best.cost)} with ${shownGains(best.gains).join(', ')}`;
      await page.until(text, (wanted) => document.getElementById('best')?.innerText === wanted, text);
    };
    // What is below the figure moves once more when the figure has said how high it wants to be.
    await page.until(
      'the figure has its height',
      () => document.querySelector('ep-locomotion')?.shadowRoot?.querySelector('iframe')?.style.height,
    );
    // What stands between its tags is for who has no element.
    assert.equal(
      await page.evaluate(() => document.querySelector('ep-locomotion a')?.checkVisibility()),
      false,
    );
    await press('#ten', seed7, 10);
    const goal = { x: 3, y: 1, theta: 0 };
    await press('#far', experiment({ goal, evolution: { seed: 7 } }), 0);
  }),
);

pageTest('examples/plain/messages.html lists every generation that it hears', (page) =>
  inExample(page, 'examples/plain/messages.html', async () => {
    const rows = (/** @type {number} */ count) =>
      page.until(
        `${count} rows`,
        (wanted) => {
          const { rows } = /** @type {HTMLTableSectionElement} */ (document.getElementById('generations'));
          if (rows.length === wanted)
            return [...rows].map((row) => [...row.cells].map((cell) => cell.innerText));
        },
        count,
      );
    await rows(1);
    await page.click('#ten');
    assert.deepEqual(
      await rows(11),
      historyOf(seed7, 10).map(({ generation, evaluations, best }) =>
        [generation, evaluations, best.cost].map(String),
      ),
    );
  }),
);

pageTest('on slides the arrow keys are the deck’s until a figure is used', (page) =>
  inExample(page, 'examples/slides/index.html', async () => {
    /** Where the deck is, and how far the figure. */
    const stand = () =>
      page.evaluate(() => {
        const slides = [...document.querySelectorAll('.slides > section')];
        return {
          slide: slides.findIndex((one) => one.classList.contains('present')),
          fragments: document.querySelectorAll('.fragment.visible').length,
        };
      });
    const generation = (/** @type {number} */ wanted) =>
      page.until(
        `generation ${wanted}`,
        (number) => Reflect.get(document.getElementById('figure') ?? {}, 'state')?.generation === number,
        wanted,
      );
    // At the size of the slides nothing is scaled; one driver presses beside what is.
    await page.resize(1120, 720);
    await page.until('the deck is ready', () => document.querySelector('.reveal.ready'));
    await page.press(Key.ARROW_RIGHT);
    await generation(0);
    await page.press(Key.ARROW_RIGHT);
    await generation(10);
    assert.deepEqual(await stand(), { slide: 1, fragments: 1 });

    const frame = await page.evaluate(() => {
      const found = document.getElementById('figure')?.shadowRoot?.querySelector('iframe');
      return /** @type {any} */ (found);
    });
    await page.driver.switchTo().frame(frame);
    await page.click('#one-generation');
    await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT);
    await page.until('generation 11', () => document.getElementById('generation')?.innerText === '11');
    await page.driver.switchTo().defaultContent();
    assert.deepEqual(await stand(), { slide: 1, fragments: 1 });

    await page.click('section.present h3');
    await page.press(Key.ARROW_RIGHT);
    await generation(20);
    // Back, and forward again.
    await page.press(Key.ARROW_LEFT);
    await generation(10);
    await page.press(Key.ARROW_RIGHT);
    await generation(20);
    await page.press(Key.ARROW_RIGHT);
    assert.deepEqual(await stand(), { slide: 2, fragments: 2 });
  }),
);

pageTest('a slide that is entered from behind has its figure at its last step', (page) =>
  inExample(page, 'examples/slides/index.html#/2', async () => {
    await page.until('the deck is ready', () => document.querySelector('.reveal.ready'));
    await page.press(Key.ARROW_LEFT);
    await page.until(
      'generation 20',
      () => Reflect.get(document.getElementById('figure') ?? {}, 'state')?.generation === 20,
    );
  }),
);

pageTest('a PDF of the slides has a page for each step of the figure', (page) =>
  inExample(page, 'examples/slides/index.html?print-pdf', async () => {
    await page.until('they stand at 0, 10 and 20', () => {
      const all = [...document.querySelectorAll('#figure')];
      return all.map((one) => Reflect.get(one, 'state')?.generation).join() === '0,10,20';
    });
  }),
);

if (areBuilt())
  pageTest('the book of examples/book shows its figures', (page) =>
    inExample(page, relative(top, `${book}/intro.html`).replaceAll('\\', '/'), async () => {
      await within(page, 0, () => isFigureOf(page, landscape));
      const hash = await page.until(
        'the element is ready',
        () => Reflect.get(document.querySelector('ep-locomotion') ?? {}, 'state')?.hash,
      );
      assert.equal(hash, evolve(seed7, 3).hash);
    }),
  );
else
  test('the book of examples/book shows its figures', {
    skip: 'npm test builds it where Python is',
  }, () => {});
