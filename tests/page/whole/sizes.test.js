import assert from 'node:assert/strict';
import { pageNames } from '../../../www/parts/parts.js';
import { engineTest, Key, pageTest } from '../harness/browsers.js';
import { follow } from './surround.js';
import { views } from './views.js';

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

/** How far the page can be scrolled, to the right and down, once it has its new size. @param {Page} page */
const excess = (page) =>
  page.evaluate(async () => {
    for (let frame = 0; frame < 2; frame++) await new Promise((resolve) => requestAnimationFrame(resolve));
    const { scrollWidth, scrollHeight } = document.documentElement;
    return [scrollWidth - innerWidth, scrollHeight - innerHeight];
  });

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
      for (const [width, height] of sizes) {
        await page.resize(width, height);
        for (const part of pageNames) {
          await openPart(page, part);
          assert.deepEqual(await excess(page), [0, 0], `${part} at ${width} × ${height}`);
        }
      }
    },
  );

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
  const overlaps = await page.evaluate(() => {
    const boxes = ['head', 'controls', 'finding', 'table', 'pictures'].flatMap((name) => {
      const selector = name === 'head' ? '.training > .heading' : `.training-${name}`;
      const element = document.querySelector(selector);
      const inner = name === 'pictures' ? [...(element?.children ?? [])] : [];
      return [element, ...inner].map((one) => ({ name, box: one?.getBoundingClientRect() }));
    });
    return boxes.flatMap((a, i) =>
      boxes.slice(i + 1).flatMap((b) => {
        if (a.name === b.name || !a.box || !b.box) return [];
        const wide = Math.min(a.box.right, b.box.right) - Math.max(a.box.left, b.box.left);
        const high = Math.min(a.box.bottom, b.box.bottom) - Math.max(a.box.top, b.box.top);
        return wide > 1 && high > 1 ? `${a.name} on ${b.name}` : [];
      }),
    );
  });
  assert.deepEqual(overlaps, []);
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

pageTest('on a large screen the plane has the height that is there', async (page) => {
  for (const [width, height] of /** @type {const} */ ([
    [2560, 1440],
    [3840, 2160],
  ])) {
    await page.resize(width, height);
    for (const part of ['lab', 'generation', 'landscape']) {
      await page.open(`#${part}`);
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
      const names = await page.evaluate(() => {
        const { scrollWidth = 0, clientWidth = 0 } = document.getElementById('pages') ?? {};
        return scrollWidth - clientWidth;
      });
      assert.equal(names, 0, `the names of the parts at ${width}`);
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
  for (const [width, height] of tablets) {
    await page.resize(width, height);
    for (const part of ['lab', 'landscape', 'robustness']) {
      await page.open(`#${part}`);
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

/** Types what cannot be used, and waits until the page says so. @param {Page} page @param {string} id @param {string} letter @param {string} message */
async function refuse(page, id, letter, message) {
  await page.focus(`#${id}`);
  await page.evaluate((name) => /** @type {HTMLInputElement} */ (document.getElementById(name)).select(), id);
  await page.press(letter, Key.ENTER);
  await page.until(
    `${id} is refused`,
    (name, typed) => {
      const element = document.getElementById(name);
      return element?.checkVisibility() && element.innerText.includes(typed);
    },
    message,
    `“${letter}”`,
  );
}

pageTest('what is refused makes no part taller, and its message is in sight', async (page) => {
  await page.open('#lab');
  for (const [i, [width, height]] of sizes.entries()) {
    await page.resize(width, height);
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
      // Another one each time: the same again would be no change.
      await refuse(page, id, 'abcd'[i], message);
      assert.deepEqual(await excess(page), [0, 0], `${id} at ${width} × ${height}`);
      const covered = await page.evaluate((name) => {
        const element = /** @type {HTMLElement} */ (document.getElementById(name));
        const { left, right, top, bottom } = element.getBoundingClientRect();
        const found = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
        return found !== element && found?.id;
      }, message);
      assert.equal(covered, false, `${message} at ${width} × ${height}`);
    }
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

pageTest('for a finger every text button is as high as other controls', async (page) => {
  await page.resize(390, 844);
  for (const link of ['lab', 'lab&v=1&goal.x=1.5&lang=ko', 'generation&v=1&phase=ranking&generation=2']) {
    await page.open(`#${link}`);
    const heights = await page.evaluate(() => {
      /** The styles for a finger hold here too. @param {CSSRuleList} rules */
      const apply = (rules) => {
        for (const rule of rules) {
          if (rule instanceof CSSMediaRule && /pointer: coarse/.test(rule.conditionText))
            rule.media.mediaText = 'all';
          if (rule instanceof CSSGroupingRule) apply(rule.cssRules);
        }
      };
      for (const sheet of document.styleSheets) apply(sheet.cssRules);
      return Array.from(document.querySelectorAll('.link'), (button) => [
        button.id || button.textContent,
        button.checkVisibility() ? button.getBoundingClientRect().height : 44,
      ]);
    });
    assert.ok(heights.length > 0);
    for (const [name, height] of heights) assert.ok(Number(height) >= 44, `${name}: ${height} px in ${link}`);
  }
});
