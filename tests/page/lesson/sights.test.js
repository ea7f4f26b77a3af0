// What of the figure is in sight beside the words, or over them.
import assert from 'node:assert/strict';
import { steps } from '../../../www/lesson/steps.js';
import { en as english } from '../harness/words.js';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { follow } from '../whole/surround.js';

/** @type {any} */
const en = english.lesson;

/** What one sees of the figure, and where it stands. @param {import('../harness/browsers.js').Page} page */
const sight = (page) =>
  page.evaluate(async () => {
    await pageFrames.settled();
    const figure = /** @type {HTMLElement} */ (document.querySelector('.figure'));
    const { top, bottom } = figure.getBoundingClientRect();
    const shown = ['plane', 'bowl', 'pushes', 'stability-picture', 'gains', 'sights'].filter((id) => {
      const box = document.getElementById(id)?.getBoundingClientRect();
      return box && box.height > 20 && box.top >= top - 1 && box.bottom <= bottom + 1;
    });
    return { shown, isOnTop: top === 0, share: Math.round((10 * (bottom - top)) / innerHeight) };
  });

pageTest('where there is no room beside the words, what they speak of stays over them', async (page) => {
  await page.resize(800, 900);
  await page.open('#lesson&step=4');
  const atTheEnd = () =>
    page.evaluate(() => document.querySelector('.lesson-foot')?.scrollIntoView({ block: 'end' }));
  await atTheEnd();
  assert.deepEqual(await sight(page), { shown: ['bowl', 'sights'], isOnTop: true, share: 5 });
  for (const [name, shown] of /** @type {const} */ ([
    ['gains', ['plane', 'gains', 'sights']],
    ['part', ['stability-picture', 'sights']],
    ['robot', ['plane', 'sights']],
  ])) {
    await page.click(`#sights-${name}`);
    assert.deepEqual((await sight(page)).shown, shown, name);
  }
  await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('.step-on')).click());
  await page.until(
    'the next step, with what it speaks of',
    (title) =>
      document.getElementById('lesson-title')?.textContent === title &&
      /** @type {HTMLInputElement} */ (document.getElementById('sights-stage')).checked,
    en.titles.limits,
  );
  await page.resize(1280, 900);
  const { shown } = await sight(page);
  assert.ok(shown.includes('plane') && !shown.includes('sights'), shown.join());
});

pageTest(
  'on a laptop every plane of the lesson is 300 pixels high, and the figure fits its window',
  async (page) => {
    let planes = 0;
    for (const { name, stage } of steps) {
      await page.resize(1440, 900);
      await follow(page, `lesson&step=${name}`);
      const { bottom, plane, isStaged } = await page.until(
        'the figure is drawn',
        (title) => {
          if (document.getElementById('lesson-title')?.textContent !== title) return null;
          const heightOf = (/** @type {string} */ one) => {
            // Where it has no box of its own it is as high as what stands in it.
            const found = [...document.querySelectorAll(`${one}, ${one} *`)].find(
              (element) => element.checkVisibility() && element.clientHeight > 0,
            );
            return found?.clientHeight ?? 0;
          };
          const figure = document.querySelector('.figure')?.getBoundingClientRect();
          const part = document.querySelector('.readings > section:not([hidden])');
          const [robot, picture] = ['.plane', '#stage'].map(heightOf);
          return (
            (robot + picture > 0 || part?.checkVisibility()) &&
            figure && { bottom: figure.bottom, plane: robot, isStaged: picture > 0 }
          );
        },
        en.titles[name],
      );
      assert.ok(bottom <= 900, `${name} ends at ${bottom}`);
      assert.ok(plane === 0 || plane >= 300, `${name}: ${plane}`);
      if (plane > 0) planes += 1;
      assert.equal(isStaged, stage !== undefined && !stage.after, name);
      const slipped = await page.evaluate(() => {
        const top = () => document.querySelector('.figure')?.getBoundingClientRect().top ?? 0;
        const before = top();
        scrollTo(0, document.documentElement.scrollHeight);
        const after = top();
        scrollTo(0, 0);
        return before - after;
      });
      assert.ok(slipped < 1, `${name}: at the end of the words the figure slips ${slipped} px under the bar`);
      await page.resize(1366, 768);
      await page.until(`nothing of the figure of ${name} lies below a low window`, () => {
        const figure = document.querySelector('.figure');
        return document.querySelector('.prose') && figure && figure.scrollHeight <= figure.clientHeight + 1;
      });
      const apart = await page.evaluate(() => {
        const [table, seed] = ['#fitness-table', '#seed'].map((one) => document.querySelector(one));
        if (!table?.checkVisibility() || !seed) return 0;
        return table.getBoundingClientRect().bottom - seed.getBoundingClientRect().bottom;
      });
      assert.ok(Math.abs(apart) < 12, `${name}: the table is named ${apart} px under the generation`);
    }
    assert.ok(planes >= 8, `${planes} steps have a plane`);
  },
);

