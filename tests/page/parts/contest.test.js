// The contest: its numbers are those of the core's trials, counted here once more; it can be cancelled, linked and refused in a line.
import assert from 'node:assert/strict';
import { trials } from '../../../pkg/ep_locomotion.js';
import { contestants, entered, ingredientNames } from '../../../www/parts/luck/contestants.js';
import { contestCsv, standingsOf } from '../../../www/parts/luck/contest-summary.js';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { saved } from '../harness/saved.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/parts/luck/contestants.js').Contestant} Contestant */
/** @typedef {import('../../../www/parts/luck/contest-request.js').Contest} Contest */

const velocityLimits = experiment('velocity-limits');

/** The same contest in Node. @param {readonly Contestant[]} others @param {number} seeds @param {number} budget @returns {Contest} */
const contestOf = (others, seeds, budget) => ({
  experiment: velocityLimits,
  seeds,
  budget,
  lines: [null, ...others].map((name) => ({
    name,
    trials: trials(entered(velocityLimits, name), { seeds: [1, 1 + seeds], drives: budget }),
    error: '',
  })),
  cancelled: false,
});
/** @type {Contestant[]} */
const others = ['truncation', 'fixed', 'de'];
const small = contestOf(others, 15, 1000);

test('every contestant runs, and every ingredient is another search', () => {
  const [lab] = contestOf([], 1, 3000).lines;
  for (const name of contestants) {
    const [run] = trials(entered(velocityLimits, name), { seeds: [1, 2], drives: 3000 });
    assert.ok(Number.isFinite(run.champion.cost), name);
    if (ingredientNames.some((one) => one === name) && name !== 'mirror')
      assert.notDeepEqual(run, lab.trials[0], name);
  }
});

test('the trials of a seed are the same in whatever batch it runs', () => {
  for (const name of [null, ...others]) {
    const [alone] = trials(entered(velocityLimits, name), { seeds: [11, 12], drives: 1000 });
    const line = small.lines.find((one) => one.name === name);
    assert.deepEqual(alone, line?.trials[10]);
  }
});

test('the usual target is 0.2 % above the lowest of all, and the standings follow from the trials', () => {
  const { lowest, target, lines } = standingsOf(small);
  const costs = small.lines.map((line) => line.trials.map(({ champion }) => champion.cost));
  const least = Math.min(...costs.flat());
  assert.equal(lowest?.cost, least);
  assert.equal(target, least + 0.002 * least);
  const winner = small.lines.find(({ name }) => name === lowest?.name)?.trials[(lowest?.seed ?? 0) - 1];
  assert.equal(winner?.champion.cost, least);
  for (const [i, line] of lines.entries()) {
    const spent = small.lines[i].trials.map(({ drives, costs: fallen }) => {
      const at = fallen.findIndex((cost) => cost <= target);
      return at < 0 ? null : drives[at];
    });
    const there = spent.filter((one) => one !== null);
    assert.equal(line.reached, there.length);
    const sum = spent.reduce((total, one) => (total ?? 0) + (one ?? 1000), 0) ?? 0;
    assert.equal(line.ert, there.length === 0 ? Infinity : sum / there.length);
    assert.equal(line.median, costs[i].toSorted((a, b) => a - b)[7]);
  }
});

test('verdicts say what the ranks say', () => {
  const twice = {
    ...small,
    lines: [small.lines[0], { ...small.lines[0], name: /** @type {const} */ ('mirror') }],
  };
  assert.deepEqual(standingsOf(twice).lines[1].verdict, { kind: 'same', runs: 15 });
  // A target that everybody meets at the first drive tells nobody apart.
  const easy = standingsOf(small, { target: 1e9 });
  for (const line of easy.lines.slice(1)) assert.equal(line.verdict?.kind, 'undecided');
  const [first] = small.lines;
  const slower = first.trials.map((trial) => ({ ...trial, drives: trial.drives.map((drive) => 3 * drive) }));
  const late = {
    ...small,
    budget: 3000,
    lines: [first, { name: /** @type {const} */ ('de'), trials: slower, error: '' }],
  };
  // So near that all reach it, so far that they do not at once.
  const target = Math.max(...first.trials.map(({ champion }) => champion.cost));
  const { verdict } = standingsOf(late, { target }).lines[1];
  assert.ok(verdict?.kind === 'later' && Math.abs(verdict.times - 3) < 1e-12, JSON.stringify(verdict));
});

