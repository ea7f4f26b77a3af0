// The contest on the page: its table is what the core's trials say; it is cancelled, linked, and refused in a line.
import assert from 'node:assert/strict';
import { contestCsv, standingsOf } from '../../../www/parts/luck/contest-summary.js';
import { verdictText } from '../../../www/parts/luck/words/contest-en.js';
import { Key, pageTest } from '../harness/browsers.js';
import { saved } from '../harness/saved.js';
import { holdWorkers } from '../harness/workers.js';
import { link, openContest, readTable, runContest, withoutVerdict } from './contest-page.js';
import { expectedTable, small } from './contests.js';

pageTest(
  'the table of the contest is what the core’s trials say, and so is the CSV of all runs',
  async (page) => {
    await openContest(page, link);
    await runContest(page);
    const table = await readTable(page);
    assert.deepEqual(withoutVerdict(table), expectedTable(small, null));
    for (const [i, { verdict }] of standingsOf(small).lines.entries())
      if (verdict) assert.equal(table[i].verdict, verdictText(verdict, small.lines[i].name));
    assert.deepEqual(await page.obstacles(), []);
    assert.equal(await saved(page, '#contest-csv'), contestCsv(small));
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('a contestant that cannot run says so in its line, and the others run', async (page) => {
  await openContest(page, `${link}&population=3&contestants=de,random`);
  await runContest(page);
  const [lab, de, random] = await readTable(page);
  assert.match(de.verdict, /^Population must be 4 or more/);
  assert.match(lab.cells[0], /of 15/);
  assert.match(random.cells[0], /of 15/);
});

pageTest('what would take too long is refused before it starts', async (page) => {
  await openContest(page, '#luck&v=1&luck=contest&seeds=101&budget=20000&horizon=30&sampleTime=0.001');
  await page.click('#contest-run');
  const status = await page.until('why', () => document.getElementById('contest-status')?.textContent);
  assert.match(status, /^One run of 20.000 drives takes too long here; 13.333 would be the most/);
  assert.match(await page.text('#contest-run'), /^Run 4/);
  assert.equal(await page.evaluate(() => document.getElementById('contest-table')), null);
  assert.equal(await page.evaluate(() => document.getElementById('contest-csv')?.hidden), true);
  assert.deepEqual(await page.problems(), []);
});

pageTest('cancel keeps what was done and says how much', async (page) => {
  await openContest(page, '#luck&v=1&luck=contest&seeds=101&budget=20000&contestants=none');
  await holdWorkers(page, 2);
  await page.click('#contest-run');
  await page.until(
    'some have run',
    () => (document.querySelector('#contest-table tbody td')?.textContent ?? '') !== '',
  );
  await page.click('#contest-run');
  await page.until('it is cancelled', () => document.getElementById('contest-status')?.textContent !== '');
  const status = await page.text('#contest-status');
  const done = Number(/after (\d+) of 101 runs/.exec(status)?.[1]);
  assert.ok(done >= 5 && done < 101, status);
  const [lab] = await readTable(page);
  assert.match(lab.cells[0], new RegExp(`of ${done}$`));
  assert.deepEqual(await page.problems(), []);
});

pageTest(
  'a target that is no number is refused, the one before stays, and the usual one comes back',
  async (page) => {
    await openContest(page, `${link}&target=7.9`);
    await runContest(page);
    await page.focus('#contest-target');
    await page.evaluate(() =>
      /** @type {HTMLInputElement} */ (document.getElementById('contest-target')).select(),
    );
    await page.press('l', 'o', 'w', Key.ENTER);
    assert.match(await page.text('#contest-target-error'), /must be a number; it was “low”/);
    const isInvalid = () => document.getElementById('contest-target')?.getAttribute('aria-invalid');
    assert.equal(await page.evaluate(isInvalid), 'true');
    assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, 7.9));
    for (const cost of ['999.9999', '758042.9', '8800000'])
      assert.equal(await page.evaluate(hasRoomFor, cost), true, cost);

    await page.click('#contest-usual');
    assert.equal(await page.text('#contest-target-error'), '');
    assert.equal(await page.evaluate(isInvalid), 'false');
    assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, null));
  },
);

/** Whether the field of the target shows all of it. @param {string} text */
function hasRoomFor(text) {
  const field = /** @type {HTMLInputElement} */ (document.getElementById('contest-target'));
  const before = field.value;
  field.value = text;
  const isWhole = field.scrollWidth <= field.clientWidth;
  field.value = before;
  return isWhole;
}

