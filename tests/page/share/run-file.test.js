import assert from 'node:assert/strict';
import { openRunFile, runFile, textOfRun } from '../../../www/share/run-file.js';
import { links } from '../../../www/lesson/links.js';
import { lastGeneration } from '../../../www/run/pace.js';
import { withDisturbance } from '../../../www/run/scene.js';
import { evaluate, Evolution, experiment, paper, simulateAll } from '../harness/core.js';
import { test } from '../harness/once.js';
import { evolved } from './evolved.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('./evolved.js').Kept} Kept */

const velocityLimits = experiment('velocity-limits');

test('a file holds the run: opened again it is the same', async () => {
  const { engine, state } = evolved(experiment({ evolution: { seed: 9 } }), 5);
  const { opened, generations } = await openRunFile(runFile(state, engine, links), engine, links);
  assert.equal(generations, 5);
  assert.equal(opened.generation, 3);
  assert.deepEqual(opened.experiment, state.experiment);
});

/** What drives, as Share gives it to the file. @param {Experiment} from @param {number[]} gains */
const driveOf = (from, gains) => ({
  gains: /** @type {const} */ ([gains[0], gains[1], gains[2]]),
  cost: simulateAll(from, gains)[0].cost.total,
});

test('the drive comes out as it was saved, whoever drives, and from wherever a part tries it', async () => {
  const starts = [velocityLimits.starts[0], { x: -1, y: 0, theta: 0 }];
  const { engine, state } = evolved(experiment({ starts, evolution: { population: 8 } }), 4);
  const start = { x: -1.5, y: 1, theta: 1 };
  const slip = /** @type {const} */ ({ kind: 'slip', linear: 0.1, angular: 0.2, seed: 1 });
  const hand = /** @type {const} */ ([3.0594, 0.0001, 4.1385]);
  const ep = paper().find((row) => row.preset === 'velocity-limits' && row.method === 'ep');
  const rows = [
    { ...state, drive: driveOf(state.experiment, state.history[3].best.gains) },
    { ...state, driver: 'paper-ep', drive: driveOf(state.experiment, ep?.gains ?? []) },
    { ...state, driver: 'hand', handGains: hand, drive: driveOf(state.experiment, [...hand]) },
    // It never arrives, and cannot be driven to an end that has a J.
    {
      ...state,
      driver: 'hand',
      handGains: [1e6, 1e6, -1e6],
      drive: driveOf(state.experiment, [1e6, 1e6, -1e6]),
    },
    {
      ...state,
      page: 'robustness',
      trial: { start, disturbance: null },
      drive: driveOf({ ...state.experiment, starts: [start] }, state.history[3].best.gains),
    },
    {
      ...state,
      page: 'disturbance',
      trial: { start: null, disturbance: slip },
      drive: driveOf({ ...state.experiment, ...withDisturbance(slip) }, state.history[3].best.gains),
    },
  ];
  for (const { drive, ...row } of rows) {
    const text = runFile(/** @type {Kept} */ (row), engine, links, drive);
    const { hasDrive } = await openRunFile(text, engine, links);
    assert.ok(hasDrive, row.driver);
    // What a program finds that reads the file, as docs/python.md says.
    const told = JSON.parse(text).drive;
    assert.equal(evaluate(told.experiment, told.gains)[0], drive.cost, row.page);
  }
  assert.equal((await openRunFile(runFile(state, engine, links), engine, links)).hasDrive, false);
});

test('of a method that forgets the file tells who drives, and not the best so far', async () => {
  for (const evolution of /** @type {const} */ ([
    { method: 'random' },
    { method: 'cma-es' },
    { method: 'finite-differences', seed: 9 },
  ])) {
    const { engine, state } = evolved(experiment({ evolution }), 12);
    const again = new Evolution(state.experiment);
    again.step(12);
    const leaderOf = (/** @type {number} */ generation) => again.population(generation)[0].gains;
    const isLost = (/** @type {import('./evolved.js').Kept['history'][number]} */ { generation, best }) =>
      String(leaderOf(generation)) !== String(best.gains);
    const { generation } = state.history.find(isLost) ?? assert.fail(`${evolution.method} forgets nothing`);
    const drive = driveOf(state.experiment, [...leaderOf(generation)]);
    const text = runFile({ ...state, generation }, engine, links, drive);
    assert.ok((await openRunFile(text, engine, links)).hasDrive, evolution.method);
  }
});

