// What the wheels cannot do, and what that does to the theory. Figures 4 to 7 of the paper.
import { largest } from '../../kit/extent.js';
import { remember } from '../../kit/memo.js';
import { fixed } from '../../words/numbers.js';
import { createAsked } from '../views/asked.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Samples, Triple } from '../../core/engine.js' */
/** @import { Live } from '../page.js' */
/** @import { Written } from '../steps.js' */

const unlimited = 'limits.speed=off&limits.turnRate=off';

/** From beside the goal, where V rises under the limits. */
const raised = 'start=0,2,90deg';

/** At how many samples V is higher than at the one before. @param {Samples} samples */
function risesOf(samples) {
  const values = samples.map(({ lyapunov }) => lyapunov);
  return values.filter((value, i) => i > 0 && value > values[i - 1]).length;
}

/** The same gains without limits, with those of the paper's first drives, and with those of its last. */
const runsWith = remember(
  /** @param {Live['engine']} engine @param {Live['state']['experiment']} from @param {Triple} gains */
  (engine, from, gains) => {
    const { limits: velocity } = engine.experiment('velocity-limits');
    const { limits: acceleration } = engine.experiment('acceleration-limits');
    const none = { speed: null, turnRate: null, acceleration: null, turnAcceleration: null };
    const [free, limited, sluggish] = [none, velocity, acceleration].map((limits) => {
      const experiment = { ...from, limits };
      const samples = engine.samples(experiment, gains);
      return {
        run: engine.drive(experiment, [gains])[0],
        rises: risesOf(samples),
        samples: samples.length - 1,
      };
    });
    return { free, limited, sluggish };
  },
);
/** Starts around the goal, as far as 4 m and with any heading. */
const everywhere = 100;
const seedOfStarts = 7;

/** In how many of their drives V rises at least once, with the limits of speed. */
export const risesFromEverywhere = remember(
  (/** @type {Live['engine']} */ engine, /** @type {Triple} */ gains) => {
    const experiment = engine.experiment('velocity-limits');
    const { x, y } = experiment.goal;
    const starts = [1, 2, 3, 4].flatMap((radius) =>
      engine.startsOnCircle({ x, y, radius, count: everywhere / 4, seed: seedOfStarts + radius }),
    );
    const rising = starts.filter((start) => {
      const { lyapunov } = engine.stability({ ...experiment, starts: [start] }, gains);
      return lyapunov.some((value, i) => i > 0 && value > lyapunov[i - 1]);
    });
    return { raised: rising.length, starts: starts.length };
  },
);

/** @param {Live} live */
const runsOf = ({ engine, state, gains }) => runsWith(engine, state.experiment, gains);

/** The drives that the text speaks of, whatever is on screen. */
const epOf = remember((/** @type {Live['engine']} */ engine, /** @type {Triple} */ gains) =>
  runsWith(engine, engine.experiment('velocity-limits'), gains),
);

/** @type {Written} */
export const limits = {
  figure: 'plane',
  stage: { place: 'beside', pages: ['curves'], create: createAsked },
  blocks: [
    { kind: 'text', name: 'asked' },
    quiz('free', {
      shows: `curves&drives=paper-ep&${unlimited}`,
      watch: true,
      order: [2, 0, 1],
      answer(live) {
        const { free, limited } = runsOf(live);
        const ratio = free.run.cost.total / limited.run.cost.total;
        return { right: ratio < 0.9 ? 0 : ratio < 1.1 ? 1 : 2, free, limited };
      },
    }),
    { kind: 'text', name: 'theory', after: 'free' },
    quiz('heals', {
      shows: `curves&view=stability&drives=paper-ep&${raised}`,
      sight: 'part',
      watch: true,
      order: [0, 2, 1],
      answer({ engine, paper }) {
        const { raised: drives, starts } = risesFromEverywhere(engine, paper[0].gains);
        const share = drives / starts;
        return { right: share < 0.1 ? 0 : share < 0.5 ? 1 : 2, drives, starts };
      },
    }),
    { kind: 'text', name: 'clipped', after: 'heals' },
    quiz('brakes', {
      shows: 'curves&preset=acceleration-limits&drives=hand&gains=10,10,10',
      watch: true,
      answer(live) {
        const { limited, sluggish } = runsOf(live);
        const ratio = sluggish.run.finalTime / limited.run.finalTime;
        return { right: ratio < 0.98 ? 0 : ratio < 1.3 ? 1 : 2, limited, sluggish };
      },
    }),
    tries([
      ['raised', `curves&view=stability&drives=hand&gains=3,8,5&start=2.5,1.5,45deg`, 'part'],
      ['figure4', 'lab&drives=paper-ep'],
      ['figure5', 'curves&drives=paper-ep', 'part'],
      ['figure6', 'lab&preset=acceleration-limits&drives=paper-ep'],
      ['figure7', 'curves&preset=acceleration-limits&drives=paper-ep', 'part'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values(live) {
    const usual = live.engine.experiment('velocity-limits');
    const { free, limited } = epOf(live.engine, live.paper[0].gains);
    const { commandLinear, commandAngular } = limited.run;
    const turnRate = usual.limits.turnRate ?? 0;
    return {
      askedV: fixed(largest(commandLinear.map(Math.abs)), 1),
      askedW: fixed(largest(commandAngular.map(Math.abs)), 1),
      v: fixed(usual.limits.speed ?? 0, 1),
      w: `${fixed(turnRate / Math.PI, 0)}π (${fixed(turnRate, 3)})`,
      rises: String(free.rises),
      samples: String(free.samples),
    };
  },
};
