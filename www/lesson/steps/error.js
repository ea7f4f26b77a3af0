// Where the goal is, seen from the robot.
import { errorFormula, errorNumbers } from '../formulas/formulas.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Written } from '../steps.js' */

/** @type {Written} */
export const error = {
  figure: 'plane',
  overlay: true,
  time: () => 0,
  blocks: [
    { kind: 'text', name: 'three' },
    { kind: 'formula', formula: errorFormula },
    { kind: 'text', name: 'signs' },
    quiz('largest', {
      shows: 'lab&drives=hand&gains=3,5,5&start=0,2,90deg',
      time: 0,
      answer({ engine, scene }) {
        const { x, y, theta } = engine.samples(scene.experiment, [3, 5, 5]).at(0).error;
        const difference = Math.abs(x) - Math.abs(y);
        return { right: Math.abs(difference) < 0.005 ? 2 : difference > 0 ? 0 : 1, x, y, theta };
      },
    }),
    tries([
      ['beside', 'lab&drives=hand&gains=3,5,5&start=3,1,45deg'],
      ['beyond', 'lab&drives=hand&gains=3,5,5&start=3,3,45deg'],
      ['turned', 'lab&drives=hand&gains=3,5,5&start=2,2,-45deg'],
    ]),
    { kind: 'notice' },
  ],
  values: ({ sample }) => errorNumbers(sample, 2),
};