test('what is read after fewer drives, or of fewer seeds, is what a shorter contest with them says', () => {
  const shorter = standingsOf(contestOf(others, 15, 400), { target: 7.9 });
  const read = standingsOf(small, { target: 7.9, until: 400 });
  assert.deepEqual(
    read.lines.map(({ runtimes, ert, median, comparison }) => ({ runtimes, ert, median, comparison })),
    shorter.lines.map(({ runtimes, ert, median, comparison }) => ({ runtimes, ert, median, comparison })),
  );
  const five = standingsOf(contestOf(others, 5, 1000), { target: 7.9 });
  const few = standingsOf(small, { target: 7.9, only: 5 });
  for (const [i, line] of five.lines.entries()) {
    assert.deepEqual(few.lines[i].comparison, line.comparison);
    assert.deepEqual(few.lines[i].verdict, line.verdict);
    assert.deepEqual(few.lines[i].interval, line.interval);
  }
  // The usual target is that of all runs.
  assert.equal(standingsOf(small, { only: 5 }).target, standingsOf(small).target);
  const drawn = standingsOf(small, { only: 5, draw: 3 }).drawn.map(({ trials: runs }) =>
    runs.map(({ seed }) => seed),
  );
  assert.ok(drawn.every((seeds) => String(seeds) === String(drawn[0]) && new Set(seeds).size === 5));
  assert.notDeepEqual(drawn[0], [1, 2, 3, 4, 5]);
});

test('at every target and budget a verdict follows from p, A12 and the expected drives alone', () => {
  const kinds = new Set();
  let nearly = 0;
  for (let i = 0; i <= 60; i += 1)
    for (const until of [100, 300, 1000])
      for (const only of [6, 10, 15]) {
        const { lines } = standingsOf(small, { target: 7.71 + 0.02 * i, until, only });
        for (const { verdict, comparison, ert, reached } of lines.slice(1)) {
          const { a12, p } = comparison ?? { a12: 0.5, p: 1 };
          nearly += Number(p >= 0.05 && p < 0.1);
          const isSooner = ert < lines[0].ert;
          const expected =
            p >= 0.05
              ? ['undecided']
              : reached === 0 || lines[0].reached === 0
                ? ['only-this', 'only-first', 'better', 'worse']
                : a12 > 0.5
                  ? [isSooner ? 'sooner' : 'riskier']
                  : [isSooner ? 'surer' : 'later'];
          assert.ok(verdict && expected.includes(verdict.kind), `${verdict?.kind}: ${a12} ${p} ${ert}`);
          kinds.add(verdict.kind);
        }
      }
  assert.ok(nearly > 5 && kinds.size >= 4, `${nearly} ${[...kinds]}`);
});

test('what is behind in most pairs and yet cheaper in the mean is said to be surer', () => {
  const run = (/** @type {number} */ seed, /** @type {number} */ at) => ({
    seed,
    drives: Float64Array.of(1, at),
    costs: Float64Array.of(9, at < 1000 ? 1 : 8),
    champion: { gains: /** @type {[number, number, number]} */ ([1, 1, 1]), cost: at < 1000 ? 1 : 8 },
  });
  const seeds = Array.from({ length: 50 }, (_, i) => i + 1);
  const fast = seeds.map((seed) => run(seed, seed % 10 < 3 ? 1000 : 10 + seed));
  const sure = seeds.map((seed) => run(seed, 200 + seed));
  /** @param {typeof fast} a @param {typeof fast} b */
  const verdictOf = (a, b) =>
    standingsOf(
      {
        ...small,
        budget: 1000,
        seeds: 50,
        lines: [
          { name: null, trials: a, error: '' },
          { name: 'de', trials: b, error: '' },
        ],
      },
      { target: 2 },
    ).lines[1].verdict?.kind;
  assert.equal(verdictOf(fast, sure), 'surer');
  assert.equal(verdictOf(sure, fast), 'riskier');
});

test('the CSV has a row for each improvement', () => {
  const rows = contestCsv(small).trimEnd().split('\r\n');
  assert.equal(rows[0], 'contestant,seed,drive,J');
  const expected = small.lines.flatMap(({ name, trials: runs }) =>
    runs.flatMap(({ seed, drives, costs }) =>
      [...drives].map((drive, i) => `${name ?? 'lab'},${seed},${drive},${costs[i]}`),
    ),
  );
  assert.deepEqual(rows.slice(1), expected);
});

