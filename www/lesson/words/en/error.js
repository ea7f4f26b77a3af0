// The step “error” in English.
import { degreesText, fixed } from '../../../words/numbers.js';

export const error = {
  texts: {
    three: `The robot knows where it is and where it should be, and steers by the difference. It does not measure that difference along the walls of the room, but along the *direction in which it will end up pointing*.

{xe} is how far it still has to go *along* that direction, {ye} how far it is off *to the side*, {te} how far it still has to *turn*. At this moment {xe} is {=xe} m, {ye} is {=ye} m and {te} is {=te}. Move the robot along its way with the slider of time under the picture, or drag the start or the goal, and watch the three. In the formula the index c means the robot’s *current* posture (its place and heading), r the *reference*, the goal.`,
    signs: `Point at a symbol, or touch it: it lights up in the formula and in the picture. These three *errors* are zero when the robot is parked, and only then. (A little is forgiven; step 6 says how much.) So parking means *bringing three numbers to zero by choosing two*: the speed {v} and the turn rate {w}. The robot cannot move sideways, and yet it can get anywhere: that makes it *nonholonomic*, and parking hard. How should it choose?`,
  },
  quizzes: {
    largest: {
      question:
        'The robot starts at 0 m, 2 m, straight to the left of the goal, which still points to the upper right. Signs aside, which is longer, {xe} or {ye}?',
      choices: ['{xe}', '{ye}', 'They are equally long'],
      /** @param {{ x: number, y: number, theta: number }} outcome */
      why: ({ x, y, theta }) =>
        `At the start {xe} is ${fixed(x, 2)} m, {ye} is ${fixed(y, 2)} m and {te} is ${degreesText(theta)}. The lengths are measured along the goal’s direction, not along the walls: at 45°, “to the left” is as much “behind” as “beside”.`,
    },
  },
  tries: {
    beside: 'Start beside the goal, already pointing the right way',
    beyond: 'Start beyond the goal: it has to come back',
    turned: 'Start on the goal, turned wrong by 90°',
  },
  notice: [
    'While the robot drives straight, only {xe} and {ye} change; while it turns on the spot, only {te}.',
    '{xe} is below zero when the robot stands beyond the goal, {ye} when the robot, whichever way it faces, is left of the *goal’s line*: the one through the goal in its direction.',
    'Near the goal some drives zigzag: how they steer has a division by sin {te} in it. Step 3 tells why.',
  ],
};
