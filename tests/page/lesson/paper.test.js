import assert from 'node:assert/strict';
import { asPrinted } from '../../../www/lesson/printed.js';
import { foundBy } from '../../../www/lesson/views/paper-table.js';
import { paper as en } from '../../../www/lesson/words/en/paper.js';
import { paper as ko } from '../../../www/lesson/words/ko/paper.js';
import { costText } from '../../../www/words/en/numbers.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { evolve, experiment, paper, paperGains, simulate } from '../harness/core.js';
import { engine } from './links.js';
import { answered, liveOf, toldBy } from './live.js';
import { driven, opened } from './links.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { holdWorkers } from '../harness/workers.js';
import { follow } from '../whole/surround.js';

const step = stepOf('paper');

const presets = /** @type {const} */ (['velocity-limits', 'acceleration-limits']);
const triesOf = step.blocks.flatMap((block) => (block.kind === 'tries' ? block.tries : []));
/** @param {string} name */
const linkOf = (name) => triesOf.find(([key]) => key === name)?.[1] ?? '';

test('the evolved gains are better than the arbitrary ones, with both kinds of limits', () => {
  for (const preset of presets) {
    const [ep, arbitrary] = /** @type {const} */ (['ep', 'arbitrary']).map((method) =>
      simulate(experiment(preset), paperGains(preset, method)),
    );
    assert.ok(ep.arrived && ep.cost.total < arbitrary.cost.total, preset);
    assert.equal(arbitrary.arrived, preset === 'velocity-limits', preset);
  }
});

test('our evolution finds kx and kθ of a similar size, and ky near zero', () => {
  for (const preset of presets) {
    const [kx, ky, ktheta] = evolve(experiment(preset), 200).gains;
    const [paperKx, , paperKtheta] = paperGains(preset, 'ep');
    for (const [ours, papers] of [
      [kx, paperKx],
      [ktheta, paperKtheta],
    ])
      assert.ok(ours / papers > 0.6 && ours / papers < 1.5, `${preset}: ${ours} and ${papers}`);
    assert.ok(Math.abs(ky) < 0.05, `${preset}: ky ${ky}`);
  }
});

test('with a fixed time of 3 s evolution finds another kx', () => {
  const { experiment: fixedTime, generation } = opened(linkOf('horizon'));
  const [kx] = evolve(fixedTime, generation).gains;
  assert.ok(kx < 0.6 * paperGains('velocity-limits', 'ep')[0], `kx ${kx}`);
  assert.equal(driven(linkOf('horizon')).finalTime, 3);
});

test('with energy at a tenth the same 3 s give a kx near the paper’s: nothing follows about how its drives ended', () => {
  const { experiment: fixedTime, generation } = opened(linkOf('shortCheap'));
  const [kx] = evolve(fixedTime, generation).gains;
  assert.ok(Math.abs(kx - 2.9) < 0.05 && kx / paperGains('velocity-limits', 'ep')[0] > 0.85, `kx ${kx}`);
});

test('taken literally, with the commanded velocity, J is what the page says', async () => {
  const printed = paper().map((_, row) => asPrinted({ engine, paper: paper() }, row));
  assert.deepEqual(
    printed.map((cost) => Number(cost.toPrecision(3))),
    [24.6, 209, 132, 4.32e7],
  );
  const { outcome } = await answered('paper', 'literal');
  assert.deepEqual([outcome.right, outcome.literal], [2, printed[1]]);
});

test('what J would be as printed is told only after the question that asks it', async () => {
  const { printed } = await toldBy(step, liveOf(step.link));
  assert.equal(printed.split('; ')[1], costText(asPrinted({ engine, paper: paper() }, 1)));
  for (const { texts } of [en, ko]) {
    const telling = Object.entries(texts).filter(([, text]) => text.includes('{=printed}'));
    assert.equal(telling.length, 1);
    for (const [name] of telling)
      assert.deepEqual(
        step.blocks.flatMap((block) => (block.kind === 'text' && block.name === name ? block.after : [])),
        ['literal'],
      );
  }
});

