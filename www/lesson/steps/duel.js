// You against evolution.
import { costText } from '../../words/numbers.js';
import { judge, lowestOf, nextSeed, roundOf, winners } from '../duel.js';
import { createDuelDrives, createDuelResult, duelIn } from '../duel-view.js';
import { path } from '../path.js';

/** @import { Step } from '../steps.js' */

/** @type {Step} */
export const duel = {
  name: 'duel',
  link: path.duel,
  figure: 'drive',
  blocks: [
    { kind: 'text', name: 'begin' },
    { kind: 'view', create: createDuelDrives },
    {
      kind: 'quiz',
      name: 'ahead',
      quiz: {
        async answer(live) {
          const locked = duelIn(live);
          const first = locked.rounds[0] ?? (await roundOf(live.engine, locked, nextSeed(locked)));
          const verdict = judge(locked, first);
          return { right: winners.indexOf(verdict.winner), ...verdict };
        },
      },
    },
    { kind: 'view', create: createDuelResult },
    {
      kind: 'tries',
      tries: [
        ['luck', 'luck'],
        ['backwards', 'lab&drives=hand&gains=3,1,5&start=0,2,180deg'],
        ['round', 'lab&drives=hand&gains=3,1,5&start=2,2,-135deg'],
      ],
    },
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values: (live) => {
    const { costs, experiment } = duelIn(live);
    return {
      drives: String(costs.length),
      best: costText(lowestOf(costs)),
      count: String(experiment.evolution.population),
      low: String(experiment.evolution.initialRange[0]),
      high: String(experiment.evolution.initialRange[1]),
    };
  },
};
