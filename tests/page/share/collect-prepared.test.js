// Links are free: a hand-in may have what its exercise locks. It is judged, and its row says what nobody could have pressed.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { createChecker } from '../../../www/share/collect/check.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { test } from '../harness/once.js';
import { engine, receipt } from './hand-ins.js';

const reader = createReader(links.pages);
const checker = createChecker(engine, links);

/** What differs of hand-ins with these links, by an exercise, or by the one that most are of. @param {readonly string[]} all @param {string | null} exercise */
async function differences(all, exercise) {
  const made = await Promise.all(all.map((link, i) => receipt(`${link}&who=s${i}`)));
  const entries = await reader.read(made.map(({ link }) => link).join('\n'));
  const options = { signal: new AbortController().signal, onProgress: () => {} };
  const { rows } = await checker.check(
    entries,
    exercise === null ? null : checker.exerciseIn(exercise),
    options,
  );
  return rows.map(({ checked }) => checked?.differs.join());
}

const aimed = '&task=Evolve.&aim=J%3C8';

test('gains that nobody could move, or let drive, are named, however they got into the link', async () => {
  const exercise = `lab&v=1&seed=7&lock=gains,drives,postures,settings,seed,parts${aimed}`;
  const changes = [
    '&generation=12',
    '&generation=5',
    '',
    '&drives=hand&gains=3.6,0.001,4.5',
    '&drives=paper-ep',
  ];
  for (const asked of [exercise, null])
    assert.deepEqual(
      await differences(
        changes.map((change) => exercise + change),
        asked,
      ),
      ['', '', '', 'drives', 'drives'],
    );
  const byHand = `lab&v=1&lock=gains,drives&drives=hand&gains=3,1,4${aimed}`;
  const moved = byHand.replace('gains=3,1', 'gains=3,0');
  // Opened by the lecturer, it is a hand-in that stands in the field.
  for (const asked of [byHand, `${moved}&who=s9`, null])
    assert.deepEqual(await differences([byHand, moved, byHand], asked), ['', 'gains', '']);
});

test('a generation that nobody could evolve is named, but not the beginning', async () => {
  const exercise = `lab&v=1&generation=3&lock=run,seed,settings${aimed}`;
  const all = [3, 3, 0, 3, 20].map((n) => exercise.replace('generation=3', `generation=${n}`));
  for (const asked of [exercise, null])
    assert.deepEqual(await differences(all, asked), ['', '', '', '', 'generation']);
});

test('what is free is no difference, however few have chosen it', async () => {
  const changes = [
    '',
    '',
    '&generation=9',
    '&drives=hand&gains=1,2,3',
    '&drives=hand&gains=3,2,1',
    '&drives=paper-ep',
  ];
  for (const [lock, last] of [
    ['seed', ''],
    ['paper', 'drives'],
    // Whoever moves a slider drives by hand, also where nobody may choose who drives.
    ['drives', 'drives'],
  ]) {
    const exercise = `lab&v=1&lock=${lock}${aimed}`;
    for (const asked of [exercise, null])
      assert.deepEqual(
        await differences(
          changes.map((change) => exercise + change),
          asked,
        ),
        ['', '', '', '', '', last],
      );
  }
});
