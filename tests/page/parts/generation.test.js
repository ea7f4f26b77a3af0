import assert from 'node:assert/strict';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { Evolution, evolve, experiment, simulate } from '../harness/core.js';
import { read, readEvolution } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../pkg/ep_locomotion.js').GenerationRecord} GenerationRecord */

const velocityLimits = experiment('velocity-limits');
const { population: count, opponents: bouts } = velocityLimits.evolution;
const phases = /** @type {const} */ (['parents', 'mutation', 'drive', 'tournament', 'ranking', 'survivors']);
/** @typedef {typeof phases[number]} Phase */

/** The core's own record of a generation, and who would be who. @param {number} generation @param {typeof velocityLimits} [from] */
function recordOf(generation, from = velocityLimits) {
  const evolution = new Evolution(from);
  for (let i = 0; i < generation; i++) evolution.step();
  const record = evolution.record(generation);
  return { ...record, all: [...record.parents, ...record.offspring] };
}

/** @param {number} number */
const nameOf = (number) => (number < count ? `parent ${number + 1}` : `offspring ${number - count + 1}`);

/** Where each number stands: most wins first, then lower J, then lower number. @param {number[]} wins @param {number[]} costs */
const rank = (wins, costs) =>
  wins.map((_, i) => i).sort((a, b) => wins[b] - wins[a] || costs[a] - costs[b] || a - b);

/** The worst survivor and the best of the fallen, if the wrong way round. @param {ReturnType<typeof recordOf>} record */
function upsetOf({ all, survivors }) {
  const cost = (/** @type {number} */ number) => all[number].cost;
  const byCost = all.map((_, number) => number).sort((a, b) => cost(a) - cost(b));
  const survivor = byCost.filter((number) => survivors.includes(number)).at(-1) ?? -1;
  const fallen = byCost.find((number) => !survivors.includes(number)) ?? -1;
  return cost(survivor) > cost(fallen) ? { survivor, fallen } : null;
}

/** @param {string} text */
const numbersIn = (text) => text.replaceAll('−', '-').match(/-?\d+(\.\d+)?/g) ?? [];

/** That a printed number is the exact one, rounded. @param {string | undefined} printed @param {number} exact @param {string} what */
function same(printed, exact, what) {
  assert.ok(printed, what);
  const digits = printed.split('.')[1]?.length ?? 0;
  assert.ok(
    Math.abs(Number(printed) - exact) <= 0.500001 / 10 ** digits,
    `${what}: ${printed}, not ${exact}`,
  );
}

/** @param {Page} page @param {Phase} phase */
const go = (page, phase) => page.click(`#generation-phases-${phase}`);

/** Opens the part at a generation that was evolved there. @param {Page} page @param {number} generation */
async function openAt(page, generation) {
  await page.click('#page-generation');
  await page.focus('#one-generation');
  await page.press(...Array(generation).fill(Key.ENTER));
  await page.until(
    'the generation',
    (g) => document.getElementById('generation-title')?.innerText.endsWith(` ${g}`),
    generation,
  );
}

/** What the part shows once it has drawn what happened last. @param {Page} page */
const shownOn = (page) =>
  page.evaluate(async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const text = (/** @type {string} */ selector) =>
      [...document.querySelectorAll(selector)].map(
        (element) => /** @type {HTMLElement} */ (element).innerText,
      );
    const picture = /** @type {HTMLElement} */ (document.getElementById('generation-picture'));
    const phase = /** @type {HTMLInputElement} */ (
      document.querySelector('#generation-phases input:checked')
    );
    return {
      title: text('#generation-title')[0],
      phase: phase.value,
      sentence: text('#generation-sentence')[0],
      chosen: picture.getAttribute('aria-valuetext')?.split(',')[0] ?? '',
      said: picture.getAttribute('aria-valuetext') ?? '',
      headline: text('#generation-details .headline')[0],
      equations: text('#generation-details .equation'),
      common: text('#generation-details .common')[0] ?? '',
      triple: text('#generation-details .triple')[0] ?? '',
      parts: text('#generation-details .parts')[0] ?? '',
      details: text('#generation-details')[0],
      bouts: text('#generation-details .bouts li'),
      ranks: text('#generation-details .ranks li'),
      legend: text('#legend li')[0],
      rival: text('#legend .dashed')[0],
    };
  });