pageTest('on a telephone a generation is whole in its sight, phase by phase', async (page) => {
  // A telephone has no scroll bar beside its 390 pixels.
  const bar = await page.evaluate(() => {
    document.body.style.minHeight = '3000px';
    return innerWidth - document.documentElement.clientWidth;
  });
  await page.resize(390 + bar, 844);
  await page.open('#lesson&step=generation');
  await page.click('#sights-part');
  for (const phase of ['parents', 'mutation', 'drive', 'tournament', 'ranking', 'survivors']) {
    await page.click(`#generation-phases-${phase}`);
    const hidden = await page.evaluate(() => {
      const { scrollHeight, clientHeight, scrollWidth, clientWidth } = /** @type {HTMLElement} */ (
        document.querySelector('.readings')
      );
      return [scrollHeight - clientHeight, scrollWidth - clientWidth];
    });
    assert.ok(hidden[0] <= 4 && hidden[1] <= 0, `${phase}: ${hidden}`);
  }
});

pageTest(
  'Run is whole in sight under the map on a telephone, and under a generation on a laptop',
  async (page) => {
    await page.open('#lesson');
    for (const [width, height, step] of /** @type {const} */ ([
      [390, 844, 'landscape'],
      [1366, 768, 'generation'],
    ])) {
      await page.resize(width, height);
      await follow(page, `lesson&step=${step}`);
      const [run, edge] = await page.until('Run stands there', () => {
        const [button, figure] = ['#run', '.figure'].map((one) => document.querySelector(one));
        return button?.checkVisibility() && figure
          ? [button, figure].map((one) => one.getBoundingClientRect().bottom)
          : undefined;
      });
      assert.ok(run <= Math.min(edge, height), `${step}: ${run}, ${edge}`);
    }
  },
);

pageTest('on a telephone the lines under the map stand under each other, each in full', async (page) => {
  await page.resize(390, 844);
  await page.open('#lesson&step=landscape');
  const [lowest, readout] = await page.until('both are there', () => {
    const lines = ['lowest', 'readout'].map((name) => document.getElementById(`landscape-${name}`));
    return (
      lines.every((line) => line?.textContent?.trim()) &&
      lines.map((line) => {
        const { top = 0, bottom = 0 } = line?.getBoundingClientRect() ?? {};
        return { top, bottom, cut: (line?.scrollHeight ?? 0) - (line?.clientHeight ?? 0) };
      })
    );
  });
  assert.ok(lowest.top >= readout.bottom, `${lowest.top}, ${readout.bottom}`);
  // An index may hang out below.
  assert.ok(lowest.cut <= 4 && readout.cut <= 4, `${lowest.cut}, ${readout.cut}`);
});

pageTest('on a telephone each drive of a generation is as large as on a laptop', async (page) => {
  await page.resize(390, 844);
  await page.open('#lesson&step=generation');
  const { widths, cut } = await page.until('they are there', () => {
    const cells = [...document.querySelectorAll('.newborn li')].map((cell) => cell.getBoundingClientRect());
    const stage = document.querySelector('#stage')?.getBoundingClientRect();
    return cells.length === 20 && stage && stage.height > 0
      ? { widths: cells.map(({ width }) => width), cut: cells[19].bottom - stage.bottom }
      : undefined;
  });
  assert.ok(Math.min(...widths) >= 60, `${widths}`);
  assert.ok(cut <= 1, `${cut}`);
});

