// What a call from JavaScript costs beside the drives that it asks for: reading the experiment, giving back a run.
import { existsSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

/** @typedef {typeof import('../pkg/ep_locomotion.js')} Core */
/** @typedef {{ least: number, median: number }} Time Microseconds. */

const gains = Float64Array.of(3.23673, 0.09678, 5.17891);

/** The core that is built in a folder. @param {string} folder @returns {Promise<Core>} */
async function load(folder) {
  /** @type {Core} */
  const core = await import(pathToFileURL(resolve(folder, 'ep_locomotion.js')).href);
  const bytes = readFileSync(join(folder, 'ep_locomotion_bg.wasm'));
  // Earlier builds know the longer name.
  await core.default(/** @type {any} */ ({ module: bytes, module_or_path: bytes }));
  return core;
}

/** Microseconds of a call. @param {() => unknown} call @param {number} times a round @param {number} rounds @returns {Time} */
function measure(call, times, rounds) {
  const round = () => {
    const start = performance.now();
    for (let i = 0; i < times; i++) call();
    return ((performance.now() - start) / times) * 1e3;
  };
  round();
  const all = Array.from({ length: rounds }, round).sort((a, b) => a - b);
  return { least: all[0], median: all[all.length >> 1] };
}

/** What is measured of any core. @param {Core} core @param {number} rounds @returns {Record<string, Time>} */
function ofAny(core, rounds) {
  const e = core.experiment('velocity-limits');
  const starts = core.startsOnCircle({ x: 2, y: 2, radius: 2.83, count: 1000, seed: 1 });
  const endless = { ...e, tolerance: { position: 0, heading: 0 } };
  return {
    'evaluate, one triple': measure(() => core.evaluate(e, gains), 200, rounds),
    'evaluate, one triple from 1000 starts': measure(() => core.evaluate({ ...e, starts }, gains), 5, rounds),
    'simulate, 1001 samples': measure(() => core.simulate(endless, gains), 20, rounds),
  };
}

/** What only this one has. @param {Core} core @param {number} rounds @returns {Record<string, Time>} */
function ofTasks(core, rounds) {
  const e = core.experiment('velocity-limits');
  const starts = core.startsOnCircle({ x: 2, y: 2, radius: 2.83, count: 1000, seed: 1 });
  const flat = Float64Array.from(starts.flatMap(({ x, y, theta }) => [x, y, theta]));
  const [one, many] = [new core.Task(e), new core.Task({ ...e, starts })];
  const endless = new core.Task({ ...e, tolerance: { position: 0, heading: 0 } });
  const read = (/** @type {import('../pkg/ep_locomotion.js').PartialExperiment} */ from) =>
    new core.Task(from).free();
  return {
    'a task: evaluate, one triple': measure(() => one.evaluate(gains), 200, rounds),
    'a task: simulate, 1001 samples': measure(() => endless.simulate(gains), 20, rounds),
    'read 1000 starts': measure(() => read({ ...e, starts }), 5, rounds),
    'read 1000 starts side by side': measure(() => read({ ...e, starts: flat }), 5, rounds),
    'drive from 1000 starts': measure(() => many.evaluate(gains), 5, rounds),
    'a contest: four methods, 51 seeds, 4000 drives': measure(contest(core), 1, 3),
    'a survey: 100 seeds, 200 generations, and random search': measure(survey(core), 1, 3),
  };
}

/** Evolution as in the paper and three rivals, as many seeds at once as one call takes. @param {Core} core */
function contest(core) {
  const e = core.experiment('velocity-limits');
  /** @type {import('../pkg/ep_locomotion.js').Method[]} */
  const methods = ['ep', 'de', 'cma-es', 'nelder-mead'];
  const tasks = methods.map((method) => new core.Task({ ...e, evolution: { ...e.evolution, method } }));
  return () => tasks.map((task) => task.trials({ seeds: [1, 52], drives: 4000 }));
}

/** In four calls, for one takes no more. @param {Core} core */
function survey(core) {
  const task = new core.Task(core.experiment('velocity-limits'));
  const part = (/** @type {number} */ first) =>
    task.seedRuns({ seeds: [first, first + 25], generations: 200 });
  return () => [1, 26, 51, 76].map(part);
}

/** Of the core in pkg/, and beside it of another build. @param {string} top @param {string | undefined} against @param {number} rounds */
export async function measureCalls(top, against, rounds) {
  const folder = join(top, 'pkg');
  if (!existsSync(join(folder, 'ep_locomotion_bg.wasm'))) return null;
  const core = await load(folder);
  const other = against ? ofAny(await load(against), rounds) : {};
  return { calls: { ...ofAny(core, rounds), ...ofTasks(core, rounds) }, other };
}
