// The step “limits” in English.
import { largest } from '../../../kit/extent.js';
import { costText, fixed, grouped } from '../../../words/en/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */
/** @typedef {{ run: Run, rises: number }} Driven */

export const limits = {
  asked: {
    /** @param {string} asked @param {string} done */
    label: (asked, done) =>
      `What the law asks for and what the wheels do, against time. The law asks for up to ${asked} rad/s, the wheels turn at up to ${done} rad/s.`,
    linear: 'v in m/s, log',
    angular: 'ω in rad/s, log',
    asked: 'asked',
    done: 'done',
    limit: 'limit',
  },
  texts: {
    asked: `The law asks, the wheels answer. In the drive of the paper’s EP gains the law asks for up to {=askedV} m/s and {=askedW} rad/s. The paper’s robot can do {=v} m/s and {=w} rad/s. In the picture (logarithmic, except near 0) the thin line is what was asked, the thick one what was done: what is beyond the limit, the dashed line, is cut off. Engineers call that *saturation*. The robot drives at full speed for most of the way.

Would it be better without limits? The proof of step 4 assumes none.`,
    theory: `Between the proof and a real robot there is a gap: the proof wants the law to act *at every instant*, but a computer decides once every hundredth of a second, at each *sample*, and holds its command until the next. A huge command that is held turns the robot much too far; a faster computer helps little, because where sin {te} is 0 the command has no bound. So {V} need not fall from sample to sample: without limits these gains let it rise at {=rises} of {=samples} samples. (Such a drive is *sensitive*: the last digits of the arithmetic decide exactly how many.)

Do velocity limits close that gap? From the paper’s own start it looks so: with them {V} falls at every sample.`,
    clipped: `The terms of {v} and of {w} cancel each other only together. Limits clip {v} and {w} *separately*, each to its own limit, and then what should cancel no longer does. (If one factor slowed both, {V} would go on falling.) And commands are held from sample to sample as before. So with limits, too, {V} may rise for a while; the proof promises nothing about a robot whose wheels are saturated. Limits of *acceleration* add to it: the robot answers late, and cannot brake where the law wants it to.`,
    next: `So there is no gain that is best by theory. What is best depends on the wheels, on the start, and on what one calls “good”. That word comes next.`,
  },
  quizzes: {
    free: {
      question: 'The paper’s EP gains without any limit of speed or turning: what does J do?',
      choices: ['It falls', 'It stays about the same', 'It rises'],
      /** @param {{ free: Driven, limited: Driven }} outcome */
      why: ({ free, limited }) =>
        `J is ${costText(free.run.cost.total)} instead of ${costText(limited.run.cost.total)}, and the robot ${arrival(free.run)}. Near the goal {te} is almost 0, the law divides by its sine, and the command jumps between huge values of both signs, which engineers call *chattering*: the largest turn rate is ${grouped(Math.round(largest(free.run.angular.map(Math.abs))))} rad/s, and energy counts its square.`,
    },
    heals: {
      question:
        'The velocity limits are on, and the paper’s EP gains drive from 100 starts, 1 to 4 m from the goal and pointing anywhere. In how many of the drives does {V} rise at least once?',
      choices: ['In fewer than 10', 'In 10 to 50', 'In more than half'],
      /** @param {{ drives: number, starts: number }} outcome */
      why: ({ drives, starts }) =>
        `In ${drives} of ${starts}. In the drive on the plane, from yet another start, it rises too: where the line of {V} is thick, with marks below.`,
    },
    brakes: {
      question:
        'Gains 10, 10, 10 arrive early with velocity limits. Now acceleration is limited as well. When do they arrive?',
      choices: ['Earlier', 'A little later', 'Much later, or never'],
      /** @param {{ limited: Driven, sluggish: Driven }} outcome */
      why: ({ limited, sluggish }) =>
        `With velocity limits the robot ${arrival(limited.run)}; with acceleration limits it ${arrival(sluggish.run)}, and {V} rises at ${sluggish.rises} samples (before: ${limited.rises}). Bold gains need quick wheels. J: ${costText(limited.run.cost.total)} and ${costText(sluggish.run.cost.total)}.`,
    },
  },
  tries: {
    raised: 'The to-and-fro of step 3 with the limits on: {V} rises, and yet the robot comes nearer',
    figure4: 'Figure 4: EP’s gains and the arbitrary ones, velocity limits',
    figure5: 'Figure 5: the same against time',
    figure6: 'Figure 6: EP’s gains for acceleration limits',
    figure7: 'Figure 7: the same against time',
  },
  notice: [
    'With acceleration limits the speed begins at 0 and climbs along a straight line: no command can start the wheels at once.',
    'In our Figure 7 the dotted robot has the arbitrary gains that the paper picked for these wheels, 30, 30, 30. It turns far beyond its goal and back, and never arrives. The paper’s does not turn so far: step 14 returns to this.',
    'In the curves of {v} and {w} the thin line is what was asked for. Where the thick line lies on it, the law itself drives; elsewhere the limit does.',
  ],
};

/** @param {Run} run */
const arrival = (run) => (run.arrived ? `arrives after ${fixed(run.finalTime, 2)} s` : 'does not arrive');