test('a file whose drive is another than it says is refused', async () => {
  const { engine, state } = evolved(velocityLimits, 4);
  const other = structuredClone(state);
  other.history[3].best.gains = [3, 1, 5];
  const both = runFile(other, engine, links, driveOf(velocityLimits, [3, 1, 5]));
  await assert.rejects(openRunFile(both, engine, links), { message: /drives with the gains \[3,1,5\]/ });
  const { gains } = state.history[3].best;
  const good = JSON.parse(runFile(state, engine, links, driveOf(velocityLimits, gains)));
  const rows = /** @type {const} */ ([
    [
      { link: `${good.link}&drives=hand&gains=3.0594,0.0001,4.1385` },
      /drives with \[3\.0594,0\.0001,4\.1385\]/,
    ],
    [{ link: `${good.link}&drives=paper-ep` }, /with the gains \[.*, but it drives with/],
    [{ link: `${good.link.replace('lab', 'robustness')}&from=-1,1,1` }, /J of its drive/],
    [{ drive: { ...good.drive, cost: 1 } }, /J of its drive is 1, but/],
    [{ drive: { ...good.drive, cost: null } }, /J of its drive is null, but/],
    [{ drive: { ...good.drive, gains: [1, 2, { toString: 1 }] } }, /with the gains/],
    [{ drive: null }, /drive/],
    [{ drive: { ...good.drive, experiment: experiment({ horizon: 9 }) } }, /drive\.experiment in it is not/],
  ]);
  // As older versions of the page wrote it.
  const { experiment: _, ...old } = good.drive;
  assert.ok((await openRunFile(JSON.stringify({ ...good, drive: old }), engine, links)).hasDrive);
  for (const [change, reason] of rows)
    await assert.rejects(openRunFile(JSON.stringify({ ...good, ...change }), engine, links), {
      message: reason,
    });
});

test('a file that is damaged or foreign is refused with the reason', async () => {
  const { engine, state } = evolved(velocityLimits, 4);
  const good = JSON.parse(runFile(state, engine, links));
  const rows = /** @type {const} */ ([
    ...['', '{', 'null', '[1, 2]'].map((text) => /** @type {const} */ ([text, /no run/])),
    [JSON.stringify({ ...good, format: 'other' }), /no run/],
    [JSON.stringify({ ...good, version: 2 }), /version 2.*version 1/],
    [JSON.stringify({ ...good, link: 5 }), /link, hash/],
    [JSON.stringify({ ...good, link: 'lab&goal.x=1e9' }), /goal\.x/],
    [JSON.stringify({ ...good, generations: -1 }), /generations/],
    [JSON.stringify({ ...good, generations: 1e9 }), /generations/],
    [JSON.stringify({ ...good, generations: 2 }), /generations/],
    [
      JSON.stringify({
        ...good,
        generations: lastGeneration + 1,
        statistics: Array(lastGeneration + 2).fill(0),
      }),
      /generations/,
    ],
    [JSON.stringify({ ...good, link: good.link.replace('lab', 'lab&seed=2') }), /was changed/],
    [JSON.stringify({ ...good, experiment: { ...good.experiment, horizon: 9 } }), /experiment in it is not/],
    [
      JSON.stringify({ ...good, statistics: good.statistics.with(2, { ...good.statistics[2], median: 1 }) }),
      /statistics in it is not/,
    ],
    [runFile(state, engine, links).slice(0, 300), /its end is missing/],
  ]);
  for (const [text, reason] of rows)
    await assert.rejects(openRunFile(text, engine, links), { message: reason }, text.slice(0, 60));
});

test('what is too large for a run is not read', async () => {
  const text = async () => assert.fail('it was read');
  await assert.rejects(textOfRun({ size: 150_000_001, text }), { message: /too large/ });
  assert.equal(await textOfRun(new Blob(['실험'])), '실험');
  const { engine } = evolved(velocityLimits, 0);
  await assert.rejects(openRunFile(' '.repeat(50_000_001), engine, links), { message: /too large/ });
});
