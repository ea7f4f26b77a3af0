// Step 2 in Korean.
import { degreesText, fixed } from '../numbers.js';

export const error = {
  title: 'Where is the goal?',
  texts: {
    three: `The robot knows where it is and where it shall be. What it steers by is the difference, taken apart in a clever way: not along the walls of the room, but along the direction in which it shall stand in the end.

{xe} is how far it still has to go *along* that direction, {ye} how far it is off *to the side*, {te} how much it still has to *turn*. At this moment {xe} is {=xe} m, {ye} is {=ye} m and {te} is {=te}. Drag the start or the goal and watch the three change; move the robot with its clock.`,
    signs: `Point at a symbol: it lights up in the formula and in the picture. All three are zero when the robot is parked, and only then. So parking means: *bring three numbers to zero with two controls*, the speed {v} and the turn rate {w}. It cannot move sideways. That is what makes parking hard.`,
  },
  quizzes: {
    largest: {
      question:
        'The robot starts at 0 m, 2 m, exactly left of the goal, which still points to the upper right. Which is longer, {xe} or {ye}?',
      choices: ['{xe} is longer', 'They are equally long, or {ye} is longer'],
      /** @param {{ x: number, y: number, theta: number }} outcome */
      why: ({ x, y, theta }) =>
        `{xe} is ${fixed(x, 2)} m and {ye} is ${fixed(y, 2)} m: the goal points at 45°, just between “ahead” and “to the side”. {te} is ${degreesText(theta)}.`,
    },
  },
  tries: {
    beside: 'Start beside the goal, already pointing the right way',
    beyond: 'Start beyond the goal: it has to come back',
    round: 'Start on the goal, pointing the wrong way',
  },
  notice: [
    '{xe} and {ye} change while the robot only drives straight, {te} does not.',
    '{xe} is below zero when the goal lies behind.',
  ],
};