/** Presses the place of a mark. @param {Page} page @param {number} number */
async function press(page, number) {
  const place = await page.until(
    'the marks stand still',
    (id) => {
      const picture = document.getElementById('generation-picture');
      const mark = document.getElementById(id);
      if (!picture || !mark || picture.getAnimations({ subtree: true }).length > 0) return null;
      const [box, around] = [mark, picture].map((element) => element.getBoundingClientRect());
      return { x: box.left + box.width / 2 - around.left, y: box.top + box.height / 2 - around.top };
    },
    `individual-${number}`,
  );
  await page.drag('#generation-picture', [place]);
}

/** All rows of the table: texts by column. @param {Page} page */
async function table(page) {
  await page.click('#generation-table');
  const rows = await page.evaluate(() => {
    const texts = (/** @type {Element} */ row) =>
      [...row.children].map((cell) => /** @type {HTMLElement} */ (cell).innerText);
    const names = texts(/** @type {Element} */ (document.querySelector('#table-rows thead tr')));
    return [...document.querySelectorAll('#table-rows tbody tr')].map((row) =>
      Object.fromEntries(texts(row).map((text, i) => [names[i], text])),
    );
  });
  await page.click('#table-close');
  return rows;
}

pageTest('every number of every phase is the record of the core', async (page) => {
  await openAt(page, 4);
  const record = recordOf(4);
  const { all, mutations, opponents, wins, survivors } = record;
  const order = rank(
    wins,
    all.map(({ cost }) => cost),
  );
  for (const chosen of [6, count + 11]) {
    await go(page, 'ranking');
    await press(page, chosen);
    const pair = chosen % count;
    const [parent, child, draws] = [all[pair], all[pair + count], mutations[pair]];

    await go(page, 'parents');
    let seen = await shownOn(page);
    assert.equal(seen.chosen, nameOf(pair));
    same(numbersIn(seen.headline)[1], parent.cost, 'J of the parent');
    for (const [i, text] of seen.equations.entries())
      same(numbersIn(text)[0], i % 2 ? parent.sigmas[(i - 1) / 2] : parent.gains[i / 2], text);

    await go(page, 'mutation');
    seen = await shownOn(page);
    const [product, rate, common] = numbersIn(seen.common);
    same(common, draws.common, 'the common draw');
    same(rate, 1 / Math.sqrt(6), 'τ′');
    same(product, draws.common / Math.sqrt(6), 'τ′N');
    for (const i of [0, 1, 2]) {
      const gain = numbersIn(seen.equations[2 * i]);
      const exact = [parent.gains[i], parent.sigmas[i], draws.gains[i], child.gains[i]];
      for (const [j, printed] of gain.entries()) same(printed, exact[j], seen.equations[2 * i]);
      assert.equal(gain.length, 4);
      const sigma = numbersIn(seen.equations[2 * i + 1]);
      const tau = 1 / Math.sqrt(2 * Math.sqrt(3));
      const parts = [parent.sigmas[i], draws.common / Math.sqrt(6), tau, draws.sigmas[i], child.sigmas[i]];
      for (const [j, printed] of sigma.entries()) same(printed, parts[j], seen.equations[2 * i + 1]);
      assert.equal(sigma.length, 5);
    }

    await go(page, 'drive');
    seen = await shownOn(page);
    const run = simulate(velocityLimits, all[chosen].gains);
    assert.equal(seen.chosen, nameOf(chosen));
    assert.equal(seen.legend, `${nameOf(chosen)} of generation 4`);
    const partner = chosen < count ? chosen + count : chosen - count;
    assert.ok(seen.rival.startsWith(`${nameOf(partner)}, J ${all[partner].cost.toFixed(3)}`), seen.rival);
    same(numbersIn(seen.headline)[1], all[chosen].cost, 'J');
    assert.equal(run.cost.total, all[chosen].cost);
    for (const [i, printed] of numbersIn(seen.triple).entries())
      same(printed, all[chosen].gains[i], seen.triple);
    const { time, path, energy, finalError } = run.cost;
    for (const [i, printed] of numbersIn(seen.parts).entries())
      same(printed, [time, path, energy, finalError][i], seen.parts);
    same(String((await read(page)).finalTime), run.finalTime, 'the clock of the robots');

    await go(page, 'tournament');
    seen = await shownOn(page);
    assert.equal(seen.bouts.length, bouts);
    for (const [i, text] of seen.bouts.entries()) {
      const opponent = opponents[chosen][i];
      assert.ok(text.includes(nameOf(opponent)), text);
      same(numbersIn(text)[1], all[opponent].cost, text);
      assert.equal(text.includes('✓'), all[chosen].cost <= all[opponent].cost, text);
    }
    assert.equal(seen.bouts.filter((text) => text.includes('✓')).length, wins[chosen]);
    assert.ok(seen.headline.includes(`${wins[chosen]} wins of ${bouts}`), seen.headline);

    await go(page, 'ranking');
    seen = await shownOn(page);
    const place = order.indexOf(chosen);
    assert.ok(seen.said.includes(`${wins[chosen]} wins, rank ${place + 1} of 40`), seen.said);
    for (const text of seen.ranks) {
      const [position, , won, cost] = numbersIn(text);
      const who = order[Number(position) - 1];
      assert.ok(text.includes(nameOf(who)), text);
      assert.equal(Number(won), wins[who]);
      same(cost, all[who].cost, text);
    }

    await go(page, 'survivors');
    seen = await shownOn(page);
    const fate = survivors.indexOf(chosen);
    const expected =
      fate < 0 ? `fell: rank ${place + 1} of 40` : `survives as parent ${fate + 1} of generation 5`;
    assert.ok(seen.headline.includes(expected), seen.headline);
  }
});

