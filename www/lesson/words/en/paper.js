// The step “paper” in English.
import { costText } from '../../../words/en/numbers.js';

export const paper = {
  texts: {
    same: `The robot, the law and EP come from a paper of 1995, by Jong-Hwan Kim and Hyun-Sik Shim. It gives four drives with their gains and their J. A page that teaches should be able to show them again. Can it?`,
    order: `The *order* is the paper’s: the evolved gains are better than the arbitrary ones, with both kinds of limits. With velocity limits the arbitrary ones cost {=velocity} times as much here, {=paperVelocity} times in the paper; with acceleration limits {=acceleration} times, {=paperAcceleration} in the paper, because here they do not arrive at all. Our own evolution finds {kx} and {kt} of a similar size (with acceleration limits {kx} comes out a third smaller), and sends {ky} towards zero, as the paper’s did.

The *numbers themselves* are not the paper’s, and no honest program could make them so: J depends on weights and on rules that the paper does not give. We have not tuned them to make the numbers fit. This is what stands in the paper, and what we do:`,
    printed: `With the energy as (9) prints it, of the *commanded* velocity, our J of the four drives would be {=printed}.`,
    figure7: `One picture we cannot reproduce. In Figure 7 the heading of the arbitrary gains 30, 30, 30 stays below 60°. Here it swings up to {=swing}. We know no reading of the acceleration limit that gives the paper’s picture.`,
  },
  quizzes: {
    literal: {
      question:
        'The paper’s (9) prints the *commanded* velocity in the energy; we count what the wheels really do. Take it literally, for the arbitrary gains of Figure 4(b): what becomes of our J?',
      choices: [
        'It hardly changes',
        'It becomes two to three times as much',
        'It becomes far more than that',
      ],
      /** @param {{ here: number, literal: number, there: number }} outcome */
      why: ({ here, literal, there }) =>
        `${costText(literal)} instead of ${costText(here)}; the paper prints ${there}. A few samples near the goal, where the law divides by almost nothing, outweigh the whole drive. With our weights that is out of all proportion. One word in a formula decides what “the same J” is.`,
    },
  },
  tries: {
    speed:
      'When has a robot parked? Figure 6(a)’s gains, when {v} must be below 0.05 m/s as well: look at {v} and at the distance',
    horizon: 'Let every drive last 3 s instead of until it arrives, and evolve again',
    shortCheap: 'The same 3 s, and energy at a tenth: {R} = 0.1, 0.1. Where is {kx} now?',
    weights: 'Let energy count twice: J grows, the drive is the same',
    figure7: 'Figure 7, arbitrary gains: look at the heading θ',
  },
  notice: [
    'With a fixed time of 3 s *and our weights* evolution finds a {kx} far from the paper’s. With energy at a tenth it finds 2.9, near the paper’s 3.24. So nothing follows about how the paper’s drives ended.',
    'Arriving looks at place and heading, not at speed: the gains of Figure 6(a) “arrive” at 1.25 m/s, overshoot by 11 cm, and stay within the tolerances only from 2.07 s on. If a parked robot must also be slower than 0.05 m/s, they arrive after 2.35 s instead of 1.64 s, and J is 9.060 instead of 8.271. The settings let you choose.',
    'With other weights other gains are best, and even the order of two drives may be reversed (step 6). So two programs can be compared only where every weight is stated.',
  ],
  /** @param {string} figure @param {'ep' | 'arbitrary'} method */
  row: (figure, method) => `Fig. ${figure}, ${method === 'ep' ? 'EP' : 'arbitrary'}`,
  /** @param {number} generations */
  ours: (generations) => `our EP, ${generations} generations, seed 1`,
  head: ['drive', '{kx}, {ky}, {kt}', 'J in the paper', 'J here'],
  choicesTitle: 'Stated, and chosen',
  choicesHead: ['', 'in the paper', 'here'],
  /** @param {import('../common.js').Choices} e */
  choices: (e) => [
    ['start', 'not given; the plots begin at 0', e.start],
    ['goal', '2 m, 2 m, 45°', e.goal],
    ['largest speed', '2 m/s', `${e.speed} m/s`],
    [
      'largest turn rate',
      '“2(rad/s)” in our copy of its text, where Greek letters are lost; the ω axis of its plots goes to 10',
      `${e.turnRate}π rad/s`,
    ],
    ['largest accelerations', '5 and “5”', `${e.acceleration} m/s², ${e.turnAcceleration}π rad/s²`],
    ['weights W, R', 'positive, not given', `${e.weights}; ${e.velocityWeights}`],
    ['penalty κ', 'k, positive, not given', e.penalty],
    [
      'end of a drive',
      '“final or arriving time”',
      `within ${e.position} cm and ${e.heading}, or after ${e.horizon} s`,
    ],
    ['robots N', 'not given', e.population],
    ['opponents', e.opponents, e.opponents],
    ['first gains, first σ', '0.01 to 10; 1', `${e.range.join(' to ')}; ${e.sigma}`],
    ['between samples', '0.01 s; motion not given', `${e.sampleTime} s; exact arcs`],
    ['energy in (9)', 'of {qm}, the commanded velocity', 'of the limited velocity'],
    ['the integral', 'not given', 'sum of left rectangles'],
    [
      'heading in p',
      '“meter meter degree”',
      'radians: in degrees the path alone costs 103.9 (EP) and 62.8 (arbitrary), which reverses the order',
    ],
    [
      'velocity on arrival',
      'Theorem 1: “the reference velocity”',
      'not looked at, unless the settings ask for it',
    ],
    ['at the start', 'not given', 'the robot is at rest'],
    ['disturbance {delta}', '{qm} + {delta}, put into (2)', 'added after the limits'],
    ['division by sin {te}', 'not given', 'by at least 0.000001, with its sign'],
    ['draws of a mutation', '{Ni}, i counts robots', 'one for each component, and one shared by all three σ'],
    ['who meets whom', 'random opponents', 'with replacement, never oneself; ties by J, then by number'],
  ],
};
