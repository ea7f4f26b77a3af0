// The step “drive” in English.
import { changeText, costText, fixed } from '../../../words/en/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */

export const drive = {
  texts: {
    begin: `This robot has two wheels and should park on the arrow at the upper right: exactly there, and pointing that way. The model of robots that can drive and turn on the spot but never move sideways is called the *unicycle*. Three numbers, the *gains*, decide how this one drives.

Move the three sliders under the picture. Each time you change a number, the robot drives again. The large number is *J*, the *cost* of the drive: it adds up the *time* the robot took, how far from the goal it was all the way (*path*) and at the end (*final*), and how fast it drove and turned (*energy*). *Lower is better.*

The paper that this page follows compares *arbitrary* gains, picked without evolution (here J is {=arbitrary}), with those that *evolutionary programming*, EP for short, found ({=ep}). *Can you get below both?*`,
    next: `You changed numbers by feel, watched, and kept what was better. From one start that is not hard. Soon it will be: the same three numbers must park robots from everywhere, and then evolution does what you did, with twenty robots at a time, and does not tire. But what *are* these three numbers?`,
  },
  /** @param {import('../common.js').Drives} tally */
  tally: ({ drives, best }) =>
    best
      ? `Your best so far: J ${costText(best.cost)} with ${best.gains.map((gain) => fixed(gain, 2)).join(', ')}. ${drives === 1 ? '1 drive' : `${drives} drives`}.`
      : drives > 0
        ? drives === 1
          ? '1 drive, and it has not arrived.'
          : `${drives} drives, and none has arrived yet.`
        : 'You have not moved a slider here yet. A drag of one counts as one drive.',
  quizzes: {
    bolder: {
      question: 'Suppose all three numbers are 5, and then all three 10. What changes?',
      choices: [
        'The robot arrives earlier, and J is lower',
        'It arrives earlier, but J is higher',
        'It arrives later',
      ],
      /** @param {{ gentle: Run, bold: Run }} outcome */
      why: ({ gentle, bold }) =>
        `With 5 it ${arrival(gentle)}, J ${costText(gentle.cost.total)}; with 10 it ${arrival(bold)}, J ${costText(bold.cost.total)}. From 5 to 10 its parts change: time ${changeText(bold.cost.time - gentle.cost.time)}, path ${changeText(bold.cost.path - gentle.cost.path)}, energy ${changeText(bold.cost.energy - gentle.cost.energy)}. Both are drawn: the drive with 5 is *pinned*, the dashed line in colour.`,
    },
  },
  tries: {
    stops: 'Only the first number: 3, 0, 0. Where does it stop, and why there?',
    onlySecond: 'Only the second: 0, 5, 0',
    noDrive: 'Only the third: 0, 0, 5',
    negative: 'The first below zero: −1, 1, 5. {J} then has a penalty, too',
    paper: 'The numbers that evolution found in the paper',
  },
  notice: [
    'Two drives may take equally long and still differ in J. What did the costlier one pay for? The bar under J shows it.',
    'A small change of a number mostly changes the drive a little, and now and then all at once.',
  ],
};

/** @param {Run} run */
const arrival = (run) => (run.arrived ? `arrives after ${fixed(run.finalTime, 2)} s` : 'does not arrive');
