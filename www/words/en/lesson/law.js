// Step 3 in English.
import { degreesText, fixed } from '../numbers.js';

/** @typedef {import('../../../engine.js').Posture} Posture */

export const law = {
  title: 'The law, term by term',
  texts: {
    one: `This robot starts below the goal, so that all three errors are there. *Only {kx} is on*: the other two gains are 0. It drives until {xe} is gone, and stays there: {=side} m to the side, and turned wrong by {=turned}.

A *gain* says how hard a part of the error pushes. Each bar is one push at this moment, on the speed {v} or on the turn rate {w}; together they are what the law asks for. What lies in the grey the wheels cannot do.`,
    written: `Hold the clock where the bars are long, then move a slider. The same as a formula: point at a term, and its slider, its bars and the errors in it light up.`,
    each: `So each gain looks after one error: {kx} after {xe}, {kt} after {te}, {ky} after {ye}. Now two of them together.`,
    sideways: `Why does {ky} divide by sin {te}? The robot cannot drive sideways. To get over a little it must be turned and drive: the less it is turned, the farther. Turned hardly at all, it is asked for the impossible: on the way from below the goal, 3, 8, 5 ask for a turn of up to {=most} rad/s. The limits leave {=leaves}.

At sin {te} = 0 the paper does not say what to do. We chose never to divide by less than 0.000001.`,
    next: `Five terms, and none of them spoils what another one does? They were made that way: there is one quantity that, with positive gains and no limits in the way, they only bring down.`,
  },
  pushes: {
    tableLabel: 'What each term of the law adds now',
    speed: 'in m/s',
    turnRate: 'in rad/s',
    moving: 'from the moving goal',
    asked: 'asked for',
    left: 'after the limits',
    otherLaw: 'Now Kanayama’s rule drives, so the terms of (5) are not shown.',
  },
  quizzes: {
    beside: {
      question: '{kx} is 3, {kt} is 5, {ky} is 0: nothing looks after {ye}. Where does the robot end?',
      choices: [
        'On the goal: the other two bring it there',
        'Beside the goal, pointing the right way',
        'Near the goal, pointing the wrong way',
      ],
      /** @param {{ arrived: boolean, error: Posture, time: number }} outcome */
      why: ({ arrived, error, time }) =>
        arrived
          ? `It arrives after ${fixed(time, 2)} s.`
          : `It parks ${fixed(Math.hypot(error.x, error.y), 2)} m from the goal: {xe} is ${fixed(error.x, 2)} m, {te} is ${degreesText(error.theta)}, and {ye} is ${fixed(error.y, 2)} m. With {xe} and sin {te} at zero, every push is zero.`,
    },
    ahead: {
      question: 'The same gains, {ky} still 0, but from the paper’s own start: 0 m, 0 m, 0°. And now?',
      choices: ['It arrives', 'It parks beside the goal again', 'It comes near, pointing the wrong way'],
      /** @param {{ arrived: boolean, error: Posture, time: number, farthest: number }} outcome */
      why: ({ arrived, error, time, farthest }) =>
        arrived
          ? `It arrives after ${fixed(time, 2)} s, ${fixed(Math.abs(error.y), 2)} m to the side. This start lies straight behind the goal. Turning takes the robot ${fixed(farthest, 2)} m off that line, no more, and the {kx} term of {w} steers it back. Nobody misses {ky} here. Remember that.`
          : `It ends with {xe} at ${fixed(error.x, 2)} m, {ye} at ${fixed(error.y, 2)} m and {te} at ${degreesText(error.theta)}.`,
    },
  },
  tries: {
    onlyKx: '{kx} alone: 3, 0, 0',
    onlyKt: '{kt} alone: 0, 0, 5. It turns on the spot, for {v} has no such term',
    onlyKy: '{ky} alone: 0, 8, 0. It minds {ye} and nothing else',
    all: 'All three: 3, 8, 5',
    stuck: 'Start beside the goal with {ky} = 0: nothing moves',
    shuffle: 'The same with {ky} = 8: it shuffles over, as one does in a parking space',
    unlimited: 'All three on wheels without limits: the robot spins',
  },
  notice: [
    'Where {ye} is 0, all terms but two are 0: {kx} drives and {kt} turns.',
    'A bar with an arrow leaves the picture: then the limits drive, not the law.',
    'In {w} each gain has a term, in {v} only two.',
  ],
};
