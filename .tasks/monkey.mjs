// npm run monkey -- [rounds] [first seed]: rounds of a hundred random actions on the built page, in every engine of this
// machine, or in those that ENGINES names. What fails is told with its seed.
import { parseArgs } from 'node:util';
import { join } from 'node:path';
import { findEngines } from '../tests/page/harness/engines.js';
import { Failure, needBuilt, run, task, top } from './run.mjs';

await task(async () => {
  const { positionals } = parseArgs({ allowPositionals: true });
  const [rounds = '20', seed = String(1 + Math.floor(Math.random() * 1e6))] = positionals;
  if (!/^[1-9]\d*$/.test(rounds)) throw new Failure(`rounds must be a whole number from 1, not ${rounds}`);
  if (!/^\d+$/.test(seed)) throw new Failure(`the first seed must be a whole number, not ${seed}`);
  const { found, absent } = findEngines();
  if (found.length === 0)
    throw new Failure(`there is no browser: ${absent.map(({ hint }) => hint).join('; ')}`);
  needBuilt(join(top, 'dist'));
  console.log(`${rounds} rounds from seed ${seed}`);
  await run(
    process.execPath,
    ['--test-reporter=spec', 'tests/page/harness/every.js', 'whole/monkey.test.js'],
    {
      env: { PAGE_TESTS: 'engine', MONKEY_ROUNDS: rounds, MONKEY_SEED: seed },
    },
  );
});
