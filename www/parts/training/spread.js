// How much of it is luck: the same evolutions with other seeds, and from how many unseen starts each of their robots arrives.
/** @import { Engine } from '../../core/engine.js' */
/** @import { SurveyOptions } from '../../core/surveys.js' */
/** @import { Evolved } from './request.js' */
/** @import { SetName, Sets } from './sets.js' */
import { median } from 'd3-array';
import { setNames, testOn } from './sets.js';

/** From how many unseen starts the robot of each seed arrives, the shown one first. @typedef {Record<SetName, readonly number[]>} Spread */

/** What is told of a set. @typedef {{ seeds: number, least: number, median: number, most: number }} Range */

export const seedCount = 15;
/** A seed has so many values. */
const seeds = 2 ** 32;

/** @param {Engine} engine @param {Sets} sets @param {Evolved} evolved @param {SurveyOptions} options @returns {Promise<Spread>} */
export async function evolveSeeds(engine, sets, { experiment, generations, results }, options) {
  const { evolution } = experiment;
  const others = Array.from({ length: seedCount - 1 }, (_, i) => (evolution.seed + i + 1) % seeds);
  const jobs = setNames.flatMap((name) =>
    others.map((seed) => ({ ...experiment, starts: sets[name], evolution: { ...evolution, seed } })),
  );
  const champions = await engine.surveys.evolveAll(jobs, generations, options);
  const unseen = testOn(experiment, sets.unseen);
  const fares = await engine.surveys.fares(
    champions.map(({ gains }) => [unseen, gains]),
    { signal: options.signal },
  );
  const counts = fares.map(({ arrived }) => arrived.reduce((sum, one) => sum + one, 0));
  const of = (/** @type {SetName} */ name) => {
    const at = setNames.indexOf(name) * others.length;
    return [results[name].unseen.count, ...counts.slice(at, at + others.length)];
  };
  return { one: of('one'), circle: of('circle'), grid: of('grid') };
}

/** @param {readonly number[]} counts @returns {Range} */
const rangeOf = (counts) => ({
  seeds: counts.length,
  least: Math.min(...counts),
  median: median(counts) ?? 0,
  most: Math.max(...counts),
});

/** @param {Spread} spread @returns {Record<SetName, Range>} */
export const rangesOf = ({ one, circle, grid }) => ({
  one: rangeOf(one),
  circle: rangeOf(circle),
  grid: rangeOf(grid),
});