pageTest('on a telephone the figure turns to what a question, a try or a word opens', async (page) => {
  await page.resize(390, 844);
  const seen = () => page.evaluate(() => document.body.dataset.sight);
  let opened = '';
  for (const [step, press, sight] of /** @type {const} */ ([
    ['generation', '#quiz-luck .choice:first-child', 'part'],
    ['generation', '.prose a[href*="mutation"]', 'part'],
    ['generation', '[data-try="lucky"]', 'part'],
    ['limits', '[data-try="raised"]', 'part'],
    ['stability', '[data-try="track"]', 'robot'],
    ['law', '#quiz-beside .choice:first-child', 'robot'],
    ['law', '#quiz-ahead .choice:first-child', 'robot'],
    ...['onlyKx', 'onlyKt', 'onlyKy', 'all', 'stuck', 'shuffle'].map(
      (name) => /** @type {const} */ (['law', `[data-try="${name}"]`, 'robot']),
    ),
  ])) {
    if (step === opened) await page.click('#sights-stage');
    else await page.open(`#lesson&step=${step}`);
    opened = step;
    assert.equal(await seen(), 'stage', step);
    await page.evaluate((one) => /** @type {HTMLElement} */ (document.querySelector(one)).click(), press);
    assert.equal(await seen(), sight, `${step} ${press}`);
  }
  // Where the robot stands under the bars, both stay.
  await page.resize(600, 900);
  await page.open('#lesson&step=law');
  await page.click('[data-try="shuffle"]');
  assert.equal(await seen(), 'stage');
});

engineTest(
  'on a telephone the answer of a question comes into sight, as what was pressed stays',
  async (page) => {
    await page.resize(390, 844);
    await page.open('#lesson&step=error');
    await page.evaluate(() => {
      const last = /** @type {Element} */ (document.querySelector('.choice:last-child'));
      scrollBy(0, last.getBoundingClientRect().bottom - innerHeight + 4);
    });
    await page.click('#quiz-largest .choice:last-child');
    await page.until('the whole answer is over the lower edge, its choice under the figure', () => {
      const [figure, chosen, end] = ['.figure', '.chosen', '.quiz .link:not([hidden])'].map((one) =>
        document.querySelector(one)?.getBoundingClientRect(),
      );
      return figure && chosen && end && chosen.top >= figure.bottom && end.bottom <= innerHeight;
    });
  },
);

pageTest('on a telephone the bars of the law stand over what moves them', async (page) => {
  const inFigure = () =>
    page.evaluate(() => {
      const { bottom } = /** @type {HTMLElement} */ (
        document.querySelector('.figure')
      ).getBoundingClientRect();
      return ['#pushes tr:last-child', '#plane', '#scrub', '#slider-kx', '#slider-ktheta'].filter((one) => {
        const element = document.querySelector(`.figure ${one}`);
        return element?.checkVisibility() && element.getBoundingClientRect().bottom <= bottom;
      });
    });
  await page.open('#lesson&step=law');
  for (const [width, height, ...also] of /** @type {const} */ ([
    [390, 844, '#scrub'],
    [375, 667],
    [600, 900, '#plane', '#scrub'],
  ])) {
    await page.resize(width, height);
    assert.deepEqual(
      await inFigure(),
      ['#pushes tr:last-child', ...also, '#slider-kx', '#slider-ktheta'],
      `${width}`,
    );
  }
  const before = await page.evaluate(() => document.querySelector('.push-asked .push-value')?.textContent);
  await page.focus('#slider-kx');
  await page.press(Key.ARROW_RIGHT);
  await page.until(
    'the bars follow',
    (was) => document.querySelector('.push-asked .push-value')?.textContent !== was,
    before,
  );
});

pageTest(
  'what the words ask for is in the sight with which a step opens, and a tab that is loaded again is where it was',
  async (page) => {
    await page.resize(600, 900);
    await page.open('#lesson');
    const isThere = (/** @type {string} */ selector) =>
      page.evaluate((one) => {
        const element = document.querySelector(one);
        const figure = /** @type {HTMLElement} */ (document.querySelector('.figure')).getBoundingClientRect();
        const box = element?.checkVisibility() && element.getBoundingClientRect();
        return Boolean(box && box.top >= figure.top && box.bottom <= figure.bottom);
      }, selector);
    // To play the drive beside the bowl; the sliders with the 32 robots; what the bar under J is made of.
    for (const [step, ...wanted] of [
      ['stability', '#bowl', '#play'],
      ['limits', '#play'],
      ['duel', '#swarm-parked', '#slider-kx'],
      ['drive', '#cost-parts', '#slider-kx'],
    ]) {
      await follow(page, `lesson&step=${step}`);
      for (const one of wanted) assert.equal(await isThere(one), true, `${step}: ${one}`);
    }
    const top = () => page.evaluate(() => Math.round(scrollY));
    await page.evaluate(() => scrollTo(0, 700));
    assert.equal(await top(), 700);
    await page.driver.navigate().refresh();
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.until('it is where it was', () => Math.round(scrollY) === 700);
    // Another step begins at its beginning.
    await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('.step-on')).click());
    await page.until('the next step', () => scrollY === 0);
    assert.deepEqual(await page.problems(), []);
  },
);
