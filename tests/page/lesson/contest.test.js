// What the lesson says of the parts and the rivals is so, with the contests that it shows.
import assert from 'node:assert/strict';
import { contestOf } from '../../../www/parts/luck/contest-asked.js';
import { standingsOf } from '../../../www/parts/luck/contest-summary.js';
import { luckSlice } from '../../../www/parts/luck/state.js';
import { sideOf } from '../../../www/lesson/steps/contest.js';
import { contest as en } from '../../../www/lesson/words/en/contest.js';
import { contest as ko } from '../../../www/lesson/words/ko/contest.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { pageTest } from '../harness/browsers.js';
import { Evolution } from '../harness/core.js';
import { engine, evolved, opened, shownIn } from './links.js';
import { answered, tryOf } from './live.js';
import { test } from '../harness/once.js';

const step = stepOf('contest');

/** The contest of a link, with its target. @param {string} link */
async function ran(link) {
  const asked = shownIn(link, luckSlice);
  assert.equal(asked.view, 'contest');
  const contest = await contestOf(engine, opened(link).experiment, asked);
  return (/** @type {import('../../../www/parts/luck/contest-summary.js').Reading} */ reading = {}) =>
    standingsOf(contest, { target: asked.target, until: asked.until, ...reading }).lines;
}

test('51 runs cannot tell the tournament from truncation', async () => {
  const { outcome, why } = await answered('contest', 'tournament');
  assert.equal(outcome.right, 2);
  assert.ok(Math.abs(outcome.first.reached - outcome.other.reached) <= 5);
  assert.match(why[0], /51 runs cannot tell the two apart \(p = 0\.\d/);
  // Of fewer some show a difference all the same.
  const [, other] = (await ran(step.link))({ only: 20 });
  assert.equal(other.verdict?.kind, 'better');
});

test('self-adaptation is no sooner at 8.09, and far ahead at 7.72: the curves cross', async () => {
  const { outcome, why } = await answered('contest', 'sigma');
  assert.equal(outcome.right, 1);
  const { early, late } = outcome;
  assert.ok(early[1].ert < early[0].ert && sideOf(early[1]) === 0);
  assert.ok(sideOf(late[1]) < 0 && late[1].reached <= 2 && late[0].reached >= 25);
  assert.match(why[0], /1 of 51 with σ = 1/);
});

test('with five seeds one can tell about half of the time, and hardly ever fails to with twenty', async () => {
  const { outcome } = await answered('contest', 'fewer');
  assert.equal(outcome.right, 1);
  assert.ok(outcome.told > 35 && outcome.told < 65, `${outcome.told}`);
  const lines = await ran(
    step.blocks.flatMap((block) =>
      block.kind === 'quiz' && block.name === 'fewer' ? [block.quiz.shows ?? ''] : [],
    )[0],
  );
  assert.ok((lines({ only: 20 })[1].told ?? 0) >= 95);
  assert.equal(lines({ only: 3 })[1].told, 0);
  // Other seeds, another sentence.
  const kinds = new Set(Array.from({ length: 20 }, (_, draw) => lines({ only: 5, draw })[1].verdict?.kind));
  assert.ok(kinds.has('undecided') && kinds.size > 1, [...kinds].join());
});

test('a hundred robots lose at 4 000 drives and win at 20 000', async () => {
  const { outcome } = await answered('contest', 'crowd');
  assert.equal(outcome.right, 1);
  const [[few, many], [fewer, more]] = [outcome.early, outcome.late];
  assert.ok(few.reached > many.reached + 10 && more.reached > fewer.reached + 10);
  // Twenty robots stand still from there on.
  assert.ok(fewer.reached - few.reached <= 5, `${few.reached} ${fewer.reached}`);
});

test('DE gets there soonest, CMA-ES with seven trials hardly', async () => {
  const { outcome } = await answered('contest', 'rivals');
  assert.equal(outcome.right, 1);
  const [ep, de, cma] = outcome.lines;
  assert.ok(de.ert < ep.ert / 2 && sideOf(de) > 0);
  assert.ok(cma.ert > 2 * ep.ert && sideOf(cma) < 0);
});

test('its ellipse has shrunk where J is not lowest; both remedies help', async () => {
  const { experiment, generation } = opened('landscape&evolution.method=cma-es&population=7&generation=55');
  const evolution = new Evolution(experiment);
  for (let i = 0; i < generation; i += 1) evolution.step();
  const { ellipse } = evolution.record(generation);
  assert.ok(ellipse);
  const lengths = ellipse.axes.map((axis) => Math.hypot(...axis));
  assert.ok(Math.max(...lengths) < 0.1, lengths.join());
  assert.ok(evolution.statistics().best.cost > 7.76);
  // As many drives as with twenty trials a generation.
  assert.ok(Math.abs((generation + 1) * 7 - 20 * 20) <= 10);
  const [, seven, mirrored, twenty] = (await ran(tryOf('contest', 'remedies')))();
  // The two that the text opens show the same, after as many drives.
  for (const { texts } of [en, ko]) {
    const links = [...texts.ellipse.matchAll(/\]\((landscape[^)]+)\)/g)].slice(1).map(([, link]) => link);
    const [mirror, more] = links.map(evolved);
    for (const { experiment, generation } of [mirror, more])
      assert.ok(Math.abs((generation + 1) * experiment.evolution.population - 4000) <= 10, links.join());
    const [one, other] = [mirror, more].map(({ evolution }) => evolution.population()[0].cost);
    assert.ok(other < one && one < 7.76, `${other}, ${one}`);
  }
  assert.ok(mirrored.reached > 1.5 * seven.reached && twenty.reached > 1.5 * mirrored.reached);
});

