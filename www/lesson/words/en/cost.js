// The step “cost” in English.
import { costText, fixed } from '../../../words/en/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */

export const cost = {
  texts: {
    parts: `Hasty drives, patient ones, some that never arrive: which is *good*? Somebody has to decide, and to say it in one number. The authors add up five parts:`,
    each: `The *time* {tf} until the robot arrives, or, without that, until the end of the drive, the *horizon*. The *final* error: how far off the robot is at the end, in place and in heading, squared. The *path*: not its length, though the paper calls it “shortest path”, but the error on the way, in place and in heading, squared and integrated over time: staying far away for long is costly. The *energy*: speed and turn rate, squared and integrated. Both integrals count half; that makes the energy {=energy} in this drive. And a *penalty* for gains below zero. ({p} is the posture, {pr} that of the goal, {q} holds {v} and {w}. Where something stands twice, first with T, its entries are squared, multiplied by their weights, if any, and added.) Point at a part, or touch it: its piece of the bar lights up.`,
    weights: `What is a second worth, and what a hard turn? The *weights* say so: {Rv} and {Rw}, together {R}, for driving and turning, {W} for the final error, {kappa} for the penalty. *The paper does not give them.* We chose 1, and 1000 for {kappa}. With other weights another drive is the best. Four drives are in the picture: press one to drive it, and move the weights.`,
    ky: `And {ky}? With our weights, velocity limits alone and the paper’s start, {kx} = 3 and {kt} = 5 cost {=none} if {ky} is 0, {=one} if it is 1, {=eight} if it is 8. Nothing there needs it, for the start lies straight behind the goal: it only costs. J counts this one drive and no other. Keep that in mind.`,
    next: `So evolution gets one number to bring down. That is all it ever learns of the robot. How does it search?`,
  },
  standings: {
    caption: 'Drives and what they cost with these weights',
    /** @param {string} seconds */
    dots: (seconds) => `A dot every ${seconds} s: far apart is fast. Pale: the other drives.`,
    gentle: 'Gentle',
    lowest: 'lowest',
    nobody: 'Move a gain, and your own drive stands here.',
  },
  quizzes: {
    heavier: {
      question:
        'With {Rv} and {Rw} at 1 the paper’s EP gains cost less than the arbitrary and the gentle ones. At 5, driving and turning cost five times as much. Which cost least then?',
      choices: [
        'The EP gains again: evolution found them',
        'The arbitrary gains: they arrive first',
        'The gentle gains: they drive slowly',
      ],
      /** @param {{ runs: Run[] }} outcome */
      why: ({ runs: [ep, arbitrary, gentle] }) =>
        `Now J is ${costText(ep.cost.total)} for the EP gains, ${costText(arbitrary.cost.total)} for the arbitrary and ${costText(gentle.cost.total)} for the gentle ones. Energy alone is ${fixed(ep.cost.energy, 1)}, ${fixed(arbitrary.cost.energy, 1)} and ${fixed(gentle.cost.energy, 1)} of it. The drives are what they were; the weights have changed.`,
    },
    home: {
      question:
        'Both weights at 100, and a robot with all gains at 0: it stays where it is for 10 s and never arrives. The gentle one arrives. Whose J is lower?',
      choices: [
        'That of the gentle one: it does its task',
        'That of the robot that stays at home: it spends no energy',
      ],
      /** @param {{ stays: Run, drives: Run }} outcome */
      why: ({ stays, drives }) =>
        `Staying costs ${costText(stays.cost.total)}: time ${fixed(stays.cost.time, 0)}, path ${fixed(stays.cost.path, 1)}, final ${fixed(stays.cost.finalError, 1)}. The gentle drive costs ${costText(drives.cost.total)}, of which energy ${fixed(drives.cost.energy, 1)}. J knows nothing of what we meant. It counts what it is told to count.`,
    },
  },
  tries: {
    cheap: 'Moving is cheap, both weights 0.1: now haste wins',
    evolved: 'Both weights 100: what 60 generations of evolution make of it',
    final: 'Both weights 100 and {W} 100 too: staying at home is costly again',
    negative: 'A gain a little below zero, {ky} = −0.01: the penalty, and a robot that no longer arrives',
  },
  notice: [
    'A weight changes no drive. It changes its price, and so which drive evolution will keep.',
    'A robot that arrives pays almost nothing for the end: here, arriving means within 5 cm and 0.05 rad.',
  ],
};
