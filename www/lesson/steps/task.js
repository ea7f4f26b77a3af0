// The gains that were evolved on one start, from everywhere else.
import { robustnessSlice } from '../../parts/robustness/state.js';
import { gridAround, headings } from '../../parts/robustness/grid.js';
import { fine } from '../../parts/robustness/request.js';
import { trainingSlice } from '../../parts/training/state.js';
import { remember, rememberEach } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { caughtUp } from '../../run/state.js';
import { lab } from '../../words/index.js';
import { fixed } from '../../words/numbers.js';
import { aside, isSame } from '../aside.js';
import { mapsAreDone, shareOfStarts, trainedOn, trainingIsDone } from '../robust.js';
import { filmRuns } from '../duel/film.js';
import { createSwarm } from '../duel/swarm.js';
import shared from '../words/index.js';
import { createWeights } from '../views/weights.js';
import { yardOf } from '../duel/yard.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Engine, Triple } from '../../core/engine.js' */
/** @import { Live, Tools } from '../page.js' */
/** @import { Quiz } from '../questions/quiz.js' */
/** @import { Written } from '../steps.js' */

/** The generation that the step speaks of. */
const evolvedTo = 100;
/** Turning costs a tenth. */
export const cheapTurns = 'weights.velocity=1,0.1';

/** @param {Engine} engine */
const weightsOf = (engine) => engine.experiment('velocity-limits').weights;

/** The best robot of the generation, from 32 starts at once: who fails is seen to fail. @param {Tools} tools */
const createTaskStage = (tools) =>
  createSwarm(tools, shared.swarm, ({ engine, state, gains }) => {
    const yard = yardOf(engine).drive(state.experiment, gains);
    return yard && { name: shared.swarm.own(gains), yard };
  });

/** What a prediction sets going in Training, and waits for. @type {Pick<Quiz, 'begins' | 'of' | 'ready'>} */
const evolvesAll = {
  begins: (store) => trainingSlice.update(store, { wanted: 'evolved' }),
  of: (state) => [trainingSlice.of(state).generations],
  ready: ({ state }) => trainingIsDone(state),
};

/** @type {Written} */
export const task = {
  figure: 'evolve',
  stage: { place: 'instead', pages: ['lab'], after: 'share', create: createTaskStage },
  blocks: [
    { kind: 'text', name: 'good' },
    quiz('share', {
      shows: 'lab&generation=100',
      of: (state) => [caughtUp(state).generation],
      order: [1, 2, 3, 0],
      // Who fails is seen to fail first.
      ready: () => !filmRuns(),
      async answer({ engine, state }) {
        const found = await shareOfStarts(engine, state, state.population[0].gains);
        // The middles of the choices: all, three quarters, half, one quarter.
        const right = [1, 0.75, 0.5, 0.25].findIndex((middle) => found.share > middle - 0.125);
        return { right: right < 0 ? 3 : right, ...found };
      },
    }),
    { kind: 'text', name: 'beside', after: 'share' },
    { kind: 'text', name: 'asked', after: 'share' },
    quiz('arbitrary', {
      shows: 'robustness&generation=100&drives=paper-arbitrary',
      order: [2, 0, 1],
      ready: ({ state }) => mapsAreDone(state),
      async answer({ engine, state, paper }) {
        const robots = /** @type {const} */ (['evolved', 'paper-arbitrary']).map((driver) =>
          gainsOf(state, driver, paper),
        );
        const [own, other] = await Promise.all(robots.map((one) => shareOfStarts(engine, state, one)));
        const [best, dear] = engine.drive(state.experiment, robots);
        const right = other.share < 0.9 * own.share ? 0 : other.share > 1.1 * own.share ? 2 : 1;
        return { right, own, other, best, dear };
      },
    }),
    { kind: 'text', name: 'many', after: 'arbitrary' },
    quiz('price', {
      shows: 'training&generation=100',
      ...evolvesAll,
      async answer({ engine, state }) {
        const [one, many] = await trainedOn(engine, state, ['one', 'circle']);
        const right = many.own < 0.99 * one.own ? 0 : many.own > 1.01 * one.own ? 2 : 1;
        return { right, one, many };
      },
    }),
    { kind: 'text', name: 'half', after: 'price' },
    { kind: 'view', create: createWeights, after: 'price' },
    quiz('turning', {
      shows: `training&generation=100&${cheapTurns}`,
      order: [1, 2, 0],
      ...evolvesAll,
      async answer({ engine, state }) {
        const dear = { ...state, experiment: { ...state.experiment, weights: weightsOf(engine) } };
        const [[before], [after]] = await Promise.all([
          trainedOn(engine, dear, ['circle']),
          trainedOn(engine, state, ['circle']),
        ]);
        const share = after.unseen.count / after.unseen.starts.length;
        const right = after.unseen.count < before.unseen.count ? 0 : share < 0.9 ? 1 : 2;
        return { right, before, after };
      },
    }),
    { kind: 'text', name: 'whole', after: 'turning' },
    tries([
      ['beside', 'robustness&generation=100&from=2,0,0deg', 'robot'],
      ['withKy', 'robustness&generation=100&drives=hand&gains=3.2,10,4.3&from=2,0,0deg', 'robot'],
      ['training', 'training&generation=100'],
      ['cheap', 'training&generation=100&seed=3'],
      ['both', 'training&generation=100&weights.velocity=0.1,0.1'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values: ({ engine, state, paper }) => toldOf(engine, firstRobot(engine)(state), paper[0].gains),
};

/** The gains of steps 7, 8 and 10: on screen when the step opens, and else evolved once more. */
const firstRobot = rememberEach((/** @type {Engine} */ engine) => {
  const usual = engine.experiment('velocity-limits');
  const evolve = aside(() => engine.surveys.evolve(usual, evolvedTo));
  /** @type {Triple | null} */
  let known = null;
  return (/** @type {Live['state']} */ { experiment, generation, population }) => {
    if (!known && generation === evolvedTo && isSame(experiment, usual)) known = population[0].gains;
    return known ?? evolve().gains;
  };
});

/** What is said of it, whatever is tried after it. */
const toldOf = remember(
  (/** @type {Engine} */ engine, /** @type {Triple} */ gains, /** @type {Triple} */ papers) => {
    const usual = engine.experiment('velocity-limits');
    const [best, ep] = engine.drive(usual, [gains, papers]);
    const grid = gridAround(usual.goal, 1, fine);
    const places = grid.x.count * grid.y.count;
    return {
      generation: String(evolvedTo),
      time: fixed(best.finalTime, 2),
      cost: lab.costText(best.cost.total),
      paper: lab.costText(ep.cost.total),
      places: lab.grouped(places),
      side: fixed(2 * robustnessSlice.first.half, 0),
      headings: String(headings),
      starts: lab.grouped(places * headings),
      ky: fixed(gains[1], 4),
      ye: fixed(engine.samples(usual, gains).at(0).error.y, 2),
    };
  },
);
