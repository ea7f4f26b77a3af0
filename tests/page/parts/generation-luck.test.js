// What luck did to the robots of a generation, and where their names stand.
import assert from 'node:assert/strict';
import { expectedWins, winsBout } from '../../../www/core/rules.js';
import { detailsOf } from '../../../www/parts/generation/details.js';
import { lettersOf, writingOf } from '../../../www/parts/generation/notes.js';
import { orderOf, placesOf } from '../../../www/parts/generation/places.js';
import { createAnatomy, createChosenDrives, dissect } from '../../../www/parts/generation/record.js';
import { generationSlice } from '../../../www/parts/generation/state.js';
import { generationTable } from '../../../www/parts/generation/table.js';
import * as en from '../../../www/parts/generation/words/en.js';
import * as ko from '../../../www/parts/generation/words/ko.js';
import { pageTest } from '../harness/browsers.js';
import { Evolution } from '../harness/core.js';
import { test } from '../harness/once.js';
import { written } from '../harness/templates.js';
import {
  count,
  go,
  nameOf,
  numbersIn,
  openAt,
  rank,
  recordOf,
  shownOn,
  velocityLimits,
} from './generation-page.js';

test('the wins to expect are the mean over all whom one may meet', () => {
  const costs = [3, 1, 2, 2, Infinity, 7, Infinity];
  for (const bouts of [1, 10]) {
    const exact = costs.map((own, i) => {
      const others = costs.filter((_, j) => j !== i);
      return (bouts * others.filter((other) => winsBout(own, other)).length) / others.length;
    });
    assert.deepEqual(expectedWins(costs, bouts), exact);
  }
});

test('in a tournament each of them has the bouts of the record', () => {
  const anatomy = anatomyOf(7);
  const { record, all } = anatomy;
  // From left to right each parent stands before its offspring.
  const pairs = Array.from({ length: count }, (_, pair) => [pair, pair + count]);
  assert.deepEqual(orderOf(anatomy, 'tournament'), pairs.flat());
  const costs = all.map(({ cost }) => cost);
  assert.deepEqual(orderOf(anatomy, 'ranking'), rank(record.wins, costs));
  for (const chosen of all.keys()) {
    const model = /** @type {any} */ ({ anatomy, phase: 'tournament', chosen });
    const html = written(detailsOf(model, /** @type {any} */ ({ choose() {} })));
    const [, ...bouts] = html.split('<li');
    const won = record.opponents[chosen].map((other) => winsBout(all[chosen].cost, all[other].cost));
    assert.deepEqual(
      bouts.map((bout) => [/(?:parent|offspring) \d+/.exec(bout)?.[0], bout.includes('✓')]),
      Array.from(record.opponents[chosen], (other, i) => [nameOf(other), won[i]]),
    );
    assert.equal(won.filter(Boolean).length, record.wins[chosen]);
  }
});

test('the table of a generation is ranked by wins, then by J, and the first of it are the parents of the next', () => {
  const [anatomy, next] = [7, 8].map((generation) => anatomyOf(generation));
  const rowsOf = (/** @type {typeof anatomy} */ of) => {
    const { columns, count: rows, rowOf } = generationTable(of);
    return Array.from({ length: rows }, (_, i) =>
      Object.fromEntries(rowOf(i).map((text, column) => [columns[column], text])),
    );
  };
  const [rows, after] = [anatomy, next].map(rowsOf);
  assert.equal(rows.length, 2 * count);
  const costs = [...rows].sort((a, b) => Number(a.number) - Number(b.number)).map(({ J }) => Number(J));
  const order = rank(anatomy.record.wins, costs);
  assert.deepEqual(
    rows.map(({ number, wins, survives }) => [Number(number), Number(wins), survives]),
    order.map((number, i) => [number, anatomy.record.wins[number], i < count ? 'yes' : 'no']),
  );
  assert.deepEqual(order.slice(0, count), anatomy.record.survivors);
  for (let i = 0; i < count; i += 1) {
    const parent = after.find(({ who }) => who === `parent ${i + 1}`);
    for (const column of ['kx', 'ky', 'kθ', 'σx', 'σy', 'σθ'])
      assert.equal(parent?.[column], rows[i][column]);
  }
});