pageTest('fewer seeds are drawn from what is there, and others of them', async (page) => {
  await openContest(page, `${link}&target=7.9&only=5`);
  await runContest(page);
  const cells = async () => (await readTable(page)).map((line) => line.cells[0]);
  const reachedBy = (/** @type {number} */ draw) =>
    standingsOf(small, { target: 7.9, only: 5, draw }).lines.map(({ reached }) => `${reached} of 5`);
  assert.deepEqual(await cells(), reachedBy(0));
  for (const draw of [1, 2, 3]) {
    await page.click('#contest-others');
    assert.deepEqual(await cells(), reachedBy(draw));
  }
  assert.match((await readTable(page))[1].verdict, /In \d+ of 100 draws of 5 seeds one can tell\./);
  await page.focus('#contest-only');
  await page.press(Key.ARROW_RIGHT);
  assert.deepEqual(
    await cells(),
    standingsOf(small, { target: 7.9, only: 6, draw: 3 }).lines.map(({ reached }) => `${reached} of 6`),
  );
  assert.match(await page.text('#contest-count'), /^6 of 15/);
  await page.press(Key.END);
  assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, 7.9));
  await page.press(Key.HOME, Key.ARROW_RIGHT);
  assert.match(await page.text('#contest-count'), /^\d of 15/);
  for (const reading of ['targets', 'ends', 'course']) {
    await page.click(`#contest-reading-${reading}`);
    assert.deepEqual(await page.obstacles('#luck'), []);
  }
  assert.deepEqual(await page.problems(), []);
});

pageTest('what ran before is said to be out of date once another contest is set up', async (page) => {
  await openContest(page, link);
  await runContest(page);
  const status = () => page.text('#contest-status');
  assert.equal(await status(), '');
  for (const change of ['contestant-2 option[value="cauchy"]', 'contest-seeds option[value="51"]']) {
    await page.click(`#${change}`);
    assert.match(await status(), /^Out of date: this is the earlier contest/);
    assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, null));
  }
  assert.deepEqual(await page.obstacles('#luck'), []);
  await page.click('#contestant-2 option[value="truncation"]');
  await page.click('#contest-seeds option[value="15"]');
  assert.equal(await status(), '');
  await page.click('#contestant-2 option[value="cauchy"]');
  await runContest(page);
  assert.equal(await status(), '');
  assert.deepEqual(
    (await readTable(page)).map(({ name }) => name),
    ['lab', 'cauchy', 'fixed', 'de'],
  );
});

for (const language of /** @type {const} */ (['en', 'ko']))
  pageTest(`a contest of four that has run needs no scrolling of the page: ${language}`, async (page) => {
    await openContest(page, `${link}&contestants=n-100,cma-es-7-mirror,de&only=5&until=800&lang=${language}`);
    await runContest(page);
    for (const [width, height] of /** @type {const} */ ([
      [1440, 900],
      [1366, 768],
      [1280, 720],
      [1024, 768],
    ])) {
      await page.resize(width, height);
      const found = await page.evaluate(async () => {
        await pageFrames.settled();
        const { scrollWidth, scrollHeight } = document.documentElement;
        const high = (/** @type {string} */ one) =>
          document.querySelector(one)?.getBoundingClientRect().height ?? 0;
        return {
          excess: [scrollWidth - innerWidth, scrollHeight - innerHeight],
          chart: high('.contest-chart'),
          table: high('.contest-scroll'),
          note: high('.contest-columns'),
          wide: [...document.querySelectorAll('body *')]
            .filter((one) => one.getBoundingClientRect().right > innerWidth + 0.5)
            .map((one) => one.id || `${one.tagName} ${one.className}`),
        };
      });
      assert.deepEqual(found.excess, [0, 0], `${width} × ${height}: ${found.wide}`);
      assert.ok(found.chart >= 110 && found.table >= 100, JSON.stringify(found));
      // What its columns are: in one line, where the picture needs the room.
      assert.ok(found.note > 10 && (width !== 1366 || found.note < 20), JSON.stringify(found));
    }
  });

pageTest(
  'in a frame of 400 × 300 the table takes the place of the picture, and can be read',
  async (page) => {
    await page.resize(400, 300);
    await page.open(`?embed${link}`);
    await runContest(page);
    assert.deepEqual(await page.obstacles(), []);
    await page.click('#contest-reading-table');
    const found = await page.evaluate(() => {
      const box = (/** @type {string} */ one) => {
        const { width, height } = /** @type {HTMLElement} */ (
          document.querySelector(one)
        ).getBoundingClientRect();
        return [width, height];
      };
      const scroll = /** @type {HTMLElement} */ (document.querySelector('.contest-scroll'));
      return {
        chart: box('.contest-chart'),
        table: box('.contest-scroll'),
        wide: scroll.scrollWidth - scroll.clientWidth,
      };
    });
    assert.equal(found.chart[1], 0);
    assert.ok(found.table[1] >= 100 && found.wide <= 0, JSON.stringify(found));
    assert.deepEqual(await page.obstacles(), []);
  },
);
