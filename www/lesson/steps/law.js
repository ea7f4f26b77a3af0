// The control law, term by term, and what each gain does alone.
import { remember } from '../../kit/memo.js';
import { degreesText, fixed, signed } from '../../words/numbers.js';
import { lawFormula } from '../formulas/formulas.js';
import { largestAt } from '../views/push-terms.js';
import { createPushes } from '../views/pushes.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Engine, Experiment, Triple } from '../../core/engine.js' */
/** @import { Live } from '../page.js' */
/** @import { Written } from '../steps.js' */

/** From here each gain alone brings its own error to zero and leaves the others. */
const start = { x: 1.5, y: 0.5, theta: 0 };
const below = `start=${Object.values(start).join(',')}`;
/** Beside the goal, and turned as it is. */
const beside = 'start=2.5,1.5,45deg';
/** @type {Triple} */
const kxAlone = [3, 0, 0];
/** @type {Triple} */
const withoutKy = [3, 0, 5];
/** @type {Triple} */
const allThree = [3, 8, 5];

/** @param {Triple} gains @param {string} rest */
const byHand = (gains, rest) => `lab&drives=hand&gains=${gains.join(',')}&${rest}`;

/** The fastest turn that the law asks for. @param {Engine} engine @param {Experiment} experiment @param {Triple} gains */
const fastestTurn = (engine, experiment, gains) =>
  engine
    .samples(experiment, gains)
    .map((one) => one)
    .reduce((a, b) => (Math.abs(b.command.angular) > Math.abs(a.command.angular) ? b : a));

/** Where the step's own drives end, and what they ask for on the way. */
const numbersOf = remember((/** @type {Engine} */ engine) => {
  const experiment = engine.experiment({ starts: [start] });
  const { error } = engine.samples(experiment, kxAlone).at(-1);
  const most = fastestTurn(engine, experiment, allThree);
  return {
    side: fixed(Math.abs(error.y), 2),
    turned: degreesText(Math.abs(error.theta)),
    most: signed(Math.abs(most.command.angular), 0),
    at: fixed(most.time, 2),
    leaves: signed(Math.abs(most.velocity.angular), 2),
  };
});

/** How a drive without ky ends. @param {Live} live */
function withoutKyFrom({ engine, scene }) {
  const samples = engine.samples(scene.experiment, withoutKy);
  const { error, outcome, time } = samples.at(-1);
  const arrived = outcome === 'arrived';
  const right = arrived ? 0 : Math.abs(error.theta) < 0.05 ? 1 : 2;
  return {
    right,
    arrived,
    error,
    time,
    farthest: samples.map(({ error }) => Math.abs(error.y)).reduce((a, b) => Math.max(a, b)),
  };
}

/** @type {Written} */
export const law = {
  figure: 'plane',
  time: ({ samples }) => largestAt(samples),
  overlay: true,
  stage: { place: 'under', pages: ['lab'], create: createPushes },
  blocks: [
    { kind: 'text', name: 'one' },
    { kind: 'text', name: 'written' },
    { kind: 'formula', formula: lawFormula },
    tries([
      ['onlyKx', byHand(kxAlone, below), 'robot'],
      ['onlyKt', byHand([0, 0, 5], below), 'robot'],
      ['onlyKy', byHand([0, 8, 0], below), 'robot'],
    ]),
    { kind: 'text', name: 'each' },
    quiz('beside', {
      shows: byHand(withoutKy, below),
      sight: 'robot',
      watch: true,
      order: [2, 1, 0],
      answer: withoutKyFrom,
    }),
    quiz('ahead', {
      shows: byHand(withoutKy, 'start=0,0,0'),
      sight: 'robot',
      watch: true,
      answer: withoutKyFrom,
    }),
    { kind: 'text', name: 'sideways' },
    tries([
      ['all', byHand(allThree, below), 'robot'],
      ['stuck', byHand(withoutKy, beside), 'robot'],
      ['shuffle', byHand(allThree, beside), 'robot'],
      [
        'unlimited',
        byHand(allThree, `${below}&limits.speed=off&limits.turnRate=off`),
        'stage',
        (engine, { experiment }) => fastestTurn(engine, experiment, allThree).time,
      ],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values: ({ engine }) => numbersOf(engine),
};
