// The step “paper” in English.
import { costText } from '../../../words/numbers.js';

export const paper = {
  texts: {
    same: `All that you have seen follows a paper of 1995, by Jong-Hwan Kim and Hyun-Sik Shim. It gives four drives with their gains and their J. A page that teaches should be able to show them again. Can it?`,
    order: `The *order* is the paper’s: the evolved gains are better than the arbitrary ones, with both kinds of limits. With velocity limits the arbitrary ones cost {=velocity} times as much here, {=paperVelocity} times in the paper; with acceleration limits {=acceleration} times, {=paperAcceleration} in the paper, because here they do not arrive at all. Our own evolution finds {kx} and {kt} of a similar size, and sends {ky} towards zero, as the paper’s did.

The *numbers themselves* are not the paper’s, and no honest program could make them so: J depends on weights and on rules that the paper does not give. We have not tuned them until it fits. This is what stands in the paper, and what we chose where it is silent:`,
    figure7: `One picture we cannot reproduce. In Figure 7 the heading of the arbitrary gains 30, 30, 30 stays below 60°. Here it swings up to {=swing}. We know no reading of the acceleration limit that gives the paper’s picture.`,
  },
  quizzes: {
    lower: {
      question:
        'For the drive of Figure 4(a) the paper gives J = 12.4685. With the very same gains, what does J come to here?',
      choices: ['The same', 'More', 'Less'],
      /** @param {{ here: number, there: number }} outcome */
      why: ({ here, there }) =>
        `Here it is ${costText(here)}, in the paper ${there}. The gains are printed, but not the weights inside J, nor when a drive counts as arrived: so the sum cannot be the same.`,
    },
  },
  tries: {
    horizon: 'Let every drive last 3 s instead of until it arrives, and evolve again',
    weights: 'Let the wheels’ work count twice: J grows, the drive is the same',
    figure7: 'Figure 7, arbitrary gains: look at the heading θ',
  },
  notice: [
    'With a fixed time of 3 s evolution finds a kx far from the paper’s. So in the paper a drive must have ended on arrival.',
    'Gains can be compared between two programs, and so can the order of two drives. A single J cannot, unless every weight is told.',
  ],
  /** @param {string} figure @param {'ep' | 'arbitrary'} method */
  row: (figure, method) => `Fig. ${figure}, ${method === 'ep' ? 'EP' : 'arbitrary'}`,
  /** @param {number} generations */
  ours: (generations) => `our EP, ${generations} generations, seed 1`,
  head: ['drive', 'kx, ky, kθ', 'J in the paper', 'J here'],
  choicesTitle: 'Stated, and chosen',
  choicesHead: ['', 'in the paper', 'here'],
  /** @param {import('../common.js').Choices} e */
  choices: (e) => [
    ['start', 'not given; the plots begin at 0', e.start],
    ['goal', '2 m, 2 m, 45°', e.goal],
    ['largest speed', '2 m/s', `${e.speed} m/s`],
    [
      'largest turn rate',
      '“2(rad/s)”, where Greek letters are lost; the plots reach beyond 5',
      `${e.turnRate}π rad/s`,
    ],
    ['largest accelerations', '5 and “5”', `${e.acceleration} m/s², ${e.turnAcceleration}π rad/s²`],
    ['weights W, R', 'positive, not given', `${e.weights}; ${e.velocityWeights}`],
    ['penalty κ', 'positive, not given', e.penalty],
    [
      'end of a drive',
      '“final or arriving time”',
      `within ${e.position} cm and ${e.heading}, or after ${e.horizon} s`,
    ],
    ['robots N', 'not given', e.population],
    ['opponents', e.opponents, e.opponents],
    ['first gains, first σ', '0.01 to 10; 1', `${e.range.join(' to ')}; ${e.sigma}`],
    ['between samples', '0.01 s; motion not given', `${e.sampleTime} s; exact arcs`],
  ],
};