test('of the other parts only crossover helps; a child against its own parent is fatal', async () => {
  const [own, crossover, cauchy, parent] = (await ran(tryOf('contest', 'crossover')))();
  assert.ok(sideOf(crossover) > 0 && crossover.verdict?.kind === 'sooner');
  assert.deepEqual([own.reached, cauchy.reached, sideOf(cauchy)], [34, 41, 0]);
  assert.ok(sideOf(parent) < 0 && parent.reached === 0);
});

test('with a floor far fewer runs are lost, and none gets far below its target', async () => {
  // The other of its rivals is not spoken of.
  const lines = await ran(tryOf('contest', 'floor').replace(',fixed', ''));
  const [own, floor] = lines();
  assert.ok(floor.reached > own.reached + 10);
  const [ownLower, floorLower] = lines({ target: 7.706 });
  assert.ok(floorLower.reached === 0 && ownLower.reached >= 10);
});

test('whether six robots come to 7.8 sooner than twenty, 51 runs cannot tell; a hundred need twice as many drives', async () => {
  const [twenty, six, hundred] = (await ran(tryOf('contest', 'robots')))();
  assert.equal(sideOf(six), 0);
  assert.ok(hundred.ert > 1.8 * twenty.ert && hundred.ert < 2.6 * twenty.ert && sideOf(hundred) < 0);
});

test('a hand with sliders that end at 0 wins two pairs of three and fails more often, and is lost without that end', async () => {
  const [own, hand, endless, simplex] = (await ran(tryOf('contest', 'hand')))();
  assert.deepEqual([own.reached, hand.reached], [49, 37]);
  assert.ok(Math.abs((hand.comparison?.a12 ?? 0) - 2 / 3) < 0.05, `${hand.comparison?.a12}`);
  assert.ok(endless.reached < hand.reached / 3 && sideOf(endless) < 0, `${endless.reached}`);
  assert.ok(simplex.ert > own.ert && sideOf(simplex) < 0);
});

pageTest(
  'what is predicted runs in sight, and is answered from what stands there; what is tried then runs at once, with whole names at its curves',
  async (page) => {
    await page.resize(1280, 800);
    await page.open('#lesson&step=contest');
    await page.click('#quiz-tournament .choice:first-child');
    const why = await page.until(
      'the answer',
      () => document.querySelector('#quiz-tournament .quiz-why strong')?.parentElement?.innerText,
    );
    assert.match(String(why), /cannot tell the two apart/);
    const cells = await page.evaluate(() =>
      [...document.querySelectorAll('#contest-table tbody')].map(
        (row) => row.querySelector('td')?.textContent ?? '',
      ),
    );
    assert.equal(cells.length, 2);
    for (const cell of cells) assert.ok(/\d/.test(cell) && String(why).includes(cell), cells.join());

    await page.evaluate(() => {
      const write = CanvasRenderingContext2D.prototype.fillText;
      /** @type {Map<string, number>} */
      const over = new Map();
      Object.assign(window, { over });
      CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
        const { width } = this.canvas.getBoundingClientRect();
        over.set(text, x + this.measureText(text).width - width);
        write.call(this, text, x, y);
      };
    });
    await page.click('.try[data-try="remedies"]');
    const over = await page.until('it has run, and names its curves', () => {
      const now = /** @type {any} */ (window).over;
      const rows = [
        .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#contest-table tbody')),
      ];
      const names = rows.map((row) => row.querySelector('[scope="row"]')?.textContent?.trim() ?? '');
      return (
        document.getElementById('contest-csv')?.hidden === false &&
        rows.map(({ dataset }) => dataset.contestant).join() === 'lab,cma-es-7,cma-es-7-mirror,cma-es' &&
        names.every((name) => now.has(name)) &&
        names.map((name) => now.get(name))
      );
    });
    assert.equal(await page.text('#contest-status'), '');
    assert.match(
      await page.evaluate(() => location.hash),
      /contestants=cma-es-7,cma-es-7-mirror,cma-es.*lesson=contest/,
    );
    for (const one of over) assert.ok(one <= 0, `${over}`);
    assert.deepEqual(await page.problems(), []);
  },
);
