// The step “landscape” in English.
import { costText, fixed, threeDigits } from '../../../words/en/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */
/** @typedef {import('../common.js').Lowest} Lowest */

export const landscape = {
  texts: {
    map: `Every point of the map with which this step opens is a robot. {kx} grows to the right, {kt} upwards, {ky} is the same everywhere. The colour is its {J}; dark is good. {=drives} robots have driven for the picture. *Press anywhere, and that robot drives.*

The white dots are the population. *Press Run* and watch it walk: the line is the path of its best robot. It is in generation {=generation} now, after {=spent} drives. And it *never sees the map*. Evolution knows {J} only where one of its robots stands.`,
    shape: `Three things on the opening map deserve a name. The *valley* is dark: {=floor}\u00a0% of that map cost at most 5 % more than the lowest of its points (four short strokes mark it), so very different gains can be almost equally good. At the *edge* dark turns bright yellow at once: beyond it the robots do not arrive, and pay for all {=horizon} seconds. The *ripples* come from the law: it divides by sin {te}, and where {te} passes through zero just at a sample, the wheels run at their limits for that sample, which costs energy.

Why search at all, if one can drive the whole map? Because it is a map of *two* gains. A grid as fine over all three would be {=grid} drives, and each further gain would multiply that by {=side}.

A method that follows the slope stumbles over edges and ripples, and may stop in a *local optimum*: a place that is better than all around it, but not the best. Evolution needs no slope: it only compares. That makes it sturdy, not infallible.`,
    next: `With most seeds evolution comes near the lowest point of *one* landscape, which belongs to one start and one goal. Has the robot learned to park, or only to park from there? Step 12 asks. First: which part of the method did the work?`,
  },
  quizzes: {
    turn: {
      question:
        'The goal turns on the spot, from 45° to 90°. Nothing else changes. What becomes of the lowest point?',
      choices: [
        'It stays where it is',
        'It moves, but with the old gains the robot still arrives',
        'It moves, and with the old gains the robot does not arrive any more',
      ],
      /** @param {{ old: Lowest, now: Lowest, left: Run, again: string }} outcome `again` opens the drive with the old gains. */
      why: ({ old, now, left, again }) =>
        `At 45° it was at ${place(old)}, with {J} ${costText(old.cost)}. Now it is at ${place(now)}, with {J} ${costText(now.cost)}. [Drive with the gains of the old lowest point](${again}): {J} ${costText(left.cost.total)}, the robot ${arrival(left)}. The wide valley has become a gorge between two edges. Drag the goal and watch the land change.`,
    },
    ky: {
      question: 'Back to 45°, and now {ky} goes upwards. Where along {ky} is the lowest point?',
      choices: [
        'In the middle: the law needs all three gains',
        'At the lower border: {ky} is best at zero',
        'At the upper border: more correction is better',
      ],
      /** @param {{ lowest: Lowest, middle: Run, wall: Run }} outcome */
      why: ({ lowest, middle, wall }) =>
        `The lowest point of the map is at {ky} ${fixed(lowest.gains[1], 2)}, with {J} ${costText(lowest.cost)}; straight above, at {ky} ${threeDigits(lowest.most / 2)}, {J} is ${costText(middle.cost.total)}. So the best walks down to the border. Beyond it stands a wall: at {ky} −0.01 {J} is ${costText(wall.cost.total)}, of which ${costText(wall.cost.penalty)} are the penalty for negative gains, and the robot ${wall.arrived ? 'arrives' : 'does not arrive'}.`,
    },
  },
  tries: {
    walked: 'A hundred generations later',
    smooth: 'The same map with {ky} = 0: no ripples',
    deep: '{ky} upwards, as a logarithm: the path leaves the map at the bottom. The line under the map says how small {ky} is',
    stuck: 'The goal at 0°, seed 3: stuck in a gorge',
  },
  notice: [
    'Most of the time the best stands still. Now and then an offspring lands on better ground, and the line jumps.',
    'The thin cross through a dot shows its step sizes σ. In the gorge of the last thing to try they have shrunk to nothing: the robots see no way on, though {J} falls to the left.',
    'The dots have a {ky} of their own, so the colour under a dot is not quite its {J}.',
    'The paper’s EP gains lie in the valley too, though the paper does not tell its weights. Its arbitrary gains do not.',
  ],
};

/** @param {Lowest} lowest */
const place = ({ gains: [kx, , ktheta] }) => `{kx} ${fixed(kx, 2)}, {kt} ${fixed(ktheta, 2)}`;

/** @param {Run} run */
const arrival = (run) =>
  run.arrived
    ? `arrives after ${fixed(run.finalTime, 2)} s`
    : `has not arrived after ${fixed(run.finalTime, 0)} s`;
