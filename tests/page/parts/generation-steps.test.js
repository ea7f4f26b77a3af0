// How one goes through a generation: by press, keys and phases.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { readEvolution, seedOne } from '../harness/reading.js';
import {
  count,
  go,
  nameOf,
  numbersIn,
  openAt,
  ownSection,
  phases,
  press,
  rank,
  recordOf,
  same,
  shownOn,
  table,
  upsetOf,
  velocityLimits,
} from './generation-page.js';

pageTest('one of them is chosen by a press, by keys, and by name', async (page) => {
  await openAt(page, 3);
  const record = recordOf(3);
  await go(page, 'ranking');
  for (let number = 0; number < 2 * count; number += 5) {
    await press(page, number);
    const seen = await shownOn(page);
    assert.equal(seen.headline.toLowerCase().startsWith(nameOf(number)), true, seen.headline);
    assert.equal(seen.chosen, nameOf(number));
  }
  const order = rank(
    record.wins,
    record.all.map(({ cost }) => cost),
  );
  await page.focus('#generation-picture');
  const last = 2 * count - 1;
  for (const [key, place] of /** @type {const} */ ([
    [Key.HOME, 0],
    [Key.ARROW_RIGHT, 1],
    [Key.ARROW_UP, 2],
    [Key.PAGE_UP, 12],
    [Key.PAGE_DOWN, 2],
    [Key.ARROW_LEFT, 1],
    [Key.ARROW_DOWN, 0],
    [Key.ARROW_DOWN, 0],
    [Key.END, last],
    [Key.ARROW_RIGHT, last],
  ])) {
    await page.press(key);
    assert.equal((await shownOn(page)).chosen, nameOf(order[place]), key);
  }
  await go(page, 'tournament');
  await page.focus('#generation-picture');
  // Each parent stands before its offspring.
  await page.press(Key.HOME, Key.ARROW_RIGHT);
  assert.equal((await shownOn(page)).chosen, nameOf(count));
  const links = await page.elements('#generation-details .bouts button');
  await links[0].click();
  assert.equal((await shownOn(page)).chosen, nameOf(record.opponents[count][0]));
});

pageTest('a survivor that is worse than one that fell is pointed out', async (page) => {
  const generation = Array.from({ length: 20 }, (_, i) => i + 1).find((one) => upsetOf(recordOf(one))) ?? 0;
  const record = recordOf(generation);
  const upset = upsetOf(record);
  assert.ok(upset);
  await openAt(page, generation);
  for (const phase of /** @type {const} */ (['ranking', 'survivors'])) {
    await go(page, phase);
    const { details } = await shownOn(page);
    const sentence = details.split('\n').find((line) => line.includes('luck in the opponents')) ?? '';
    const [name, cost, wins, other, otherCost, otherWins] = numbersIn(sentence);
    assert.ok(sentence.toLowerCase().startsWith(`${nameOf(upset.survivor)} (`), sentence);
    assert.ok(sentence.includes(`; ${nameOf(upset.fallen)} (`), sentence);
    assert.equal(Number(name), (upset.survivor % count) + 1);
    assert.equal(Number(other), (upset.fallen % count) + 1);
    same(cost, record.all[upset.survivor].cost, sentence);
    same(otherCost, record.all[upset.fallen].cost, sentence);
    assert.deepEqual(
      [Number(wins), Number(otherWins)],
      [record.wins[upset.survivor], record.wins[upset.fallen]],
    );
  }
});

pageTest('a generation that kept exactly the best says so', async (page) => {
  const small = { ...velocityLimits, evolution: { ...velocityLimits.evolution, population: 3 } };
  const generation =
    Array.from({ length: 40 }, (_, i) => i + 1).find((one) => !upsetOf(recordOf(one, small))) ?? 0;
  await page.open(`#generation&v=1&population=3&generation=${generation}`);
  await go(page, 'ranking');
  const { title, details } = await shownOn(page);
  assert.equal(title, `Generation ${generation}`);
  assert.ok(details.includes('exactly the 3 with the lowest J'), details);
});

pageTest('one phase at a time, over the last one into the next generation, and back', async (page) => {
  await openAt(page, 2);
  const record = recordOf(2);
  const [followed] = record.survivors.slice(-1);
  await go(page, 'survivors');
  await press(page, followed);
  await go(page, 'parents');
  await page.focus('#generation-next');
  for (const phase of phases) {
    assert.equal((await shownOn(page)).phase, phase);
    await page.press(Key.ENTER);
  }
  const next = await shownOn(page);
  assert.deepEqual([next.title, next.phase], ['Generation 3', 'parents']);
  // Choosing a phase in which only parents are there keeps who was chosen.
  assert.equal(next.chosen, nameOf(count - 1));

  await page.click('#generation-back');
  const before = await shownOn(page);
  assert.deepEqual(
    [before.title, before.phase, before.chosen],
    ['Generation 2', 'survivors', nameOf(followed)],
  );
});

