// Links and files that nobody has written, by the million: whatever they say, they are opened or refused, and never worse.
//
//   npm run fuzz -- 1000000 [seed]   so many links, a hundredth as many experiments and files; what fails is told with its seed, made small
//
// What has once failed belongs into corpus/, with which every test begins and from which half of the texts are bred.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { isDeepStrictEqual } from 'node:util';
import fc from 'fast-check';
import { isProgram } from '../../../.tasks/run.mjs';
import { openRunFile, runFile } from '../../../www/share/run-file.js';
import { links as pageLinks } from '../../../www/lesson/links.js';
import { mostCharacters } from '../../../www/link/values.js';
import { places } from '../../../www/parts/parts.js';
import { isEmpty } from '../../../www/run/exercise.js';
import { experiment, paper, simulateAll } from '../harness/core.js';
import { anyExperiment, linkText, mutated } from './arbitrary.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../../../www/core/engine.js').Engine} Engine */
/** @typedef {ReturnType<typeof openLink>['opened']} Opened */

/** One text a line. @param {string} name */
const corpus = (name) =>
  readFileSync(new URL(`corpus/${name}`, import.meta.url), 'utf8')
    .split('\n')
    .slice(0, -1);
export const links = corpus('links.txt');
export const files = corpus('files.txt');

/** What stands for a run's fingerprint here: the parsing is what is tried, not evolution. @param {Experiment} from @param {number} generations */
const hashOf = (from, generations) => `${generations} of ${JSON.stringify(from)}`;

/** The presets are asked for often. Nobody may change them. */
const presets = new Map(
  /** @type {const} */ (['velocity-limits', 'acceleration-limits']).map((name) => [
    name,
    frozen(experiment(name)),
  ]),
);

/** @template T @param {T} value */
function frozen(value) {
  if (value !== null && typeof value === 'object') Object.values(value).forEach(frozen);
  return Object.freeze(value);
}

const engine = /** @type {Engine} */ (
  /** @type {unknown} */ ({
    experiment: (/** @type {any} */ given) => presets.get(given) ?? experiment(given),
    paper,
    // Whether gains can be driven shows at the first sample.
    check: (/** @type {Experiment} */ from, /** @type {readonly number[]} */ gains) =>
      simulateAll({ ...from, horizon: from.sampleTime }, [...gains]),
    surveys: {
      evolve: async (/** @type {Experiment} */ from, /** @type {number} */ generations) => ({
        hash: hashOf(from, generations),
        history: { best: Array(generations + 1).fill(1), median: Array(generations + 1).fill(1) },
        leader: { gains: [1, 1, 1], cost: 1 },
      }),
      costs: async (/** @type {unknown[]} */ robots) => robots.map(() => 1),
    },
  })
);

const { linkOf, openLink } = pageLinks;

/** @param {Opened} opened */
const linkAgain = ({ parts, ...run }) => linkOf({ ...run, slices: parts }, engine.experiment);

/** No text takes longer than a reader notices; far more than any takes, for machines are busy. */
const mostMilliseconds = 3000;

/** Any text is opened, what is wrong with it is told, and what came of it has a link that gives back the same. @param {string} link */
export function checkLink(link) {
  const start = performance.now();
  const { opened, problems } = openLink(link, engine);
  const milliseconds = performance.now() - start;
  assert.ok(milliseconds < mostMilliseconds, `opened in ${milliseconds} ms`);
  assert.ok(problems.every((problem) => typeof problem === 'string' && problem !== ''));
  const written = linkAgain(opened);
  // Thousands of starts can make a link longer than any that is read.
  if (written.length > mostCharacters) return;
  const again = openLink(written, engine);
  assert.deepEqual(again.problems, [], written);
  assert.equal(linkAgain(again.opened), written);
  // What is tried is in the links of the parts that try it only, the sliders of Park in its own, and who works on it in those of exercises.
  const { page, trial, exercise, student } = opened;
  const { park, ...others } = opened.parts;
  const kept = {
    ...opened,
    parts: page === 'park' ? opened.parts : others,
    student: { ...student, who: isEmpty(exercise) ? '' : student.who },
    trial: {
      start: places.triesStarts(page) ? trial.start : null,
      disturbance: places.triesDisturbance(page) ? trial.disturbance : null,
    },
  };
  if (!isDeepStrictEqual(again.opened, kept)) assert.deepEqual(again.opened, kept, written);
}

