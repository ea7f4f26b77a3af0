// npm run lighthouse: what Lighthouse says of the built site behind a server that compresses, median of five, on a
// telephone and on a desktop, and how much a first visit loads. It times things: on a busy machine it says less.
//
//   npm run lighthouse -- [--site DIR] [--runs 5]
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { findChromium, flags } from './chromium.mjs';
import { Failure, needBuilt, npm, task } from './run.mjs';
import { serveCompressed } from './serve.mjs';

/** Fetched by npm when it is asked for: with what it needs it is larger than everything else that npm installs here. */
const lighthouse = 'lighthouse@13.5.0';
const aims = { performance: { mobile: 90, desktop: 95 }, others: 100, firstLoad: 250_000 };
const categories = /** @type {const} */ (['performance', 'accessibility', 'best-practices', 'seo']);
const forms = /** @type {const} */ (['mobile', 'desktop']);

/** @typedef {typeof forms[number]} Form */
/** @typedef {{ scores: number[], timing: { blocked: number, interactive: number } }} Result Scores in the order of the categories, from 0 to 100; milliseconds. */

/** @param {readonly number[]} values */
const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** @param {string} address @param {Form} form @returns {Promise<Result>} */
async function lookOnce(address, form) {
  const { browser } = findChromium('Lighthouse needs');
  const folder = await mkdtemp(join(tmpdir(), 'ep-locomotion-'));
  const output = join(folder, 'report.json');
  try {
    await npm(
      [
        ...['exec', '--yes', `--package=${lighthouse}`, '--', 'lighthouse', address, '--quiet'],
        ...['--output=json', `--output-path=${output}`, `--chrome-flags=${flags.join(' ')}`],
        ...[`--only-categories=${categories.join(',')}`, ...(form === 'desktop' ? ['--preset=desktop'] : [])],
      ],
      { env: { CHROME_PATH: browser } },
    );
    const { categories: found, audits } = JSON.parse(await readFile(output, 'utf8'));
    return {
      scores: categories.map((name) => Math.round(100 * found[name].score)),
      timing: {
        blocked: audits['total-blocking-time'].numericValue,
        interactive: audits.interactive.numericValue,
      },
    };
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** @param {string} site @param {number} runs @returns {Promise<string[]>} the aims that are missed */
async function lookAt(site, runs) {
  const served = await serveCompressed(site);
  /** @type {string[]} */
  const missed = [];
  try {
    for (const form of forms) {
      /** @type {Result[]} */
      const results = [];
      for (let i = 0; i < runs; i += 1) {
        served.sent.clear();
        results.push(await lookOnce(served.address, form));
        console.log(`${form}: ${results[i].scores.join(' ')}`);
      }
      for (const [i, category] of categories.entries()) {
        const score = median(results.map(({ scores }) => scores[i]));
        const aim = category === 'performance' ? aims.performance[form] : aims.others;
        console.log(`${form}, ${category}: ${score}`);
        if (score < aim) missed.push(`${category} on ${form} is ${score}, not ${aim}`);
      }
      const [blocked, interactive] = /** @type {const} */ (['blocked', 'interactive']).map((name) =>
        median(results.map(({ timing }) => timing[name])),
      );
      console.log(
        `${form}: blocked for ${blocked.toFixed(0)} ms, interactive after ${interactive.toFixed(0)} ms`,
      );
    }
    const sizes = [...served.sent].filter(([path]) => path !== '/robots.txt');
    const sum = sizes.reduce((before, [, size]) => before + size, 0);
    for (const [path, size] of sizes) console.log(`${String(size).padStart(8)} ${path}`);
    console.log(`first load: ${sum} bytes, compressed`);
    if (sum > aims.firstLoad) missed.push(`the first load is ${sum} bytes, not ${aims.firstLoad}`);
  } finally {
    await served.close();
  }
  return missed;
}

await task(async () => {
  const { values } = parseArgs({
    options: { site: { type: 'string', default: 'dist' }, runs: { type: 'string', default: '5' } },
  });
  const runs = Number(values.runs);
  if (!Number.isInteger(runs) || runs < 1)
    throw new Failure(`--runs must be a whole number from 1, not ${values.runs}`);
  const site = resolve(values.site);
  needBuilt(site);
  const missed = await lookAt(site, runs);
  if (missed.length > 0) throw new Failure(missed.join('; '));
});
