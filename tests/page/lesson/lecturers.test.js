import assert from 'node:assert/strict';
import { demonstration, exam, lab } from '../../../www/lesson/steps/lecturers.js';
import { hrefOf, stepNames } from '../../../www/lesson/path.js';
import { createSets, setNames } from '../../../www/parts/training/sets.js';
import { seedCount } from '../../../www/parts/training/spread.js';
import * as en from '../../../www/lesson/words/en.js';
import * as ko from '../../../www/lesson/words/ko.js';
import { pageTest } from '../harness/browsers.js';
import {
  Evolution,
  evolve,
  experiment,
  fares,
  paperGains,
  robustness,
  simulate,
  startsOnCircle,
} from '../harness/core.js';
import { driven, opened } from './links.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../harness/core.js').Gains} Gains */

/** @param {{ items: readonly (readonly [string, string | null])[] }} sheet @param {string} name */
function linkOf({ items }, name) {
  const link = items.find(([item]) => item === name)?.[1];
  if (!link) throw new Error(`no link for ${name}`);
  return link;
}

/** The statistics of every generation that a link evolves. @param {string} link */
function historyOf(link) {
  const { experiment: own, generation } = opened(link);
  const evolution = new Evolution(own);
  const history = [evolution.statistics()];
  while (history.length <= generation) history.push(evolution.step());
  return history;
}

/** The share of starts from which gains arrive. @param {Experiment} from @param {import('../../../pkg/ep_locomotion.js').Posture[]} starts @param {Gains} gains */
function share(from, starts, gains) {
  const { arrived } = fares({ ...from, starts }, gains);
  return arrived.reduce((sum, one) => sum + one, 0) / starts.length;
}

const velocityLimits = experiment('velocity-limits');
const paperEp = simulate(velocityLimits, paperGains('velocity-limits', 'ep')).cost.total;
const sets = createSets({ startsOnCircle });

test('every item of the sheets has its words in both languages, and a link that opens', () => {
  for (const { steps } of [en, ko])
    for (const [name, { items }] of Object.entries({ demonstration, lab, exam })) {
      /** @type {any} */
      const words = steps.lecturers.sheets;
      assert.deepEqual(
        Object.keys(words[name].items),
        items.map(([item]) => item),
      );
      for (const [item, link] of items) {
        assert.ok(words[name].items[item].text && words[name].items[item].seen, `${name} ${item}`);
        if (link !== null) opened(link);
      }
    }
});

test('demonstration: the robot stops beside the goal', () => {
  const run = driven(linkOf(demonstration, 'park'));
  const last = run.x.length - 1;
  assert.equal(run.arrived, false);
  assert.ok(Math.hypot(run.x[last] - 2, run.y[last] - 2) > 0.3);
  assert.ok(Math.abs(run.linear[last - 1]) < 0.01);
});

test('demonstration: most random robots arrive, and the best beats the arbitrary gains', () => {
  const { experiment: own } = opened(linkOf(demonstration, 'random'));
  const population = new Evolution(own).population(0);
  const arrived = population.filter(({ gains }) => simulate(own, gains).arrived).length;
  assert.ok(arrived > population.length / 2);
  assert.ok(population[0].cost < driven('lab&drives=paper-arbitrary').cost.total);
});

test('demonstration: by generation 50 the best is better than the paper’s EP gains', () => {
  assert.ok((historyOf(linkOf(demonstration, 'run')).at(-1)?.best.cost ?? 9) < paperEp);
});

test('demonstration: σ shrinks by many powers of ten', () => {
  const history = historyOf(linkOf(demonstration, 'steps'));
  for (const sigma of history[history.length - 1].meanSigmas) assert.ok(sigma < 1e-7, `σ ${sigma}`);
});

test('demonstration: the champion of one start arrives from far fewer than all starts', () => {
  const { experiment: own, generation } = opened(linkOf(demonstration, 'elsewhere'));
  const { gains } = evolve(own, generation);
  const range = { from: -2, to: 6, count: 27 };
  const { arrived } = robustness(own, { gains, x: range, y: range, headings: 18 });
  assert.ok(arrived.reduce((sum, one) => sum + one, 0) / arrived.length < 0.6);
});

test('demonstration and lab: who was evolved on many starts arrives more often from unseen ones', () => {
  const { one, circle, grid, unseen } = sets(velocityLimits);
  const [fromOne, fromCircle, fromGrid] = [one, circle, grid].map((starts) =>
    share(velocityLimits, unseen, evolve({ ...velocityLimits, starts }, 100).gains),
  );
  const ep = share(velocityLimits, unseen, paperGains('velocity-limits', 'ep'));
  const arbitrary = share(velocityLimits, unseen, paperGains('velocity-limits', 'arbitrary'));
  assert.equal(setNames.length, 3);
  for (const narrow of [fromOne, ep])
    for (const wide of [fromCircle, fromGrid, arbitrary])
      assert.ok(narrow < wide, JSON.stringify({ fromOne, ep, fromCircle, fromGrid, arbitrary }));
});

