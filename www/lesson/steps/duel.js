// You against evolution, on a task that a hand loses.
import { lab } from '../../words/index.js';
import { drivesUntil, generationsIn, judge, lowestOf, nextSeed, roundOf, winners } from '../duel/duel.js';
import {
  createDuelDrives,
  createDuelResult,
  createDuelStage,
  duelIn,
  priceInYard,
} from '../duel/duel-view.js';
import { quiz, tries } from '../questions/asks.js';
import words from '../words/index.js';

/** @import { Written } from '../steps.js' */

/** @type {Written} */
export const duel = {
  figure: 'plane',
  sight: 'gains',
  stage: { place: 'instead', pages: ['lab'], create: createDuelStage },
  price: priceInYard,
  blocks: [
    { kind: 'text', name: 'begin' },
    { kind: 'view', create: createDuelDrives },
    quiz('ahead', {
      opens: (live) => duelIn(live).costs.length > 0,
      async answer(live) {
        const locked = duelIn(live);
        const first = locked.rounds[0] ?? (await roundOf(live.engine, locked, nextSeed(locked)));
        const verdict = judge(locked, first);
        return { right: winners.indexOf(verdict.winner), ...verdict };
      },
    }),
    { kind: 'view', create: createDuelResult },
    tries([
      ['sharp', 'lab&drives=hand&gains=12,12,6&weights.velocity=1,0.1'],
      ['dear', 'lab&drives=hand&gains=1,1,1'],
      ['luck', 'luck'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values: (live) => {
    const { costs, experiment } = duelIn(live);
    const { population, initialRange } = experiment.evolution;
    const generations = generationsIn(costs.length, population);
    const turning = experiment.weights.velocity[1];
    const [, before] = live.engine.experiment('velocity-limits').weights.velocity;
    return {
      drives: String(costs.length),
      best: costs.length > 0 ? lab.costText(lowestOf(costs)) : words.steps.duel.duel.none,
      count: String(population),
      generations: String(generations),
      given: String(drivesUntil(generations, population)),
      turning: String(turning),
      before: words.steps.duel.duel.before(turning, before),
      low: String(initialRange[0]),
      high: String(initialRange[1]),
    };
  },
};
