// Drive it yourself. No theory yet.
import { gainsOf } from '../../run/drivers.js';
import { createTallyLine } from '../duel/tally-line.js';
import { lab } from '../../words/index.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Written } from '../steps.js' */

/** @type {Written} */
export const drive = {
  figure: 'drive',
  blocks: [
    { kind: 'text', name: 'begin' },
    { kind: 'view', create: createTallyLine },
    quiz('bolder', {
      shows: 'lab&drives=hand&gains=10,10,10&pin1=5,5,5~5,5,5',
      sight: 'robot',
      watch: true,
      order: [1, 2, 0],
      // The drive that the prediction is about, beside a gentler one.
      answer({ engine, state, scene }) {
        const [gentle] = engine.drive(state.experiment, [[5, 5, 5]]);
        const bold = scene.driving;
        const faster = bold.finalTime < gentle.finalTime;
        const cheaper = bold.cost.total < gentle.cost.total;
        return { right: faster ? (cheaper ? 0 : 1) : 2, gentle, bold };
      },
    }),
    tries([
      ['stops', 'lab&drives=hand&gains=3,0,0'],
      ['onlySecond', 'lab&drives=hand&gains=0,5,0'],
      ['noDrive', 'lab&drives=hand&gains=0,0,5'],
      ['negative', 'lab&drives=hand&gains=-1,1,5'],
      ['paper', 'lab&drives=paper-ep'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values: ({ engine, state, paper }) => {
    const drivers = /** @type {const} */ (['paper-arbitrary', 'paper-ep']);
    const gains = drivers.map((driver) => gainsOf(state, driver, paper));
    const [arbitrary, ep] = engine.drive(state.experiment, gains).map(({ cost }) => lab.costText(cost.total));
    return { arbitrary, ep };
  },
};
