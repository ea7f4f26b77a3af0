// Step 1 in English.
import { costText, fixed } from '../numbers.js';

/** @typedef {import('../../../engine.js').Run} Run */

export const drive = {
  title: 'Drive it yourself',
  texts: {
    begin: `This robot has two wheels and wants to park on the arrow in the corner: there, and pointing that way. Three numbers decide how it drives. With these three it does not get there.

Move the three sliders under the picture. Every change drives the robot again. Below the picture stands *J*, the price of the drive: it counts the time, how far from the goal the robot has been for how long, and how hard its wheels had to work. *Lower is better.*

*Can you get J below {=arbitrary}?* That is what the authors of the method reached without evolution.`,
    next: `You have just done what this page is about: you changed numbers at random or by feel, watched, and kept what was better. Evolution does the same, with twenty robots at a time and without growing tired. But first: what are these three numbers?`,
  },
  /** @param {import('../../../lesson/tally.js').Tally} tally */
  tally: ({ drives, best }) =>
    best
      ? `Your best so far: J ${costText(best.cost)}, with ${best.gains.map((gain) => fixed(gain, 2)).join(', ')}. ${drives === 1 ? '1 drive' : `${drives} drives`}.`
      : drives > 0
        ? `${drives === 1 ? '1 drive' : `${drives} drives`}, and none has arrived yet.`
        : 'You have not driven yet.',
  quizzes: {
    bolder: {
      question: 'All three numbers at 5, then all three at 10: what does it change?',
      choices: [
        'It arrives earlier, and J is lower',
        'It arrives earlier, but J is higher',
        'It arrives later',
      ],
      /** @param {{ gentle: Run, bold: Run }} outcome */
      why: ({ gentle, bold }) =>
        `With 5 it arrives after ${fixed(gentle.finalTime, 2)} s at J ${costText(gentle.cost.total)}, with 10 after ${fixed(bold.finalTime, 2)} s at J ${costText(bold.cost.total)}. A hard turn at the start costs energy: ${fixed(gentle.cost.energy, 2)} against ${fixed(bold.cost.energy, 2)}.`,
    },
  },
  tries: {
    noTurn: 'Only the first number: 3, 0, 0',
    noDrive: 'Only the third: 0, 0, 5',
    negative: 'The first below zero: −1, 1, 5',
    paper: 'The numbers that evolution found in the paper',
  },
  notice: [
    'Two drives can arrive at the same time and differ in J: what did the dearer one pay for? The bar under J says it.',
    'Small changes of a number change the drive a little, sometimes not at all, and now and then all at once.',
  ],
};
