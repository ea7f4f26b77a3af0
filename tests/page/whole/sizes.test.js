import assert from 'node:assert/strict';
import { pageNames } from '../../../www/parts/parts.js';
import { engineTest, Key, pageTest } from '../harness/browsers.js';
import { excess } from './surround.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Laptops and projectors. */
const sizes = /** @type {const} */ ([
  [1440, 900],
  [1366, 768],
  [1280, 720],
  [1024, 768],
]);

/** Held upright. */
const tablets = /** @type {const} */ ([
  [820, 1180],
  [768, 1024],
]);

/** One size after the other, beginning with the one that the page has, if it is among them. @param {Page} page @param {(where: string) => Promise<void>} look */
async function atEachSize(page, look) {
  const own = await page.evaluate(() => innerWidth);
  for (const [width, height] of own === sizes[0][0] ? sizes : [...sizes].reverse()) {
    await page.resize(width, height);
    await look(`${width} × ${height}`);
  }
}

/** @param {Page} page @param {string} part */
async function openPart(page, part) {
  await page.click(`#page-${part}`);
  await page.until(`${part} is open`, (name) => document.body.dataset.open === name, part);
}

for (const link of ['lab', 'lab&v=1&lang=ko', 'lab&v=1&preset=acceleration-limits&generation=100'])
  (link === 'lab' ? engineTest : pageTest)(
    `no part needs to be scrolled on a laptop or a projector: ${link}`,
    async (page) => {
      await page.open(`#${link}`);
      for (const part of pageNames) {
        await openPart(page, part);
        await atEachSize(page, async (where) =>
          assert.deepEqual(await excess(page), [0, 0], `${part} at ${where}`),
        );
      }
    },
  );

pageTest('on a large screen the plane has the height that is there', async (page) => {
  for (const part of ['lab', 'generation', 'landscape']) {
    await page.open(`#${part}`);
    for (const [width, height] of /** @type {const} */ ([
      [2560, 1440],
      [3840, 2160],
    ])) {
      await page.resize(width, height);
      assert.deepEqual(await excess(page), [0, 0], `${part} at ${width} × ${height}`);
      const below = await page.evaluate(
        () => innerHeight - Number(document.getElementById('plane')?.getBoundingClientRect().bottom),
      );
      assert.ok(below < 0.15 * height, `${part} at ${width} × ${height}: ${below} px below the plane`);
    }
  }
});

pageTest('on a tablet held upright all of a part is in sight at once', async (page) => {
  for (const [width, height] of tablets) {
    await page.resize(width, height);
    for (const [part, ...ids] of [
      ['lab', 'plane', 'cost', 'curve', 'run', 'gains'],
      ['landscape', 'plane', 'cost', 'run', 'drives', 'landscape-map'],
      ['robustness', 'plane', 'drives', 'robustness-map', 'robustness-rose'],
    ]) {
      await openPart(page, part);
      const [aside] = await excess(page);
      assert.ok(aside <= 0, `${part} at ${width}: ${aside} px`);
      const beyond = await page.evaluate(
        (...names) =>
          names.flatMap((id) => {
            const { bottom } = /** @type {HTMLElement} */ (
              document.getElementById(id)
            ).getBoundingClientRect();
            return bottom > innerHeight ? `${id}: ${bottom}` : [];
          }),
        ...ids,
      );
      assert.deepEqual(beyond, [], `${part} at ${width} × ${height}`);
    }
  }
});

pageTest('on a tablet held upright what is pressed stays under the finger, whoever drives', async (page) => {
  const tops = () =>
    page.evaluate(() =>
      ['drives', 'run', 'landscape-map', 'robustness-map'].flatMap((id) => {
        const element = document.getElementById(id);
        return element?.checkVisibility() ? [`${id} ${Math.round(element.getBoundingClientRect().top)}`] : [];
      }),
    );
  for (const part of ['lab', 'landscape', 'robustness']) {
    await page.open(`#${part}`);
    for (const [width, height] of tablets) {
      await page.resize(width, height);
      await excess(page);
      const before = await tops();
      assert.ok(before.length >= 2, `${before}`);
      for (const driver of ['paper-ep', 'hand', 'paper-arbitrary', 'evolved']) {
        await page.click(`#drives-${driver}`);
        await excess(page);
        assert.deepEqual(await tops(), before, `${part} at ${width}, ${driver}`);
      }
    }
  }
});

pageTest('the links to the parts and the plane stay where they are from part to part', async (page) => {
  for (const link of ['#lab', '#lab&v=1&lang=ko']) {
    await page.open(link);
    await page.resize(1280, 720);
    const tops = [];
    for (const part of pageNames.filter((name) => name !== 'park')) {
      await openPart(page, part);
      await excess(page);
      tops.push(
        await page.evaluate(() =>
          ['pages', 'plane'].map((id) =>
            Math.round(document.getElementById(id)?.getBoundingClientRect().top ?? 0),
          ),
        ),
      );
    }
    for (const [i, top] of tops.entries()) assert.deepEqual(top, tops[0], `${link}: part ${i}`);
  }
});

pageTest('where the links to the parts go on out of sight, their row fades there', async (page) => {
  await page.open('#lab');
  const at = (/** @type {string} */ what, /** @type {boolean} */ before, /** @type {boolean} */ after) =>
    page.until(
      what,
      (isBefore, isAfter) => {
        const { classList } = /** @type {HTMLElement} */ (document.getElementById('pages'));
        return classList.contains('more-before') === isBefore && classList.contains('more-after') === isAfter;
      },
      before,
      after,
    );
  await at('all in sight at first', false, false);
  await page.resize(500, 800);
  await at('more after the first', false, true);
  await page.click('#page-landscape');
  await at('more on both sides', true, true);
  await page.click('#page-luck');
  await at('more before the last', true, false);
  await page.resize(1440, 900);
  await at('all in sight again', false, false);
});

