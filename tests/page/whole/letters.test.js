// Where the reader has larger letters, or more space between them.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { cluttered } from './cluttered.js';
import { keepCut, takeCut } from './cut.js';
import { excess, follow, overlapping } from './surround.js';
import { views } from './views.js';

pageTest('with letters twice as large nothing leads out of a telephone’s width', async (page) => {
  await page.resize(390, 844);
  await page.open();
  await page.evaluate(() => {
    document.documentElement.style.fontSize = '200%';
  });
  for (const view of views) {
    await follow(page, view);
    const [aside] = await excess(page);
    assert.ok(aside <= 0, `${view}: ${aside}`);
  }
});

pageTest('with letters twice as large nothing lies on anything else beside the plane', async (page) => {
  await page.resize(1280, 800);
  await page.open('#training');
  await page.evaluate(() => {
    document.documentElement.style.fontSize = '200%';
  });
  const [aside] = await excess(page);
  assert.ok(aside <= 0, `Training: ${aside} px`);
  const { overlaps, seen } = await page.evaluate(() => {
    const boxes = ['head', 'controls', 'finding', 'table', 'pictures'].flatMap((name) => {
      const selector = name === 'head' ? '.training > .heading' : `.training-${name}`;
      const element = document.querySelector(selector);
      const inner = name === 'pictures' ? [...(element?.children ?? [])] : [];
      return [element, ...inner].map((one) => ({ name, box: one?.getBoundingClientRect() }));
    });
    const lying = boxes.flatMap((a, i) =>
      boxes.slice(i + 1).flatMap((b) => {
        if (a.name === b.name || !a.box || !b.box) return [];
        const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
        const high = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
        return wide > 1 && high > 1 ? `${a.name} on ${b.name}` : [];
      }),
    );
    return {
      overlaps: lying,
      seen: boxes.filter(({ box }) => box && box.height > 0).map(({ name }) => name),
    };
  });
  assert.deepEqual(overlaps, []);
  assert.deepEqual([...new Set(seen)], ['head', 'controls', 'finding', 'table', 'pictures']);
});

pageTest('with letters twice as large no choice of the contest cuts its words', async (page) => {
  await page.resize(1280, 800);
  await page.open('#luck&luck=contest');
  const cut = await page.evaluate(() => {
    document.documentElement.style.fontSize = '200%';
    const selects = [...document.querySelectorAll('.contestants select')];
    return selects.map((one) => one.clientHeight / Number.parseFloat(getComputedStyle(one).fontSize));
  });
  assert.ok(cut.length > 0);
  for (const lines of cut) assert.ok(lines >= 1.15, `${lines} of a letter’s height`);
});

/** Flaws in these views. @param {import('../harness/browsers.js').Page} page @param {string[]} links @param {() => string[]} look */
async function flawsIn(page, links, look) {
  /** @type {string[]} */
  const found = [];
  for (const link of links) {
    await follow(page, link);
    for (const flaw of [...(await page.evaluate(cluttered)), ...(await page.evaluate(look))])
      found.push(`${link}: ${flaw}`);
  }
  return found.join('\n');
}

pageTest(
  'where no letter is smaller than 20 px no text lies on another or on a slider',
  async (page) => {
    if (page.engine !== 'chromium') return;
    await page.resize(1280, 1024);
    await page.open();
    const links = ['training', 'generation&generation=2', 'lesson&step=4', 'robustness'];
    const found = await flawsIn(page, links, () =>
      ['.clock', '.training-gains', '.training-table th'].flatMap((selector) =>
        [...document.querySelectorAll(selector)]
          .filter((one) => one.checkVisibility() && one.scrollWidth > one.clientWidth + 1)
          .map((one) => `“${one.textContent?.trim()}” needs ${one.scrollWidth} px of ${one.clientWidth}`),
      ),
    );
    assert.equal(found, '');
    assert.deepEqual(await page.evaluate(overlapping, '.survey-ring, .robustness > .readout'), []);
  },
  { least: 20 },
);

pageTest(
  'with letters twice as large the symbols of a picture and the ways of the lesson stay in place',
  async (page) => {
    if (page.engine !== 'chromium') return;
    await page.resize(1280, 1024);
    await page.open();
    await page.evaluate(() => {
      document.documentElement.style.fontSize = '200%';
    });
    const found = await flawsIn(page, ['generation&v=1&generation=2', 'lesson&step=4'], () => {
      const boxOf = (/** @type {Node} */ one) => {
        const range = document.createRange();
        range.selectNodeContents(one);
        return range.getBoundingClientRect();
      };
      const list = document.querySelector('#lesson-step');
      const [above, symbol] = ['.limit + text', '.symbol'].map((one) =>
        document.querySelector(`.generation-picture ${one}`),
      );
      if (!list && !(above && symbol)) return ['nothing to look at'];
      const isLying = above && symbol && boxOf(above).bottom > boxOf(symbol).top;
      const lying = isLying ? ['the symbol lies on what stands above it'] : [];
      const middle = (/** @type {DOMRect} */ { top, bottom }) => (top + bottom) / 2;
      const ways = list ? [...document.querySelectorAll('.lesson-way[href]')] : [];
      const aside = ways.map(
        (one) => middle(boxOf(one)) - middle(/** @type {Element} */ (list).getBoundingClientRect()),
      );
      return [
        ...lying,
        ...aside.filter((by) => Math.abs(by) > 4).map((by) => `a way stands ${by} px lower than the list`),
      ];
    });
    assert.equal(found, '');
  },
);

/** As far apart as WCAG 1.4.12 says. @param {import('../harness/browsers.js').Page} page */
const moveApart = (page) =>
  page.evaluate(() => {
    // The page takes no style that is written into it.
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(`* { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important; }
      p { margin-bottom: 2em !important; }`);
    document.adoptedStyleSheets.push(sheet);
  });

pageTest('with more space between letters, words, and lines no text of a chart is cut', async (page) => {
  if (page.engine !== 'chromium') return;
  await page.resize(1280, 1024);
  await page.open();
  await moveApart(page);
  await page.evaluate(keepCut);
  const links = ['lab&v=1', 'curves&v=1', 'luck&luck=contest', 'generation&v=1&generation=2'];
  assert.equal(await flawsIn(page, links, takeCut), '');
});

pageTest('nor does one of the lesson lie on the clock, or take the room of its bells', async (page) => {
  if (page.engine !== 'chromium') return;
  await page.resize(1280, 900);
  await page.open();
  await moveApart(page);
  assert.equal(await flawsIn(page, ['lesson&step=law'], () => []), '');
  assert.deepEqual(await page.evaluate(overlapping, '.clock, .push-strip > p'), []);
  const found = await flawsIn(page, ['lesson&step=sigma'], () =>
    [...document.querySelectorAll('.lineage-columns svg')]
      .filter((one) => one.clientHeight < 100)
      .map((one) => `bells in ${one.clientHeight} px`),
  );
  assert.equal(found, '');
});