test('over many seeds the wins are in the mean those that were to be expected', () => {
  let [luck, variance, spread] = [0, 0, 0];
  for (let seed = 1; seed <= 200; seed += 1) {
    const evolution = new Evolution({
      ...velocityLimits,
      evolution: { ...velocityLimits.evolution, seed },
    });
    evolution.step();
    const { parents, offspring, opponents, wins } = evolution.record(1);
    const bouts = opponents[0].length;
    const costs = [...parents, ...offspring].map(({ cost }) => cost);
    for (const [i, expected] of expectedWins(costs, bouts).entries()) {
      luck += wins[i] - expected;
      spread += (wins[i] - expected) ** 2;
      variance += expected * (1 - expected / bouts);
    }
    evolution.free();
  }
  // Within four standard errors: and the bouts scatter as independent draws do.
  assert.ok(Math.abs(luck) < 4 * Math.sqrt(variance), `${luck}`);
  assert.ok(Math.abs(spread / variance - 1) < 0.1, `${spread / variance}`);
});

test('luck is what is written of the wins and of those that were expected', () => {
  for (const words of [en, ko]) {
    for (const [expected, wins, sign] of /** @type {const} */ ([
      [5.9, 7, '+1.1'],
      [5.949, 7, '+1.1'],
      [3.2, 1, '−2.2'],
      [3, 3, '0'],
      [2.04, 2, '0'],
    ]))
      assert.ok(words.luckText(expected, wins).endsWith(` ${sign}`), words.luckText(expected, wins));
  }
});

/** @param {number} generation @param {number} seed */
function anatomyOf(generation, seed = 1) {
  const evolution = new Evolution({ ...velocityLimits, evolution: { ...velocityLimits.evolution, seed } });
  for (let g = 0; g < generation; g += 1) evolution.step();
  return dissect(evolution.record(generation), velocityLimits.evolution);
}

test('who is chosen is one of the others only where it drives among them', () => {
  const state = (/** @type {string} */ phase, /** @type {number} */ chosen) =>
    /** @type {any} */ ({
      page: 'generation',
      generation: 5,
      history: Array.from({ length: 6 }, (_, generation) => ({ generation })),
      experiment: velocityLimits,
      slices: { [generationSlice.name]: { phase, chosen } },
    });
  const drives = createChosenDrives(createAnatomy(() => recordOf(5)));
  const record = recordOf(5);
  const fallen =
    Array.from({ length: 2 * count }, (_, i) => i).find((i) => !record.survivors.includes(i)) ?? 0;
  for (const [phase, chosen, text] of /** @type {const} */ ([
    ['drive', 6, 'the 20 offspring, 16 of them arrive'],
    ['drive', count + 6, 'the other 19 offspring, 16 of them arrive'],
    ['survivors', fallen, 'the 20 survivors, 16 of them arrive'],
    ['survivors', record.survivors[0], 'the other 19 survivors, 16 of them arrive'],
    ['parents', 6, 'the other 19 parents, 16 of them arrive'],
    ['ranking', 6, 'the other 39, 16 of them arrive'],
  ])) {
    const own = drives(state(phase, chosen));
    const all = (own?.population.length ?? 0) - 1;
    assert.equal(own?.othersText(all, 16), text);
  }
  const others = { drawn: 20, all: 20, isAmong: false, arrived: 16 };
  assert.equal(ko.othersText(anatomyOf(5), 'drive', others), '자손 로봇 20대, 그중 16대 도착');
});