pageTest(
  'whom one is shown is followed into the next generation and back, also who chose nobody',
  async (page) => {
    const upsets = Array.from({ length: 20 }, (_, i) => i + 1);
    const generation = upsets.find((one) => upsetOf(recordOf(one))) ?? 0;
    const record = recordOf(generation);
    const { survivor } = /** @type {{ survivor: number }} */ (upsetOf(record));
    await page.open(`#generation&v=1&generation=${generation}&phase=survivors`);
    assert.equal((await shownOn(page)).chosen, nameOf(survivor));
    await page.click('#generation-next');
    const next = await shownOn(page);
    assert.equal(next.title, `Generation ${generation + 1}`);
    assert.equal(next.chosen, nameOf(record.survivors.indexOf(survivor)));
    assert.ok(!next.details.includes('shown until here'), next.details);
    await page.click('#generation-back');
    assert.equal((await shownOn(page)).chosen, nameOf(survivor));

    const fallen =
      Array.from({ length: 2 * count }, (_, i) => i).find((i) => !record.survivors.includes(i)) ?? 0;
    await page.open(`#generation&v=1&generation=${generation}&phase=survivors&individual=${fallen}`);
    await page.click('#generation-next');
    const other = await shownOn(page);
    const told = `${nameOf(fallen)}, shown until here, fell in generation ${generation}.`;
    assert.ok(other.details.toLowerCase().includes(told), other.details);
    await press(page, 3);
    assert.ok(!(await shownOn(page)).details.includes('shown until here'));
  },
);

pageTest('generation 0 has random robots only, and leads to generation 1', async (page) => {
  await page.click('#page-generation');
  const first = recordOf(0);
  const seen = await shownOn(page);
  assert.ok(seen.sentence.includes('20 robots with random gains'), seen.sentence);
  for (const phase of ['mutation', 'drive', 'tournament', 'ranking'])
    assert.equal((await page.elements(`#generation-phases-${phase}`)).length, 0, phase);
  await press(page, 4);
  const chosen = await shownOn(page);
  assert.equal(chosen.chosen, 'robot 5');
  for (const i of [0, 1, 2]) same(numbersIn(chosen.equations[2 * i])[0], first.parents[4].gains[i], 'a gain');
  await page.click('#generation-next');
  assert.equal((await shownOn(page)).phase, 'survivors');
  await page.click('#generation-next');
  const next = await shownOn(page);
  assert.deepEqual([next.title, next.phase], ['Generation 1', 'parents']);
  assert.equal(next.chosen, `parent ${first.survivors.indexOf(4) + 1}`);
});

pageTest('from generation 0 one press leads into the phases of generation 1', async (page) => {
  await page.open('#generation&v=1');
  assert.equal((await shownOn(page)).title, 'Generation 0');
  const name = await page.evaluate(() => document.getElementById('generation-begin')?.textContent);
  assert.equal(name, 'Breed generation 1');
  // One button leads on.
  const leading = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('.primary')].filter((one) => one.checkVisibility()).map(({ id }) => id),
    );
  assert.deepEqual(await leading(), ['generation-begin']);
  await page.click('#generation-begin');
  const born = await shownOn(page);
  assert.deepEqual([born.title, born.phase], ['Generation 1', 'mutation']);
  const { visible, focus } = await page.evaluate(() => ({
    visible: document.getElementById('generation-begin')?.checkVisibility(),
    focus: document.activeElement?.id,
  }));
  assert.deepEqual([visible, focus], [false, 'generation-next']);
  assert.deepEqual(await leading(), ['generation-next']);
  for (const phase of phases)
    assert.ok(await (await page.element(`#generation-phases-${phase}`)).isEnabled(), phase);
});

pageTest('back in time the generation is as it was, and evolution is untouched', async (page) => {
  await openAt(page, 12);
  await go(page, 'tournament');
  await page.focus('#timeline');
  await page.press(Key.HOME, ...Array(5).fill(Key.ARROW_RIGHT));
  const { title } = await shownOn(page);
  assert.equal(title, 'Generation 5');
  const record = recordOf(5);
  const rows = await table(page);
  assert.deepEqual(
    rows.map(({ number, wins }) => [Number(number), Number(wins)]),
    rank(
      record.wins,
      record.all.map(({ cost }) => cost),
    ).map((number) => [number, record.wins[number]]),
  );
  for (const phase of phases) await go(page, phase);
  await press(page, record.survivors[3]);
  await page.focus('#timeline');
  await page.press(Key.END);
  await page.click('#page-lab');
  assert.deepEqual(await readEvolution(page), seedOne(12));
  assert.equal((await shownOn(page)).legend, 'best of generation 12');
  await page.click('#one-generation');
  assert.deepEqual(await readEvolution(page), seedOne(13));
});

pageTest('each phase is readable for everybody, in sight without scrolling', async (page) => {
  await page.resize(1024, 768);
  await openAt(page, 3);
  for (const phase of phases) {
    await go(page, phase);
    assert.deepEqual(await page.obstacles(phase === 'drive' ? 'html' : ownSection), [], phase);
    const { height, rule } = await page.evaluate(() => ({
      height: document.documentElement.scrollHeight,
      rule: ['.rule', '.rule sup'].map((selector) => {
        const box = document.querySelector(`#generation-details ${selector}`)?.getBoundingClientRect();
        return { top: box?.top ?? 0, height: box?.height ?? 0 };
      }),
    }));
    assert.equal(height, 768, phase);
    if (phase !== 'mutation') continue;
    // The rule stands in one line.
    const [line, exponent] = rule;
    const isOne = line.height > 10 && line.height < 30 && exponent.top < line.top + line.height / 2;
    assert.ok(isOne, JSON.stringify(rule));
  }
  assert.deepEqual(await page.problems(), []);
});
