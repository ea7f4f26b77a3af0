// What is "good"? J, its parts and its weights.
import { remember } from '../../kit/memo.js';
import { lab } from '../../words/index.js';
import { fixed } from '../../words/numbers.js';
import { costFormula } from '../formulas/formulas.js';
import { entrantsOf, createStandings, gentle, winnerOf } from '../views/standings.js';
import { createWeights } from '../views/weights.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Engine, Triple } from '../../core/engine.js' */
/** @import { Live } from '../page.js' */
/** @import { Written } from '../steps.js' */

const byHand = 'lab&drives=hand&gains=3,1,5';
const heavy = 'weights.velocity=5,5';
const heaviest = 'weights.velocity=100,100';
/** @type {Triple} */
const idle = [0, 0, 0];
/** @type {readonly Triple[]} */
export const withKy = [
  [3, 0, 5],
  [3, 1, 5],
  [3, 8, 5],
];

/** Who of the table costs least now, and what they pay for. @param {Live} live */
function winner(live) {
  const { ep, arbitrary } = entrantsOf(live, null);
  const runs = live.engine.drive(
    live.state.experiment,
    [ep, arbitrary, gentle].map((gains) => gains ?? gentle),
  );
  return { right: winnerOf(runs), runs };
}

/** Whether a robot that stays where it is costs less than one that drives. @param {Live} live */
function staying({ engine, state }) {
  const [stays, drives] = engine.drive(state.experiment, [idle, gentle]);
  return { right: stays.cost.total < drives.cost.total ? 1 : 0, stays, drives };
}

/** What ky costs from the paper's start, with the weights that we chose. */
const costsOfKy = remember((/** @type {Engine} */ engine) =>
  engine
    .drive(engine.experiment('velocity-limits'), withKy)
    .map(({ cost: { total } }) => lab.costText(total)),
);

/** @type {Written} */
export const cost = {
  figure: 'drive',
  stage: { place: 'instead', pages: ['lab'], create: createStandings },
  blocks: [
    { kind: 'text', name: 'parts' },
    { kind: 'formula', formula: costFormula },
    { kind: 'text', name: 'each' },
    { kind: 'text', name: 'weights' },
    { kind: 'view', create: createWeights },
    quiz('heavier', { shows: `${byHand}&${heavy}`, order: [2, 0, 1], answer: winner }),
    quiz('home', { shows: `lab&drives=hand&gains=0,0,0&${heaviest}`, order: [1, 0], answer: staying }),
    tries([
      ['cheap', `${byHand}&weights.velocity=0.1,0.1`],
      ['evolved', `lab&generation=60&${heaviest}`],
      ['final', `lab&drives=hand&gains=0,0,0&${heaviest}&weights.final=100,100,100`],
      ['negative', 'lab&drives=hand&gains=3,-0.01,5'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'ky' },
    { kind: 'text', name: 'next' },
  ],
  values({ engine, scene }) {
    const [none, one, eight] = costsOfKy(engine);
    return { none, one, eight, energy: fixed(scene.driving.cost.energy, 2) };
  },
};