test('lab: with each of 15 seeds the circle is better than one start, the grid with seed 7 the worst of all', () => {
  const { one, circle, grid, unseen } = sets(velocityLimits);
  const shareOf = (/** @type {typeof one} */ starts, /** @type {number} */ seed) => {
    const evolution = { ...velocityLimits.evolution, seed };
    return share(velocityLimits, unseen, evolve({ ...velocityLimits, starts, evolution }, 100).gains);
  };
  for (let seed = 1; seed <= seedCount; seed++)
    assert.ok(shareOf(one, seed) < shareOf(circle, seed), `seed ${seed}`);
  const worst = shareOf(grid, 7);
  assert.ok(worst < shareOf(one, 7));
  for (const method of /** @type {const} */ (['ep', 'arbitrary']))
    assert.ok(worst < share(velocityLimits, unseen, paperGains('velocity-limits', method)));
  for (const { steps } of [en, ko]) {
    const { demonstration: shown, lab: done } = steps.lecturers.sheets;
    for (const text of [shown.items.training.seen, done.items.unseen.seen])
      assert.match(text, new RegExp(`(this seed|이 시드).*(${seedCount} seeds|시드 ${seedCount}개)`));
  }
});

test('no letter of a question for an exam is written where the symbol is', () => {
  for (const { steps } of [en, ko])
    for (const { text, seen } of Object.values(steps.lecturers.sheets.exam.items))
      assert.doesNotMatch(`${text} ${seen}`.replace(/\{\w+\}/g, ''), /[xyθ]ₑ|V̇|\bk[xyθ]/);
});

test('lab: with ky = 0 the robot beside the goal does not move', () => {
  const run = driven(linkOf(lab, 'beside'));
  assert.ok(Math.max(...run.x) - Math.min(...run.x) < 1e-9);
  const other = simulate(opened(linkOf(lab, 'beside')).experiment, [3, 5, 5]);
  assert.ok(Math.max(...other.x) - Math.min(...other.x) > 0.5);
});

test('lab: when driving fast costs more, evolution chooses smaller gains and a later arrival', () => {
  const { experiment: own, generation } = opened(linkOf(lab, 'works'));
  const [usual, dear] = [velocityLimits, own].map((from) => ({
    gains: evolve(from, generation).gains,
    from,
  }));
  assert.ok(dear.gains[0] < usual.gains[0] && dear.gains[2] < usual.gains[2]);
  assert.ok(simulate(own, dear.gains).finalTime > simulate(velocityLimits, usual.gains).finalTime);
});

test('lab: five seeds agree in J within one percent, not in their gains', () => {
  const runs = [1, 2, 3, 4, 5].map((seed) => {
    const { experiment: own, generation } = opened(linkOf(lab, 'seeds').replace('seed=2', `seed=${seed}`));
    return historyOf(`lab&seed=${own.evolution.seed}&generation=${generation}`).at(-1)?.best;
  });
  const spread = (/** @type {number[]} */ values) => Math.max(...values) / Math.min(...values);
  assert.ok(spread(runs.map((best) => best?.cost ?? 0)) < 1.01);
  for (const gain of [0, 2]) assert.ok(spread(runs.map((best) => best?.gains[gain] ?? 0)) > 1.1);
  for (const best of runs) assert.ok(Math.abs(best?.gains[1] ?? 1) < 0.05);
});

test('lab: the small population needs fewer drives here', () => {
  const drives = (/** @type {number} */ population) =>
    historyOf(linkOf(lab, 'population').replace('population=6', `population=${population}`)).find(
      ({ best }) => best.cost < 7.8,
    )?.evaluations ?? Number.POSITIVE_INFINITY;
  assert.ok(drives(6) < drives(20) && drives(6) < drives(100));
  for (const [words, said] of /** @type {const} */ ([
    [en, /a hundred/],
    [ko, /백/],
  ])) {
    const { text, seen } = words.steps.lecturers.sheets.lab.items.population;
    assert.match(text, said);
    assert.match(seen, said);
  }
});

test('lab: Kanayama’s rule never turns, and nobody arrives', () => {
  const run = driven(linkOf(lab, 'kanayama'));
  assert.equal(run.arrived, false);
  assert.ok(run.angular.every((value) => value === 0));
});

test('lab: bold gains with slow wheels arrive much later', () => {
  const slow = driven(linkOf(lab, 'acceleration'));
  const quick = simulate(velocityLimits, [10, 10, 10]);
  assert.ok(slow.arrived && slow.finalTime > 2 * quick.finalTime);
});

pageTest(
  'the sheets have their links; where a class is to move sliders they are there, where it is to watch evolution its curve',
  async (page) => {
    await page.open('#lesson&step=lecturers');
    const hrefs = await page.evaluate(() =>
      [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('.sheet-link'))].map((one) => [
        one.dataset.try,
        one.getAttribute('href'),
      ]),
    );
    const number = stepNames.indexOf('lecturers') + 1;
    assert.deepEqual(
      hrefs.filter(([item]) => !item?.startsWith('plan-')),
      Object.entries({ demonstration, lab }).flatMap(([sheet, { items }]) =>
        items.map(([item, link]) => [`${sheet}-${item}`, hrefOf(String(link), number)]),
      ),
    );
    for (const [item, hasSliders] of /** @type {const} */ ([
      ['demonstration-park', true],
      ['demonstration-random', false],
      ['lab-beside', true],
      ['lab-works', false],
    ])) {
      await page.click(`[data-try="${item}"]`);
      await page.until(
        item,
        (wanted) => {
          const isSeen = (/** @type {string} */ id) =>
            document.getElementById(id)?.checkVisibility() ?? false;
          return isSeen('gains') === wanted && isSeen('curve') !== wanted;
        },
        hasSliders,
      );
    }
    // On a telephone they are the sight over the words.
    await page.resize(400, 800);
    for (const [item, chosen] of [
      ['demonstration-park', 'gains'],
      ['demonstration-random', 'part'],
    ]) {
      await page.click(`[data-try="${item}"]`);
      await page.until(item, (wanted) => document.body.dataset.sight === wanted, chosen);
    }
    assert.deepEqual(await page.problems(), []);
  },
);