pageTest('the phases add up to exactly the recorded generation', async (page) => {
  await openAt(page, 7);
  const record = recordOf(7);
  /** @type {number[]} */
  const wins = [];
  await go(page, 'tournament');
  await page.focus('#generation-picture');
  await page.press(Key.HOME);
  for (let i = 0; i < 2 * count; i++) {
    // From left to right each parent stands before its offspring.
    const number = i % 2 ? count + (i - 1) / 2 : i / 2;
    const seen = await shownOn(page);
    assert.equal(seen.chosen, nameOf(number));
    wins[number] = seen.bouts.filter((text) => text.includes('✓')).length;
    await page.press(Key.ARROW_RIGHT);
  }
  assert.deepEqual(wins, record.wins);

  await go(page, 'mutation');
  await page.focus('#generation-picture');
  await page.press(Key.HOME);
  for (let pair = 0; pair < count; pair++) {
    const { equations } = await shownOn(page);
    for (const i of [0, 1, 2]) {
      const [gain, sigma, draw, sum] = numbersIn(equations[2 * i]).map(Number);
      assert.ok(
        Math.abs(gain + sigma * draw - sum) < 0.0006 * (2 + Math.abs(draw) + sigma),
        equations[2 * i],
      );
      const [old, common, tau, own, after] = numbersIn(equations[2 * i + 1]).map(Number);
      const expected = old * Math.exp(common + tau * own);
      assert.ok(Math.abs(expected - after) < 0.0006 + 0.004 * after, equations[2 * i + 1]);
    }
    await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT);
  }

  const rows = await table(page);
  assert.equal(rows.length, 2 * count);
  const costs = [...rows].sort((a, b) => Number(a.number) - Number(b.number)).map(({ J }) => Number(J));
  const order = rank(wins, costs);
  assert.deepEqual(
    rows.map(({ number }) => Number(number)),
    order,
  );
  assert.deepEqual(order.slice(0, count), record.survivors);
  assert.deepEqual(
    rows.map(({ survives }) => survives),
    rows.map((_, i) => (i < count ? 'yes' : 'no')),
  );

  // The survivors are the parents of the next generation, in the order of their rank.
  await page.click('#one-generation');
  const next = await table(page);
  for (let i = 0; i < count; i++) {
    const parent = next.find(({ who }) => who === `parent ${i + 1}`);
    for (const column of ['kx', 'ky', 'kθ', 'σx', 'σy', 'σθ'])
      assert.equal(parent?.[column], rows[i][column]);
  }
});

pageTest('the rule of mutation stands in one line', async (page) => {
  await openAt(page, 1);
  await go(page, 'mutation');
  await shownOn(page);
  const [rule, exponent] = await page.evaluate(() =>
    ['.rule', '.rule sup'].map((selector) => {
      const { top, bottom } = /** @type {Element} */ (
        document.querySelector(`#generation-details ${selector}`)
      ).getBoundingClientRect();
      return { top, height: bottom - top };
    }),
  );
  assert.ok(rule.height < 30 && exponent.top < rule.top + rule.height / 2, JSON.stringify([rule, exponent]));
});