test('in degrees the path alone costs more than the printed J, in the other order', () => {
  const pathOf = (/** @type {'ep' | 'arbitrary'} */ method) => {
    const { goal, sampleTime } = experiment('velocity-limits');
    const run = simulate(experiment('velocity-limits'), paperGains('velocity-limits', method));
    const turned = (/** @type {number} */ theta) => ((goal.theta - theta) * 180) / Math.PI;
    return Array.from(run.x.slice(0, -1)).reduce(
      (sum, x, i) =>
        sum + 0.5 * sampleTime * ((x - goal.x) ** 2 + (run.y[i] - goal.y) ** 2 + turned(run.theta[i]) ** 2),
      0,
    );
  };
  assert.deepEqual(
    [pathOf('ep'), pathOf('arbitrary')].map((cost) => cost.toFixed(1)),
    ['103.9', '62.8'],
  );
});

test('the gains of Figure 6(a) arrive at 1.25 m/s, overshoot by 11 cm, stay from 2.07 s on, and are slow at 2.35 s', () => {
  const arriving = simulate(experiment('acceleration-limits'), paperGains('acceleration-limits', 'ep'));
  assert.ok(Math.abs((arriving.linear.at(-1) ?? 0) - 1.25) < 0.005);
  const { time, x, y, theta, finalTime, cost } = driven(linkOf('speed'));
  const away = Array.from(time, (_, i) => Math.hypot(x[i] - 2, y[i] - 2));
  const after = away.filter((_, i) => time[i] > arriving.finalTime);
  assert.ok(Math.abs(Math.max(...after) - 0.11) < 0.005);
  const outside = Array.from(time).filter(
    (_, i) => away[i] > 0.05 || Math.abs(theta[i] - Math.PI / 4) > 0.05,
  );
  assert.ok(Math.abs(Math.max(...outside) - 2.06) < 1e-9);
  assert.deepEqual(
    [arriving.finalTime, arriving.cost.total, finalTime, cost.total].map((value) => value.toFixed(3)),
    ['1.640', '8.271', '2.350', '9.060'],
  );
});

test('heavier weights change J, not the drive', () => {
  const heavier = driven(linkOf('weights'));
  const usual = driven('lab&drives=paper-ep');
  assert.deepEqual([...heavier.x], [...usual.x]);
  assert.ok(heavier.cost.total > usual.cost.total);
});

test('in Figure 7 the arbitrary gains swing beyond 60° here', () => {
  const { theta } = driven(linkOf('figure7'));
  assert.ok((Math.max(...theta) * 180) / Math.PI > 90);
});

pageTest('who stands in the table stays there when what evolution finds has come', async (page) => {
  await page.open('#lesson');
  await page.evaluate(() => {
    new MutationObserver(() => {
      const box = /** @type {HTMLElement | null} */ (document.querySelector('#paper-table .lesson-scroll'));
      if (document.activeElement === document.body && box?.textContent?.includes('…')) box.focus();
    }).observe(document.body, { childList: true, subtree: true, attributes: true });
    location.hash = 'lesson&step=paper';
  });
  const allAreThere = () =>
    page.until(
      'all numbers are there',
      () => document.querySelector('#paper-table table')?.textContent?.includes('…') === false,
    );
  await allAreThere();
  assert.equal(await page.evaluate(() => document.activeElement?.className), 'lesson-scroll');
  // At the next visit nothing is evolved again.
  await holdWorkers(page);
  await follow(page, 'lesson&v=1&step=law');
  await follow(page, 'lesson&v=1&step=paper');
  await allAreThere();
});

test('what evolution finds beside the paper’s gains is asked for once, and anew where it could not be found', async () => {
  let asked = 0;
  const surveys = {
    evolveAll: () => (++asked === 1 ? Promise.reject(new Error('lost')) : Promise.resolve([])),
  };
  const own = /** @type {any} */ ({ experiment: (/** @type {string} */ preset) => preset, surveys });
  await assert.rejects(foundBy(own), /lost/);
  assert.equal(await foundBy(own), await foundBy(own));
  assert.equal(asked, 2);
});
