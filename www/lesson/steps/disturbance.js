// A ground that pushes, and what Theorem 2 says of it.
import { remember } from '../../kit/memo.js';
import { disturbanceSlice } from '../../parts/disturbance/state.js';
import { gainsOf } from '../../run/drivers.js';
import { withDisturbance } from '../../run/scene.js';
import { fixed, threeDigits } from '../../words/numbers.js';
import { robustFormula } from '../formulas/formulas.js';
import { createNearGoal } from '../views/near-goal.js';
import { createTheoremNow } from '../views/theorem-now.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Engine, Experiment, Posture, Run, Triple } from '../../core/engine.js' */
/** @import { Written } from '../steps.js' */

const slip = { kind: /** @type {const} */ ('slip'), linear: 0.1, angular: 0, seed: 1 };
/** What remains is what the last seconds still have. */
const lastSeconds = 2;

/** The farthest from the goal in the last seconds. @param {Run} run @param {Posture} goal */
function farthest({ time, x, y, finalTime }, goal) {
  const first = time.findIndex((one) => one >= finalTime - lastSeconds);
  return Math.max(
    ...Array.from(x.subarray(first), (_, i) => Math.hypot(x[first + i] - goal.x, y[first + i] - goal.y)),
  );
}

/** @param {Engine} engine @param {Experiment} experiment @param {Triple} gains @param {Experiment['disturbance']} disturbance */
const driveUnder = (engine, experiment, gains, disturbance) =>
  engine.drive({ ...experiment, ...withDisturbance(disturbance) }, [gains])[0];

/** What the step's own drive comes to, whatever is on screen. */
const slippedOf = remember((/** @type {Engine} */ engine, /** @type {Triple} */ gains) => {
  const usual = engine.experiment('velocity-limits');
  const run = driveUnder(engine, usual, gains, slip);
  return {
    push: fixed(slip.linear, 1),
    distance: fixed(farthest(run, usual.goal), 3),
    command: fixed(run.commandLinear[run.commandLinear.length - 1], 2),
  };
});

/** @type {Written} */
export const disturbance = {
  figure: 'plane',
  stage: { place: 'beside', pages: ['disturbance'], create: createNearGoal },
  blocks: [
    { kind: 'text', name: 'slip' },
    { kind: 'text', name: 'why' },
    quiz('double', {
      shows: 'disturbance&drives=hand&gains=6.47346,0.19356,10.35782&under=slip,0.1,0,1',
      watch: true,
      answer({ engine, state, scene, paper, gains }) {
        const { goal } = state.experiment;
        const own = gainsOf(state, 'paper-ep', paper);
        const before = farthest(
          driveUnder(engine, state.experiment, own, scene.experiment.disturbance),
          goal,
        );
        const after = farthest(scene.driving, goal);
        const right = after > 0.75 * before ? 0 : after > 0.1 * before ? 1 : 2;
        return { right, before, after, own, gains };
      },
    }),
    quiz('random', {
      shows: 'disturbance&drives=paper-ep&under=random,0.1,0,1',
      watch: true,
      order: [2, 0, 1],
      answer({ engine, state, scene, gains }) {
        const { goal } = state.experiment;
        const steady = farthest(driveUnder(engine, state.experiment, gains, slip), goal);
        const random = farthest(scene.driving, goal);
        const right = random > 1.1 * steady ? 0 : random > 0.5 * steady ? 1 : 2;
        return { right, steady, random };
      },
    }),
    { kind: 'text', name: 'theorem' },
    { kind: 'formula', formula: robustFormula },
    { kind: 'view', create: createTheoremNow },
    { kind: 'text', name: 'sets' },
    { kind: 'text', name: 'unknown' },
    tries([
      ['turning', 'disturbance&drives=paper-ep&under=slip,0.1,0.2,1'],
      ['aside', 'disturbance&drives=paper-ep&under=slip,0.1,0.2,1&from=4,0,0deg'],
      ['evolved', 'disturbance&generation=100&under=slip,0.1,0.2,1'],
      ['huge', 'disturbance&drives=hand&gains=250,250,250&under=slip,0.1,0,1'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values({ engine, state, paper }) {
    const { measured } = disturbanceSlice.of(state);
    // Of who drives, as beside the curves; the first start is that of the drive.
    const others = measured?.calm.error.y.subarray(1);
    return {
      ...slippedOf(engine, paper[0].gains),
      ky: measured ? threeDigits(measured.spec.gains[1]) : '…',
      starts: others ? String(others.length) : '…',
      left: others ? fixed(Math.max(...others), 2) : '…',
      last: measured ? threeDigits(measured.spec.seconds) : '…',
      horizon: measured ? threeDigits(measured.spec.experiment.horizon) : '…',
    };
  },
};
