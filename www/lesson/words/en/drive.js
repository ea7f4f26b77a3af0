// The step “drive” in English.
import { costText, fixed } from '../../../words/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */

export const drive = {
  texts: {
    begin: `This robot has two wheels. It wants to park on the arrow at the upper right: right there, and pointing that way. Three numbers decide how it drives. With 3, 0, 0 it stops {=miss} m away, for good.

Move the three sliders under the picture. At every change the robot drives again. The large number is *J*, the price of the drive: it adds up the time, how far from the goal the robot was and for how long, and how hard its wheels had to work. *Lower is better.*

*Can you get J below {=arbitrary}?* That is the J of the numbers that the authors of the method picked without evolution.`,
    next: `You have just done what this page is about: you changed numbers by feel, watched, and kept what was better. Evolution does the same, with twenty robots at a time, and does not tire. But what *are* these three numbers?`,
  },
  /** @param {import('../common.js').Drives} tally */
  tally: ({ drives, best }) =>
    best
      ? `Your best so far: J ${costText(best.cost)} with ${best.gains.map((gain) => fixed(gain, 2)).join(', ')}. ${drives === 1 ? '1 drive' : `${drives} drives`}.`
      : drives > 0
        ? `${drives === 1 ? '1 drive' : `${drives} drives`}, and none has arrived yet.`
        : 'You have not driven yet.',
  quizzes: {
    bolder: {
      question: 'All three numbers at 5, then all three at 10: what does it change?',
      choices: [
        'The robot arrives earlier, and J is lower',
        'It arrives earlier, but J is higher',
        'It arrives later',
      ],
      /** @param {{ gentle: Run, bold: Run }} outcome */
      why: ({ gentle, bold }) =>
        `With 5 it ${arrival(gentle)}, J ${costText(gentle.cost.total)}; with 10 it ${arrival(bold)}, J ${costText(bold.cost.total)}. The energy in it: ${fixed(gentle.cost.energy, 2)} and ${fixed(bold.cost.energy, 2)}; the path: ${fixed(gentle.cost.path, 2)} and ${fixed(bold.cost.path, 2)}.`,
    },
  },
  tries: {
    onlySecond: 'Only the second number: 0, 5, 0',
    noDrive: 'Only the third: 0, 0, 5',
    negative: 'The first below zero: −1, 1, 5',
    paper: 'The numbers that evolution found in the paper',
  },
  notice: [
    'Two drives can arrive at the same time and still differ in J. What did the dearer one pay for? The bar under J says it.',
    'A small change of a number mostly changes the drive a little, and now and then all at once.',
  ],
};

/** @param {Run} run */
const arrival = (run) => (run.arrived ? `arrives after ${fixed(run.finalTime, 2)} s` : 'does not arrive');