const link = '#luck&v=1&luck=contest&seeds=15&budget=1000';

/** @param {Page} page @param {string} address */
async function openContest(page, address) {
  await page.open(address);
  await page.until('the contest is there', () => {
    const run = document.getElementById('contest-run');
    return run !== null && run.getBoundingClientRect().width > 0;
  });
}

/** @param {Page} page */
async function runContest(page) {
  await page.until('it can run', () => document.getElementById('contest-run'));
  const text = await page.text('#contest-run');
  await page.click('#contest-run');
  await page.until(
    'it has run',
    (ready) =>
      document.getElementById('contest-csv')?.hidden === false &&
      document.getElementById('contest-run')?.textContent === ready,
    text,
  );
}

/** The cells of the table; thin spaces are none. @param {Page} page */
const readTable = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('#contest-table tbody')].map((body) => ({
      name: /** @type {HTMLElement} */ (body).dataset.contestant,
      cells: [...body.querySelectorAll('tr:first-child td')].map((cell) =>
        (cell.textContent ?? '').replaceAll('\u202f', ''),
      ),
      verdict: body.querySelector('.verdict')?.textContent ?? '',
    })),
  );

/** @param {Contest} contest @param {number | null} target */
const expectedTable = (contest, target) =>
  standingsOf(contest, { target }).lines.map(
    ({ name, reached, count, ert, interval, median, comparison }) => ({
      name: name ?? 'lab',
      cells: [
        `${reached} of ${count}`,
        ert === Infinity
          ? '∞'
          : `${Math.round(ert)} ${interval.map((end) => (end === Infinity ? '∞' : Math.round(end))).join('–')}`,
        median.toFixed(4),
        comparison?.a12.toFixed(2) ?? '',
        comparison ? (comparison.p < 0.001 ? '< 0.001' : comparison.p.toFixed(3)) : '',
      ],
    }),
  );

const withoutVerdict = (/** @type {Awaited<ReturnType<typeof readTable>>} */ table) =>
  table.map(({ name, cells }) => ({ name, cells }));

pageTest('the table of the contest is what the core’s trials say, also at another target', async (page) => {
  await openContest(page, link);
  await runContest(page);
  const table = await readTable(page);
  assert.deepEqual(withoutVerdict(table), expectedTable(small, null));
  for (const [i, { verdict }] of standingsOf(small).lines.entries())
    if (verdict?.kind === 'undecided') assert.equal(table[i].verdict, '15 runs cannot tell these two apart.');
  assert.deepEqual(await page.obstacles(), []);

  await openContest(page, `${link}&target=8`);
  await runContest(page);
  assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, 8));
  assert.deepEqual(await page.problems(), []);
});

pageTest('a contestant that cannot run says so in its line, and the others run', async (page) => {
  await openContest(page, `${link}&population=3&contestants=de,random`);
  await runContest(page);
  const [lab, de, random] = await readTable(page);
  assert.match(de.verdict, /4 or more/);
  assert.match(lab.cells[0], /of 15/);
  assert.match(random.cells[0], /of 15/);
});

