// What the example for IOHprofiler makes of the CSV of a contest.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { costAt } from '../../../www/parts/luck/contest-statistics.js';
import { contestCsv } from '../../../www/parts/luck/contest-summary.js';
import { findProgram, pythons } from '../harness/engines.js';
import { test } from '../harness/once.js';
import { small } from './contests.js';

const python = findProgram(pythons);
const needsPython = { skip: !python && 'there is no Python' };
const program = fileURLToPath(new URL('../../../examples/contest/to_iohprofiler.py', import.meta.url));

/** What the example for IOHprofiler makes of a CSV. @param {string} csv @param {number} budget @param {(ioh: string) => void} read */
function withExample(csv, budget, read) {
  const folder = mkdtempSync(join(tmpdir(), 'contest-'));
  try {
    const [from, ioh] = [join(folder, 'contest.csv'), join(folder, 'ioh')];
    writeFileSync(from, csv);
    execFileSync(/** @type {string} */ (python), [program, from, ioh, `${budget}`], { stdio: 'pipe' });
    assert.equal(readFileSync(from, 'utf8'), csv);
    read(ioh);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test(
  'the example for IOHprofiler writes every run with all its rows, from drive 1 to the budget',
  needsPython,
  () =>
    withExample(contestCsv(small), 1000, (ioh) => {
      for (const { name, trials: runs } of small.lines) {
        const own = join(ioh, name ?? 'lab');
        const told = JSON.parse(readFileSync(join(own, 'IOHprofiler_f1_J.json'), 'utf8'));
        assert.equal(told.algorithm.name, name ?? 'lab');
        const [{ path, runs: listed }] = told.scenarios;
        assert.deepEqual(
          listed.map((/** @type {any} */ { instance, evals, best }) => [instance, evals, best.y]),
          runs.map(({ seed, champion }) => [seed, 1000, champion.cost]),
        );
        const blocks = readFileSync(join(own, path), 'utf8').split('evaluations raw_y\n').slice(1);
        for (const [i, { drives, costs }] of runs.entries()) {
          const rows = blocks[i].trimEnd().split('\n');
          const falls = [...drives].map((drive, j) => `${drive} ${costs[j]}`);
          assert.deepEqual(rows.slice(0, falls.length), falls);
          assert.equal(rows[0].split(' ')[0], '1');
          assert.equal(rows.at(-1), `1000 ${costs.at(-1)}`);
        }
      }
    }),
);

/** The aligned CSV: of each contestant and seed the drives with their J. @param {string} ioh */
function alignedOf(ioh) {
  const [header, ...rows] = readFileSync(`${ioh}-aligned.csv`, 'utf8').trimEnd().split('\r\n');
  assert.equal(header, 'drive,J,function,contestant,dimension,seed');
  /** @type {Record<string, number[][]>} */
  const runs = {};
  for (const row of rows) {
    const [drive, cost, name, contestant, dimension, seed] = row.split(',');
    assert.deepEqual([name, dimension], ['J', '3']);
    runs[`${contestant} ${seed}`] ??= [];
    runs[`${contestant} ${seed}`].push([Number(drive), cost === 'Inf' ? Infinity : Number(cost)]);
  }
  return runs;
}

test(
  'in its aligned CSV all runs of a contestant have the same drives, each with its best J until then',
  needsPython,
  () =>
    withExample(contestCsv(small), 1000, (ioh) => {
      const aligned = alignedOf(ioh);
      const names = small.lines.flatMap(({ name, trials: runs }) =>
        runs.map(({ seed }) => `${name ?? 'lab'} ${seed}`),
      );
      assert.deepEqual(Object.keys(aligned), names);
      for (const { name, trials: runs } of small.lines) {
        const all = new Set([...runs.flatMap((run) => [...run.drives]), 1000]);
        const drives = [...all].sort((a, b) => a - b);
        for (const run of runs) {
          const expected = drives.map((drive) => [drive, costAt(run, drive)]);
          assert.deepEqual(aligned[`${name ?? 'lab'} ${run.seed}`], expected);
        }
      }
    }),
);

test(
  'a run without a J yet stands at infinity there, and no J may fall after the budget',
  needsPython,
  () => {
    const csv = 'contestant,seed,drive,J\r\nlab,1,1,9\r\nlab,1,5,3\r\nlab,2,4,8\r\nlab,2,6,2\r\n';
    withExample(csv, 7, (ioh) =>
      assert.deepEqual(alignedOf(ioh), {
        'lab 1': [9, 9, 3, 3, 3].map((cost, i) => [[1, 4, 5, 6, 7][i], cost]),
        'lab 2': [Infinity, 8, 8, 2, 2].map((cost, i) => [[1, 4, 5, 6, 7][i], cost]),
      }),
    );
    assert.throws(() => withExample(csv, 5, () => {}), /fell at drive 6: the budget is not 5/);
  },
);

test('the example for IOHprofiler says in a sentence what is wrong with how it is used', needsPython, () => {
  const folder = mkdtempSync(join(tmpdir(), 'contest-'));
  const wrong = join(folder, 'wrong.csv');
  try {
    const usage = /^usage: python to_iohprofiler\.py contest\.csv contest-ioh 4000\n$/;
    const noContest =
      /^.+ is not the CSV of a contest, which has the columns contestant, seed, drive and J\.\n$/;
    for (const [csv, given, said] of /** @type {const} */ ([
      ['', [], usage],
      ['', [wrong], usage],
      ['', [wrong, 'ioh', 'many'], usage],
      ['', [join(folder, 'absent.csv'), 'ioh', '4000'], /^.+absent\.csv cannot be read: .+\.\n$/],
      ['', [wrong, 'ioh', '4000'], noContest],
      ['generation,best\n1,2\n', [wrong, 'ioh', '4000'], noContest],
      ['contestant,seed,drive,J\nlab,1,one,9\n', [wrong, 'ioh', '4000'], noContest],
      ['contestant,seed,drive,J\nlab,one,1,9\n', [wrong, 'ioh', '4000'], noContest],
      ['contestant,seed,drive,J\nlab,1,1\n', [wrong, 'ioh', '4000'], noContest],
      // It writes into its own folder alone.
      ['contestant,seed,drive,J\n../lab,1,1,9\n', [wrong, 'ioh', '4000'], noContest],
      ['contestant,seed,drive,J\n..,1,1,9\n', [wrong, 'ioh', '4000'], noContest],
      ['\u0000\u0001', [wrong, 'ioh', '4000'], noContest],
    ])) {
      writeFileSync(wrong, csv);
      const { status, stderr } = spawnSync(/** @type {string} */ (python), [program, ...given], {
        cwd: folder,
        encoding: 'utf8',
      });
      assert.equal(status, 1);
      assert.match(stderr.replaceAll('\r', ''), said);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
