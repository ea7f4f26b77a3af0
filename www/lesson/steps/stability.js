// Why it gets there. The Lyapunov function and its rate.
import { extentOf, largest } from '../../kit/extent.js';
import { fixed } from '../../words/numbers.js';
import { createBowl } from '../views/bowl.js';
import { createCancel } from '../views/cancel.js';
import { chainFormula, errorRateFormula, motionFormula } from '../formulas/formulas-motion.js';
import { lyapunovFormula, rateFormula } from '../formulas/formulas.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Written } from '../steps.js' */

const unlimited = 'limits.speed=off&limits.turnRate=off';

/** @type {Written} */
export const stability = {
  figure: 'plane',
  stage: { place: 'beside', pages: ['curves'], create: createBowl },
  blocks: [
    { kind: 'text', name: 'bowl' },
    { kind: 'formula', formula: lyapunovFormula },
    { kind: 'text', name: 'falls' },
    { kind: 'formula', formula: motionFormula },
    { kind: 'text', name: 'errors' },
    { kind: 'formula', formula: errorRateFormula },
    { kind: 'text', name: 'chain' },
    { kind: 'formula', formula: chainFormula },
    { kind: 'view', create: createCancel },
    { kind: 'text', name: 'left' },
    { kind: 'formula', formula: rateFormula },
    { kind: 'text', name: 'parts' },
    quiz('negative', {
      // So often that the robot does what the law promises.
      shows: `curves&view=stability&drives=hand&gains=3,-0.5,5&${unlimited}&sampleTime=0.0005&horizon=2`,
      watch: true,
      order: [2, 0, 1],
      answer({ samples, scene }) {
        const values = samples.map(({ lyapunov }) => lyapunov);
        const [first, last] = [values[0], values[values.length - 1]];
        const [least] = extentOf([values]);
        const { arrived } = scene.driving;
        // How far it has risen by then rounding decides, not that it rises.
        return { right: arrived ? 0 : last > 2 * least ? 2 : 1, first, last, least };
      },
    }),
    { kind: 'text', name: 'before' },
    quiz('kanayama', {
      shows: `curves&view=stability&law=kanayama&drives=hand&gains=3,1,5&${unlimited}`,
      sight: 'robot',
      watch: true,
      order: [0, 2, 1],
      answer({ scene }) {
        const { driving, experiment } = scene;
        const end = driving.time.length - 1;
        const { goal } = experiment;
        const away = Math.hypot(driving.x[end] - goal.x, driving.y[end] - goal.y);
        const turned = largest(driving.angular.map(Math.abs));
        return { right: driving.arrived ? 0 : away < 0.05 ? 1 : 2, away, turned };
      },
    }),
    tries([
      ['other', `curves&view=stability&drives=hand&gains=3,1,5&${unlimited}&start=-1,-1,180deg`, 'part'],
      ['negativeTurn', `curves&view=stability&drives=hand&gains=3,1,-2&${unlimited}`],
      ['track', 'curves&view=stability&drives=hand&gains=3,1,5&referenceVelocity.linear=0.5', 'robot'],
      [
        'kanayamaTracks',
        'curves&view=stability&law=kanayama&drives=hand&gains=3,1,5&referenceVelocity.linear=0.5',
        'robot',
      ],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values: ({ sample }) => ({
    V: fixed(sample.lyapunov, 3),
    time: fixed(sample.time, 2),
  }),
};
