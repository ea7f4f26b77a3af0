// The step “law” in English.
import { degreesText, fixed } from '../../../words/numbers.js';

/** @typedef {import('../../../core/engine.js').Posture} Posture */

export const law = {
  texts: {
    one: `This robot starts below the goal, so none of the three errors is 0. *Only {kx} is on*; the other two gains are 0. It drives until {xe} is gone and stays there: {=side} m to the side, and turned wrong by {=turned}.

A *gain* says how hard one error pushes. Each bar is one push at this moment, on the speed {v} or on the turn rate {w}. Added up, they are what the *law* asks for; the law is the rule that turns the errors into {v} and {w}. The bars in the picture show them. Beyond the dashed lines, in grey: more than the wheels can do.`,
    written: `The time under the picture, the robot’s *clock*, stands where the law asks for most. Move it, and the bars follow the robot; move a slider, and they change at once. The formula, the paper’s (5) for a goal at rest, says the same: point at a term, or touch it, and its slider, its pushes and its errors light up.`,
    each: `So, first of all, each gain looks after one error: {kx} after {xe}, {kt} after {te}, {ky} after {ye}. But {kx} has a second push, the last term of {w}: while {xe} is left, and the robot faces less than 90° off the goal’s direction, it also steers it towards the goal’s line. (What it and the term with {ky} cancel, the next step shows.) Now two gains together.`,
    sideways: `Why does the {ky} term divide by sin {te}? The robot cannot drive sideways. To get over to the side it must turn a little, and drive; the less it has turned, the farther it must drive. When it has hardly turned at all, the law asks for the impossible, and most of all in {w}, where the term that goes with this one divides by the square: from the start with which this step opens, [the gains 3, 8, 5](lab&drives=hand&gains=3,8,5&start=1.5,0.5,0) ask for {=most} rad/s after {=at} s, and the wheels do {=leaves}.`,
    next: `Five terms, and none spoils the work of another? They were made that way. There is one quantity that they only bring down, as long as the gains are above zero and the wheels do what is asked at every instant.`,
  },
  pushes: {
    tableLabel: 'What each term of the law adds now',
    strip: 'The pushes over the whole drive, and the time of the robots in it',
    stripKey: 'Solid: kx, long dashes: ky, short: kθ, pale: the sum of all.',
    stripHint: 'Drag to move the clock.',
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
        'On the goal, pointing the right way',
        'Beside the goal, pointing the right way',
        'Near the goal, pointing the wrong way',
      ],
      /** @param {{ arrived: boolean, error: Posture, time: number }} outcome */
      why: ({ arrived, error, time }) =>
        arrived
          ? `It arrives after ${fixed(time, 2)} s.`
          : `It stops ${fixed(Math.hypot(error.x, error.y), 2)} m from the goal: {xe} is ${fixed(error.x, 2)} m, {te} is ${degreesText(error.theta)}, and {ye} is ${fixed(error.y, 2)} m. With {ky} = 0, and {xe} and sin {te} at zero, every push is zero.`,
    },
    ahead: {
      question: 'The same gains, {ky} still 0, but from the paper’s own start: 0 m, 0 m, 0°. And now?',
      choices: ['It arrives', 'It stops beside the goal again', 'It comes near, pointing the wrong way'],
      /** @param {{ arrived: boolean, error: Posture, time: number, farthest: number }} outcome */
      why: ({ arrived, error, time, farthest }) =>
        arrived
          ? `It arrives after ${fixed(time, 2)} s, ${fixed(Math.abs(error.y), 2)} m to the side. This start lies straight behind the goal. Turning takes the robot ${fixed(farthest, 2)} m off that line, no more, and the {kx} term of {w} steers it back. {ky} is not needed here. Remember that.`
          : `It ends with {xe} at ${fixed(error.x, 2)} m, {ye} at ${fixed(error.y, 2)} m and {te} at ${degreesText(error.theta)}.`,
    },
  },
  tries: {
    onlyKx: '{kx} alone: 3, 0, 0',
    onlyKt: '{kt} alone: 0, 0, 5. It turns on the spot, since {v} has no such term',
    onlyKy: '{ky} alone: 0, 8, 0. Where {ye} is 0, it does nothing',
    all: 'All three: 3, 8, 5',
    stuck: 'Start beside the goal with {ky} = 0: nothing moves',
    shuffle:
      'The same with {ky} = 8: it goes to and fro, as one does in a parking space, and so comes nearer bit by bit',
    unlimited:
      'All three on wheels without limits: the clock stops where {w} is largest. Look at its bar, then let the robot drive on',
  },
  notice: [
    'Where {ye} is 0, all terms but two are 0: {kx} drives and {kt} turns.',
    'A bar with an arrow leaves the picture: the law asks for more than fits into it, and mostly for more than the wheels can do.',
    'In {w} each gain has a term, in {v} only {kx} and {ky} have one.',
    'What to do at sin {te} = 0 the paper does not say. Here its size is never taken as less than 0.000001. That the law breaks down somewhere is no clumsiness: no smooth law that looks at the posture alone can park such a robot (Brockett 1983). But that asks for no division by zero far from the goal: sin {te} below the line is this law’s own choice.',
  ],
};