engineTest('any of them is chosen by a press, by keys, and by name', async (page) => {
  await openAt(page, 3);
  const record = recordOf(3);
  await go(page, 'ranking');
  for (let number = 0; number < 2 * count; number++) {
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
  await page.press(Key.HOME);
  for (const number of order) {
    assert.equal((await shownOn(page)).chosen, nameOf(number));
    await page.press(Key.ARROW_RIGHT);
  }
  await page.press(Key.ARROW_RIGHT);
  assert.equal((await shownOn(page)).chosen, nameOf(order[2 * count - 1]));

  await go(page, 'tournament');
  const opponent = record.opponents[order[2 * count - 1]][0];
  const links = await page.elements('#generation-details .bouts button');
  await links[0].click();
  assert.equal((await shownOn(page)).chosen, nameOf(opponent));
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
    const sentence = details.split('\n').find((line) => line.includes('luck')) ?? '';
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

pageTest('generation 0 has random robots only, and leads to generation 1', async (page) => {
  await page.click('#page-generation');
  const first = recordOf(0);
  const seen = await shownOn(page);
  assert.ok(seen.sentence.includes('20 robots with random gains'), seen.sentence);
  for (const phase of ['mutation', 'drive', 'tournament', 'ranking'])
    assert.equal(await (await page.element(`#generation-phases-${phase}`)).isEnabled(), false, phase);
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
  const expected = (/** @type {number} */ generation) => ({
    generation: String(generation),
    seed: '1',
    ...evolve(velocityLimits, generation).shown,
  });
  assert.deepEqual(await readEvolution(page), expected(12));
  assert.equal((await shownOn(page)).legend, 'best of generation 12');
  await page.click('#one-generation');
  assert.deepEqual(await readEvolution(page), expected(13));
});

engineTest('each phase is readable for everybody, in sight without scrolling', async (page) => {
  await page.resize(1024, 768);
  await openAt(page, 3);
  for (const phase of phases) {
    await go(page, phase);
    await shownOn(page);
    assert.deepEqual(await page.obstacles(), [], phase);
    assert.equal(await page.evaluate(() => document.documentElement.scrollHeight), 768, phase);
  }
  assert.deepEqual(await page.problems(), []);
});

/** Each method has its own phases, and none of them makes the page stumble. */
const methods = /** @type {const} */ ([
  ['evolution.method=random', ['parents', 'mutation', 'drive', 'survivors']],
  ['evolution.method=de', ['parents', 'mutation', 'drive', 'survivors']],
  ['evolution.method=cma-es', ['parents', 'mutation', 'drive', 'ranking', 'survivors']],
  ['evolution.method=one-plus-one-es', ['parents', 'mutation', 'drive', 'survivors']],
  ['evolution.method=nelder-mead', ['parents', 'mutation', 'drive', 'survivors']],
  ['evolution.method=one-at-a-time', ['parents', 'mutation', 'drive', 'survivors']],
  ['evolution.method=finite-differences', ['parents', 'mutation', 'drive', 'survivors']],
  ['evolution.selection=truncation', ['parents', 'mutation', 'drive', 'ranking', 'survivors']],
  ['evolution.crossover=1', phases],
]);

pageTest('every method of search is shown in the phases that it has', async (page) => {
  for (const [setting, own] of methods) {
    await page.open(`#generation&v=1&generation=5&${setting}&phase=parents`);
    const there = await page.evaluate(() =>
      [
        .../** @type {NodeListOf<HTMLInputElement>} */ (
          document.querySelectorAll('#generation-phases input:not(:disabled)')
        ),
      ].map(({ value }) => value),
    );
    assert.deepEqual(there, own, setting);
    for (const phase of own.slice(1)) {
      await page.click('#generation-next');
      assert.equal((await shownOn(page)).phase, phase, setting);
    }
    await page.click('#generation-next');
    assert.equal((await shownOn(page)).title, 'Generation 6', setting);
    await page.click('#generation-table');
    await page.press(Key.ESCAPE);
    assert.deepEqual(await page.problems(), [], setting);
  }
});