/** Types what cannot be used, and waits until the page says so. @param {Page} page @param {string} id @param {string} message */
async function refuse(page, id, message) {
  await page.focus(`#${id}`);
  await page.evaluate((name) => /** @type {HTMLInputElement} */ (document.getElementById(name)).select(), id);
  await page.press('a', Key.ENTER);
  await page.until(
    `${id} is refused`,
    (name) => {
      const element = document.getElementById(name);
      return element?.checkVisibility() && element.innerText.includes('“a”');
    },
    message,
  );
}

pageTest('what is refused makes no part taller, and its message is in sight', async (page) => {
  await page.open('#lab');
  for (const [part, id, message, choice = ''] of /** @type {const} */ ([
    ['lab', 'gain-kx', 'gain-kx-error'],
    ['lab', 'gain-ktheta', 'gain-ktheta-error'],
    ['lab', 'until-value', 'until-error', 'until'],
    ['landscape', 'landscape-third', 'landscape-third-error'],
    ['disturbance', 'gain-epsilon1', 'gain-epsilon1-error', 'disturbance-kind-random'],
    ['disturbance', 'gain-epsilon2', 'gain-epsilon2-error'],
  ])) {
    await openPart(page, part);
    if (choice === 'until') await untilGeneration(page);
    else if (choice) await page.click(`#${choice}`);
    await refuse(page, id, message);
    await atEachSize(page, async (where) => {
      assert.deepEqual(await excess(page), [0, 0], `${id} at ${where}`);
      const covered = await page.evaluate((name) => {
        const element = /** @type {HTMLElement} */ (document.getElementById(name));
        const { left, right, top, bottom } = element.getBoundingClientRect();
        const found = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        return found !== element && (found?.id ?? 'nothing');
      }, message);
      assert.equal(covered, false, `${message} at ${where}`);
    });
  }
});

/** Evolution is to pause at a generation, whose field is there then. @param {Page} page */
async function untilGeneration(page) {
  await page.evaluate(() => {
    const until = /** @type {HTMLSelectElement} */ (document.getElementById('until'));
    until.value = 'generation';
    until.dispatchEvent(new Event('change'));
  });
  await page.until('its field', () => document.getElementById('until-value')?.checkVisibility());
}

pageTest(
  'for a finger text buttons are high enough, choices large enough, and no word lies on a knob',
  async (page) => {
    await page.resize(390, 844);
    for (const link of [
      'lab',
      'lab&v=1&goal.x=1.5&lang=ko',
      'generation&v=1&phase=ranking&generation=2',
      // Where the knob of the start lies is the way back to the paper's.
      'lab&v=1&start=1.5,0.5,0deg',
    ]) {
      await page.open(`#${link}`);
      const { sizes, hasKeys, covered } = await page.evaluate(() => {
        /** The styles for a finger hold here too. @param {CSSRuleList} rules */
        const apply = (rules) => {
          for (const rule of rules) {
            if (rule instanceof CSSMediaRule && /pointer: coarse/.test(rule.conditionText))
              rule.media.mediaText = 'all';
            if (rule instanceof CSSGroupingRule) apply(rule.cssRules);
          }
        };
        for (const sheet of document.styleSheets) apply(sheet.cssRules);
        const shown = [...document.querySelectorAll('.link, .segmented.small input')].filter((one) =>
          one.checkVisibility(),
        );
        return {
          sizes: shown.map((one) => {
            const { width, height } = one.getBoundingClientRect();
            const least = one.matches('input') ? Math.min(width, height) : height;
            return /** @type {const} */ ([one.id || one.textContent || one.outerHTML, least]);
          }),
          hasKeys: document.getElementById('keys-button')?.checkVisibility(),
          covered: [...document.querySelectorAll('#plane .handle')].flatMap((handle) => {
            const { left, right, top, bottom } = handle.getBoundingClientRect();
            const found = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
            return found?.closest('.handle') ? [] : [`${handle.id} under ${found?.id}`];
          }),
        };
      });
      assert.deepEqual(covered, [], link);
      assert.ok(sizes.length > 0);
      for (const [name, size] of sizes) assert.ok(size >= 44, `${name}: ${size} px in ${link}`);
      assert.equal(hasKeys, false, 'a telephone has no keys');
    }
  },
);

pageTest('other parts would find their names at the head: what has no room there scrolls', async (page) => {
  for (const [width, height] of /** @type {const} */ ([
    [1280, 720],
    [768, 1024],
  ])) {
    await page.resize(width, height);
    await page.open('#luck');
    const { grown, isSeen, isAside } = await page.evaluate(() => {
      const nav = /** @type {HTMLElement} */ (document.getElementById('pages'));
      const high = () => document.querySelector('.masthead')?.clientHeight ?? 0;
      const before = high();
      for (let i = 0; i < 4; i += 1) {
        const another = /** @type {HTMLElement} */ (nav.lastElementChild?.cloneNode());
        another.textContent = 'Sensitivity';
        nav.append(another);
      }
      nav.scrollLeft = nav.scrollWidth;
      const { right } = /** @type {Element} */ (nav.lastElementChild).getBoundingClientRect();
      const { scrollWidth, clientWidth } = document.documentElement;
      return { grown: high() - before, isSeen: right <= innerWidth, isAside: scrollWidth > clientWidth };
    });
    assert.ok(grown <= 24, `the head is ${grown} px higher at ${width} px`);
    assert.deepEqual({ isSeen, isAside }, { isSeen: true, isAside: false }, `${width} px`);
  }
});