test('whatever the method, Korean counts robots as robots, and none that is left twice', () => {
  const others = { drawn: 19, all: 19, arrived: 16 };
  for (const method of /** @type {const} */ (['de', 'random'])) {
    const settings = { ...velocityLimits.evolution, method };
    const evolution = new Evolution({ ...velocityLimits, evolution: settings });
    evolution.step();
    const anatomy = dissect(evolution.record(1), settings);
    for (const number of anatomy.all.keys())
      assert.doesNotMatch(ko.fateText(anatomy, number), /(?<!로봇 )20대/);
    const told = (/** @type {boolean} */ isAmong) =>
      ko.othersText(anatomy, 'survivors', { ...others, isAmong });
    assert.deepEqual(
      [told(true), told(false)],
      ['나머지 로봇 19대, 그중 16대 도착', '남은 로봇 19대, 그중 16대 도착'],
    );
  }
});

test('the name of the chosen one goes to a side where it covers no other', () => {
  const size = { width: 493, height: 180 };
  const own = { x: 200, y: 90 };
  const [above, below, right] = [{ x: 220, y: 72 }, { x: 190, y: 112 }, { x: 240, y: 90 }]; // biome-ignore format: three marks
  const at = (/** @type {{ x: number, y: number }[]} */ ...others) =>
    writingOf(own, [own, ...others], size, false, 'robot 2');
  assert.ok(at().y < own.y);
  assert.ok(at(above).y > own.y);
  const beside = at(above, below);
  assert.ok(beside.side === 'begin' && beside.x > own.x);
  assert.equal(at(above, below, right).side, 'end');
  assert.ok(writingOf(own, [own], size, true, 'robot 2').y > own.y);
});

test('in a ranking the names of the two whom luck told apart cover no mark, and stand at their own', () => {
  const size = { width: 528, height: 245 };
  for (const seed of [1, 2, 3, 4, 5])
    for (const generation of [1, 3, 5, 8]) {
      const anatomy = anatomyOf(generation, seed);
      const places = placesOf(anatomy, 'ranking', size);
      const marks = orderOf(anatomy, 'ranking').map((number) => places[number]);
      const { fallen = -1 } = anatomy.upset ?? {};
      if (fallen < 0) continue;
      const name = en.nameOf(anatomy, fallen);
      const { x, y, side } = writingOf(places[fallen], marks, size, true, name);
      const [from, to] = { begin: [0, 88], middle: [-44, 44], end: [-88, 0] }[side].map((dx) => x + dx);
      const covered = marks.filter(
        (mark) => mark.x > from && mark.x < to && mark.y > y - 12 && mark.y < y + 4,
      );
      const what = `seed ${seed}, generation ${generation}`;
      assert.equal(covered.length, 0, what);
      assert.ok(y >= places[fallen].y && y <= places[fallen].y + 24, what);
      // Another name there gives way to it.
      const letters = lettersOf({ x, y, side }, name);
      const next = writingOf(places[fallen], [...marks, ...letters], size, true, name);
      assert.notDeepEqual(next, { x, y, side }, what);
    }
});

pageTest('the ranking says of each what it had to expect and what luck did', async (page) => {
  await page.resize(1366, 768);
  await openAt(page, 5);
  await go(page, 'ranking');
  const { all, wins, opponents } = recordOf(5);
  const costs = all.map(({ cost }) => cost);
  const expected = expectedWins(costs, opponents[0].length);
  const order = rank(wins, costs);
  const { ranks } = await shownOn(page);
  assert.ok(ranks.length > 3);
  for (const text of ranks) {
    const [place, , won, , , due, luck] = [...numbersIn(text.replace('J', 'J 0')), '0'].map(Number);
    const who = order[place - 1];
    assert.equal(won, wins[who]);
    assert.ok(Math.abs(due - expected[who]) <= 0.0501, text);
    assert.ok(Math.abs(luck - (won - due)) < 0.01, text);
  }
  const lines = await page.evaluate(() =>
    [...document.querySelectorAll('.generation-picture line.luck')].map((line) =>
      ['x1', 'x2'].map((name) => Number(line.getAttribute(name))),
    ),
  );
  assert.equal(lines.length, 2 * count);
  // Who moved left of where J alone would rank it had more wins than others of its J.
  const ends = lines.map(([, end]) => end).sort((a, b) => a - b);
  assert.equal(new Set(ends.map(Math.round)).size, 2 * count);
  assert.deepEqual(await page.obstacles(), []);
});