pageTest('cancel keeps what was done and says how much', async (page) => {
  await openContest(page, '#luck&v=1&luck=contest&seeds=101&budget=20000&contestants=none');
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

/** Where the handle of a line stands, and what it says. @param {Page} page @param {string} id */
const handle = (page, id) =>
  page.evaluate((name) => {
    const element = /** @type {HTMLElement} */ (document.getElementById(name));
    const { left, top, width, height } = element.getBoundingClientRect();
    return {
      x: left + width / 2,
      y: top + height / 2,
      now: Number(element.getAttribute('aria-valuenow')),
      text: element.getAttribute('aria-valuetext') ?? '',
    };
  }, id);

/** Presses on a handle and moves by so much. @param {Page} page @param {string} id @param {number} dx @param {number} dy @param {'mouse' | 'touch'} kind */
const dragHandle = (page, id, dx, dy, kind) =>
  page.evaluate(
    async (name, right, down, pointerType) => {
      const element = /** @type {HTMLElement} */ (document.getElementById(name));
      const { left, top, width, height } = element.getBoundingClientRect();
      const at = { clientX: left + width / 2, clientY: top + height / 2 };
      const send = (/** @type {string} */ type, /** @type {object} */ point) =>
        element.dispatchEvent(
          new PointerEvent(type, {
            ...point,
            pointerId: 1,
            pointerType,
            button: 0,
            buttons: 1,
            bubbles: true,
            cancelable: true,
          }),
        );
      // A pointer that is made up cannot be captured.
      element.setPointerCapture = () => {};
      element.hasPointerCapture = () => true;
      send('pointerdown', at);
      for (const part of [0.5, 1])
        send('pointermove', { clientX: at.clientX + part * right, clientY: at.clientY + part * down });
      send('pointerup', at);
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    },
    id,
    dx,
    dy,
    kind,
  );

engineTest(
  'target and budget are dragged by mouse and finger, and moved by keys; the table follows',
  async (page) => {
    await openContest(page, `${link}&target=7.9`);
    await runContest(page);
    for (const kind of /** @type {const} */ (['mouse', 'touch'])) {
      const before = await handle(page, 'contest-target-line');
      await dragHandle(page, 'contest-target-line', 0, -20, kind);
      const after = await handle(page, 'contest-target-line');
      assert.ok(
        after.now > before.now && Math.abs(before.y - 20 - after.y) < 2,
        JSON.stringify([before, after]),
      );
      const typed = await page.evaluate(() =>
        Number(/** @type {HTMLInputElement} */ (document.getElementById('contest-target')).value),
      );
      assert.equal(typed, after.now);
      assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, after.now));
    }
    const { now: target } = await handle(page, 'contest-target-line');
    const whole = await handle(page, 'contest-until-line');
    assert.equal(whole.now, 1000);
    await dragHandle(page, 'contest-until-line', -60, 0, 'touch');
    const until = await handle(page, 'contest-until-line');
    assert.ok(until.now < 900 && until.now > 50, JSON.stringify(until));
    const expected = standingsOf(small, { target, until: until.now }).lines.map(
      ({ reached }) => `${reached} of 15`,
    );
    assert.deepEqual(
      (await readTable(page)).map(({ cells }) => cells[0]),
      expected,
    );
    await page.evaluate(() => document.getElementById('contest-until-line')?.focus());
    await page.press(Key.ARROW_RIGHT);
    await page.until(
      'a key moves it on',
      (was) => Number(document.getElementById('contest-until-line')?.getAttribute('aria-valuenow')) > was,
      until.now,
    );
    await page.click('#contest-whole');
    await page.until(
      'it is read to the end',
      () => document.getElementById('contest-until-line')?.getAttribute('aria-valuenow') === '1000',
    );
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('a target that is no number is refused, and the one before stays', async (page) => {
  await openContest(page, `${link}&target=7.9`);
  await runContest(page);
  await page.focus('#contest-target');
  await page.evaluate(() =>
    /** @type {HTMLInputElement} */ (document.getElementById('contest-target')).select(),
  );
  await page.press('l', 'o', 'w', Key.ENTER);
  assert.match(await page.text('#contest-target-error'), /must be a number; it was “low”/);
  assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, 7.9));
});

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
  for (const reading of ['targets', 'ends', 'course']) {
    await page.click(`#contest-reading-${reading}`);
    assert.deepEqual(await page.obstacles(), []);
  }
  assert.deepEqual(await page.problems(), []);
});

pageTest('the button writes the CSV of all runs', async (page) => {
  await openContest(page, link);
  await runContest(page);
  assert.equal(await saved(page, '#contest-csv'), contestCsv(small));
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
        for (let frame = 0; frame < 2; frame += 1)
          await new Promise((resolve) => requestAnimationFrame(resolve));
        const { scrollWidth, scrollHeight } = document.documentElement;
        const high = (/** @type {string} */ one) =>
          document.querySelector(one)?.getBoundingClientRect().height ?? 0;
        return {
          excess: [scrollWidth - innerWidth, scrollHeight - innerHeight],
          chart: high('.contest-chart'),
          table: high('.contest-scroll'),
          wide: [...document.querySelectorAll('body *')]
            .filter((one) => one.getBoundingClientRect().right > innerWidth + 0.5)
            .map((one) => one.id || `${one.tagName} ${one.className}`),
        };
      });
      assert.deepEqual(found.excess, [0, 0], `${width} × ${height}: ${found.wide}`);
      assert.ok(found.chart >= 110 && found.table >= 100, JSON.stringify(found));
    }
  });

engineTest(
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
