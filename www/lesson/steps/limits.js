// What the wheels cannot do, and what that does to the theory. Figures 4 to 7 of the paper.
import { remember } from '../../kit/memo.js';
import { fixed } from '../../words/numbers.js';
import { path } from '../path.js';

/** @import { Samples, Triple } from '../../core/engine.js' */
/** @import { Live } from '../page.js' */
/** @import { Step } from '../steps.js' */

const unlimited = 'limits.speed=off&limits.turnRate=off';

/** At how many samples V is higher than at the one before. @param {Samples} samples */
function risesOf(samples) {
  const values = samples.map(({ lyapunov }) => lyapunov);
  return values.filter((value, i) => i > 0 && value > values[i - 1]).length;
}

/** The same gains without limits, with those of the paper's first drives, and with those of its last. */
const runsWith = remember(
  (
    /** @type {Live['engine']} */ engine,
    /** @type {Live['state']['experiment']} */ from,
    /** @type {Triple} */ gains,
  ) => {
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
/** @param {Live} live */
const runsOf = ({ engine, state, gains }) => runsWith(engine, state.experiment, gains);

/** @type {Step} */
export const limits = {
  name: 'limits',
  link: path.limits,
  figure: 'plane',
  blocks: [
    { kind: 'text', name: 'asked' },
    {
      kind: 'quiz',
      name: 'free',
      quiz: {
        shows: `curves&drives=paper-ep&${unlimited}`,
        answer(live) {
          const { free, limited } = runsOf(live);
          const ratio = free.run.cost.total / limited.run.cost.total;
          return { right: ratio < 0.9 ? 0 : ratio < 1.1 ? 1 : 2, free, limited };
        },
      },
    },
    { kind: 'text', name: 'theory' },
    {
      kind: 'quiz',
      name: 'brakes',
      quiz: {
        shows: 'curves&preset=acceleration-limits&drives=hand&gains=10,10,10',
        answer(live) {
          const { limited, sluggish } = runsOf(live);
          const ratio = sluggish.run.finalTime / limited.run.finalTime;
          return { right: ratio < 0.98 ? 0 : ratio < 1.3 ? 1 : 2, limited, sluggish };
        },
      },
    },
    {
      kind: 'tries',
      tries: [
        ['figure4', 'lab&drives=paper-ep'],
        ['figure5', 'curves&drives=paper-ep'],
        ['figure6', 'lab&preset=acceleration-limits&drives=paper-ep'],
        ['figure7', 'curves&preset=acceleration-limits&drives=paper-ep'],
      ],
    },
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values(live) {
    const { commandLinear, commandAngular } = live.scene.driving;
    const { free, limited } = runsOf(live);
    const { speed, turnRate } = live.state.experiment.limits;
    return {
      askedV: fixed(Math.max(...commandLinear.map(Math.abs)), 1),
      askedW: fixed(Math.max(...commandAngular.map(Math.abs)), 0),
      v: speed === null ? '∞' : fixed(speed, 1),
      w: turnRate === null ? '∞' : fixed(turnRate, 1),
      rises: String(free.rises),
      samples: String(free.samples),
      limitedRises: String(limited.rises),
    };
  },
};
