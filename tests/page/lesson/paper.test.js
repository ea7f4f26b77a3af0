import assert from 'node:assert/strict';
import { paper as step } from '../../../www/lesson/steps/paper.js';
import { evolve, experiment, paperGains, simulate } from '../harness/core.js';
import { driven, opened } from './links.js';
import { test } from '../harness/once.js';

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
