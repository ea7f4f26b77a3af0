// npm run pictures: pictures of the built page in every state, and what differs between two such rows of pictures.
//
//   npm run pictures -- OUT                      takes them, of the site in dist/
//   npm run pictures -- OUT --site DIR           of another built site
//   npm run pictures -- OUT --only lesson        only those whose names contain this
//   npm run pictures -- --compare BEFORE AFTER   lists what differs, and shows it in target/pictures/
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { serve } from '../tests/page/harness/server.js';
import { createCamera } from './pictures/camera.js';
import { compareFolders } from './pictures/compare.js';
import { nameOf, views } from './pictures/states.js';
import { Failure, needBuilt, task } from './run.mjs';

const output = join('target', 'pictures');

/** @param {string} folder @param {string} site @param {string} only */
async function takeAll(folder, site, only) {
  needBuilt(site);
  mkdirSync(folder, { recursive: true });
  const before = readFileSync(new URL('pictures/rest.js', import.meta.url), 'utf8');
  const served = await serve(resolve(site), { before });
  const { port, pathname } = new URL(served.address);
  // Links are on the pictures, and must not have the port of this time.
  const address = `http://localhost${pathname}`;
  const start = performance.now();
  const wanted = views.filter((view) => nameOf(view).includes(only));
  const left = [...wanted];
  let failed = 0;

  /** Takes what is left, one picture after the other. */
  async function takeSome() {
    const camera = await createCamera('localhost', Number(port));
    for (let view = left.shift(); view; view = left.shift()) {
      const name = nameOf(view);
      try {
        writeFileSync(join(folder, `${name}.png`), await camera.picture(address, view));
      } catch (error) {
        failed += 1;
        console.error(`✗ ${name}: ${error instanceof Error ? error.message : error}`);
      }
    }
    await camera.close();
  }

  // Each waits for its page most of the time.
  await Promise.all([takeSome(), takeSome()]).finally(() => served.close());
  const seconds = ((performance.now() - start) / 1000).toFixed(0);
  console.log(`${wanted.length - failed} pictures in ${folder}, ${seconds} s`);
  if (failed > 0) throw new Failure(`${failed} pictures could not be taken`);
}

/** @param {string} before @param {string} after */
function compare(before, after) {
  for (const folder of [before, after]) if (!existsSync(folder)) throw new Failure(`${folder} is not there`);
  rmSync(output, { recursive: true, force: true });
  const { same, differences } = compareFolders(before, after, output);
  for (const { name, said } of differences) console.log(`${name}: ${said}`);
  console.log(`${same} pictures are the same, ${differences.length} differ`);
  if (differences.length > 0)
    throw new Failure(`what differs is in ${output}: before, after, and the differences`);
}

await task(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      compare: { type: 'boolean', default: false },
      site: { type: 'string', default: 'dist' },
      only: { type: 'string', default: '' },
    },
  });
  if (positionals.length !== (values.compare ? 2 : 1))
    throw new Failure('npm run pictures -- OUT [--site DIR], or -- --compare BEFORE AFTER');
  if (values.compare) compare(positionals[0], positionals[1]);
  else await takeAll(positionals[0], values.site, values.only);
});
