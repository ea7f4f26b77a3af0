// The step “disturbance” in English.
import { fixed } from '../../../words/numbers.js';

export const disturbance = {
  texts: {
    slip: `Until now the wheels did exactly what they were told, as far as their limits go. Now the ground slips: {=push}\u00a0m/s is added to whatever speed the robot drives. It runs past the goal, and there it stands, {=distance}\u00a0m away, for good. The close-up picture shows the last centimetres.`,
    why: `Why just there? At this place the law commands {=command}\u00a0m/s: backwards, as fast as the ground slides forwards. Nearer to the goal its command {kx} {xe} cos {te} is slower than the ground slides.`,
    theorem: `Must one know how the ground pushes? No: Theorem 2 asks only for a *bound*. The push {d1} on the speed never exceeds {e1}, the push {d2} on the turn rate never exceeds {e2}. The pushes add ({ye} sin {te} − {xe} cos {te}) {d1} − {d2} sin {te} to the rate of {V}. Each of the three parts of step 4 pulls {V} down; the pushes may lift it. While each part pulls harder than its share of the pushes can lift, {V} falls:`,
    sets: `Near the goal they cannot all hold: the right side of (6), for one, grows without end. So an error may remain. Solved for its error, each gives a *set* around zero, with a dashed edge: a band under the curves, a strip in the picture of the last centimetres. *Larger gains, smaller sets*: so, says the paper, one chooses gains for an error that one allows.`,
    unknown: `What does the theorem leave out? *Limits*: the paper counts what they cut off as part of the push, but near sin {te} = 0 that has no bound. *Samples*: with gains of 250 a robot that gets a new command 100 times a second *chatters*. And *time*: without a push, and with gains above 0, the error goes to 0, but how fast? With {ky} = {=ky}, from {=starts} other starts, up to {=left}\u00a0m of {ye} are left in the last {=last} of {=horizon} seconds.`,
    next: `So much for what can be proved. Now for the paper’s own numbers: do ours agree with them?`,
  },
  near: {
    again: 'Drive again',
    /** @param {number} across @param {number} time @param {number} distance */
    caption: (across, time, distance) =>
      `Seen from above, ${metres(across)} m wide. After ${fixed(time, 2)} s the robot is ${fixed(distance, 3)} m from the goal.`,
    /** @param {number} across @param {number} distance */
    label: (across, distance) =>
      `The goal from above, ${metres(across)} m wide. In the end the robot is ${fixed(distance, 3)} m from it.`,
  },
  holds: {
    /** @param {boolean} holds @param {string} formula @param {string} size @param {string | null} set Null: nothing pushes against it. */
    one: (holds, formula, size, set) => {
      if (set === null) return 'holds: nothing pushes';
      const just = size === set ? 'just ' : '';
      return holds
        ? `holds: ${formula} is ${size}, ${just}outside its set of ${set}`
        : `does not hold: ${formula} is ${size}, ${just}in its set of ${set}`;
    },
    /** @param {number} time @param {number} count @param {boolean} isCut Whether the limits leave less of the command. */
    all: (time, count, isCut) =>
      count < 3
        ? `After ${fixed(time, 2)} s not all three hold: the theorem promises nothing here.`
        : isCut
          ? `After ${fixed(time, 2)} s all three hold, but the limits cut the command, a push that this ε leaves out: {V} may rise.`
          : `After ${fixed(time, 2)} s all three hold: by the theorem, {V} falls.`,
  },
  quizzes: {
    double: {
      question: 'All three gains twice as large. Where does the robot stand then?',
      choices: ['In the same place', 'About half as far from the goal', 'On the goal'],
      /** @param {{ before: number, after: number }} outcome */
      why: ({ before, after }) =>
        `${fixed(after, 3)} m away instead of ${fixed(before, 3)} m. With twice the gain, half the error is enough for the same command. But no gain makes it zero: without an error there is no command, and the ground slips on.`,
    },
    random: {
      question:
        'Now *random pushes*: 100 times a second a new one, anything between −0.1 and 0.1 m/s. How far from the goal does the robot with the paper’s EP gains stay in the end?',
      choices: ['Farther than with the slip', 'Just as far', 'Nearer than with the slip'],
      /** @param {{ steady: number, random: number }} outcome */
      why: ({ steady, random }) =>
        `Within ${fixed(random, 3)} m in the last two seconds; with the slip it was ${fixed(steady, 3)} m. Pushes to and fro largely cancel each other, a slip never lets go. It is the steady disturbance that is the hard one.`,
    },
  },
  tries: {
    turning: 'A slip that turns the robot, too: 0.2 rad/s',
    aside: 'From a start to the side: do the three hold?',
    evolved: 'The turning slip and the gains evolved on one start',
    huge: 'Gains of 250, and the slip of 0.1 m/s',
  },
  notice: [
    'Under the slip straight ahead the robot ends just on the edge of the set of (6): a smaller one would be wrong.',
    'Under the slip that turns, |sin θₑ| stays a little outside its set, and it may: the theorem promises something only outside *all three*, and within one of them nothing, however large the other errors are.',
    'With {ky} near zero the set of (7) is metres wide. What evolution saved is missing here.',
    'Under random pushes on the speed {xe} and {ye} stay far inside their sets: the theorem allows for the worst.',
  ],
};

/** @param {number} value */
const metres = (value) => String(Number(value.toFixed(1)));