/** Any text is opened as a run, or refused with a reason for the reader. @param {string} text */
export async function checkFile(text) {
  const opened = await openRunFile(text, engine, pageLinks).catch((error) => {
    // Any other kind is a mistake of ours.
    assert.equal(error.constructor, Error, String(error.stack));
    assert.match(error.message, /\w/);
  });
  if (opened) checkLink(linkAgain(opened.opened));
}

/** Every experiment has a link, and comes back from it, alone and pinned. @param {Experiment} one */
function checkExperiment(one) {
  const { opened } = openLink('lab', engine);
  const pinned = { slot: 1, name: 'mine', experiment: one, gains: /** @type {const} */ ([1, 0.1, 5]) };
  const link = linkAgain({ ...opened, experiment: one, pins: [pinned] });
  const again = openLink(link, engine);
  assert.deepEqual(again.problems, [], link);
  assert.deepEqual([again.opened.experiment, again.opened.pins], [one, [pinned]]);
}

const anyLink = mutated(fc.oneof(linkText, fc.constantFrom(...links)));

/** A run's file, as the page writes it. @param {string} link @param {number} generations */
function fileOf(link, generations) {
  const { opened } = openLink(link, engine);
  const best = { gains: [1, 1, 1], cost: 1 };
  const history = Array.from({ length: generations + 1 }, (_, generation) => ({
    generation,
    best,
    median: 1,
  }));
  const { parts, ...run } = { ...opened, generation: Math.min(opened.generation, generations) };
  return runFile(
    /** @type {any} */ ({ ...run, slices: parts, history }),
    {
      ...engine,
      version: () => '0.1.0',
      hash: () => hashOf(opened.experiment, generations),
    },
    pageLinks,
    { gains: opened.driver === 'hand' && opened.handGains ? opened.handGains : [1, 1, 1], cost: 1 },
  );
}
/** With another value of one of its fields, or without it. */
const changedFile = fc
  .tuple(
    fc.oneof({ weight: 9, arbitrary: fc.constantFrom(...links) }, { weight: 1, arbitrary: linkText }),
    fc.nat(3),
    fc.constantFrom(
      'format',
      'version',
      'link',
      'hash',
      'generations',
      'statistics',
      'experiment',
      'drive',
      '__proto__',
      'toString',
    ),
    fc.oneof(fc.jsonValue(), anyLink, fc.constant(undefined), fc.constant({ toString: 1, valueOf: null })),
  )
  .map(([link, generations, name, value]) => {
    const fields = Object.entries(JSON.parse(fileOf(link, generations))).filter(([key]) => key !== name);
    const all = value === undefined ? fields : [...fields, [name, value]];
    return `{${all.map(([key, content]) => `${JSON.stringify(key)}: ${JSON.stringify(content)}`).join(', ')}}`;
  });
const anyFile = fc.oneof(
  changedFile,
  mutated(fc.constantFrom(...links).map((link) => fileOf(link, 2))),
  mutated(fc.constantFrom(...files)),
);

/** Tries so many links and a hundredth as many experiments and files. @param {number} count @param {number} seed */
export async function fuzz(count, seed) {
  const usual = openLink('', engine);
  fc.assert(fc.property(anyLink, checkLink), { numRuns: count, seed });
  fc.assert(fc.property(anyExperiment, checkExperiment), { numRuns: Math.ceil(count / 100), seed });
  // That of a run is opened as long as nobody has changed it.
  await openRunFile(fileOf('lab', 2), engine, pageLinks);
  await fc.assert(fc.asyncProperty(anyFile, checkFile), { numRuns: Math.ceil(count / 100), seed });
  // What went before has left no trace.
  assert.deepEqual(openLink('', engine), usual);
}

if (isProgram(import.meta.url)) {
  const [count, seed] = [process.argv[2] ?? 100_000, process.argv[3] ?? Date.now() % 2 ** 31].map(Number);
  if (!(count >= 1)) throw new Error(`the number of links must be 1 or more, not ${process.argv[2]}`);
  if (!Number.isInteger(seed)) throw new Error(`the seed must be a whole number, not ${process.argv[3]}`);
  console.log(`${count} links, ${Math.ceil(count / 100)} experiments and files, seed ${seed}`);
  const start = performance.now();
  await fuzz(count, seed);
  const seconds = (performance.now() - start) / 1000;
  console.log(`nothing failed in ${seconds.toFixed(0)} s: ${Math.round((1.02 * count) / seconds)} a second`);
}
