// The step “duel” in English.
import { costText, fixed, grouped } from '../../../words/en/numbers.js';

/** @typedef {import('../common.js').Verdict} Verdict */

/** @param {number} count */
const trialsText = (count) => (count === 1 ? '1 trial' : `${grouped(count)} trials`);

export const duel = {
  texts: {
    begin: `One robot from one start was easy. Now the same three gains must park it *from 32 starts*, all around the goal and pointing anywhere. {J} is the mean over all 32 drives, and turning counts in it with {Rw} = {=turning}, {=before}.

You go first. Move the sliders under the picture, or type numbers. Each time you let go of a slider, 32 robots drive: that is *one trial*, however far you dragged. When you are content, *lock in your best*.

Then evolution has its turn: {=count} robots for {=generations} generations, {=given} trials, the first {=count} included; if you had more, it gets as many as you. A third player, *random search*, has as many: it draws gains evenly between {=low} and {=high}, keeps the best, and learns nothing.`,
    beyond: `Watch evolution’s robots, and look at its gains above the picture. Its {ky} lies beyond the slider, where few hands would look and where random search cannot go. Nobody told it to look there.`,
    within: `Watch evolution’s robots, and look at its gains above the picture. This time its {ky} lies where a hand can go, too.`,
    after: `*Selection goes on from what was good*: each generation starts where the last one ended. How much it finds in {=generations} generations still depends on luck: try other seeds, and let both go on, before you say who won.`,
    next: `Why is one search easy and another hard? That depends on the ground it walks on: on J as a landscape over the gains.`,
  },
  duel: {
    /** @param {number} now @param {number} before */
    before: (now, before) =>
      now === before ? 'as in the steps before' : `not ${before} as in the steps before`,
    drivesLabel: 'Your trials',
    drivesName: 'your trials',
    bestName: 'your best mean J',
    /** @param {number} drives @returns {string} */
    enough: (drives) =>
      drives === 0 ? 'Move a slider, and 32 robots drive.' : 'Go on, or lock your best in.',
    none: 'none yet',
    lock: 'Lock in my best',
    /** @param {boolean} predicted @returns {string} */
    locked: (predicted) =>
      predicted
        ? 'Locked in. Drive on if you like; it no longer counts.'
        : 'Locked in. Your prediction, below, sets evolution going. Drive on if you like; it no longer counts.',
    elsewhere: 'Locked in for another goal or other settings than you see now. Start over to compete here.',
    startOver: 'Start over',
    resultLabel: 'How the three compare',
    names: { you: 'you', evolution: 'evolution', random: 'random search' },
    heads: ['who', 'trials', 'parked', 'mean J'],
    drivesAxis: 'trials',
    costSymbol: 'J',
    /** @param {Verdict} verdict */
    caption: ({ seed, generation, given }) =>
      `Seed ${seed}. What counts is evolution’s generation ${generation}, after ${trialsText(given)}.`,
    sentence: who,
    later,
    /** @param {string} sentence */
    plotLabel: (sentence) => `The best mean J so far of all three against the number of trials. ${sentence}`,
    /** @param {number} drives @returns {string} */
    goOn: (drives) => `Let both go on to ${trialsText(drives)}`,
    /** @param {Verdict} verdict */
    backTo: ({ given }) => `Back to ${trialsText(given)}`,
    anotherSeed: 'Again with another seed',
    watch: { evolution: 'Watch evolution’s robots', you: 'Watch your robots' },
    /** @param {number} rounds @param {Record<'you' | 'evolution' | 'random' | 'both', number>} score */
    score: (rounds, { you, evolution, random, both }) =>
      rounds === 1
        ? 'One seed is one throw of the dice.'
        : `Of ${rounds} seeds you win ${you}, evolution ${evolution}, random search ${random}${both > 0 ? `; in ${both} those two tie` : ''}.`,
  },
  quizzes: {
    ahead: {
      question:
        'Trials so far: {=drives}. Your best: {=best}. Who will have the lowest mean {J} in the end? (Your prediction locks your best in.)',
      choices: ['I will', 'Evolution', 'Random search', 'Evolution and random search, with the same J'],
      first: 'First move a slider: predict once you have a trial.',
      /** @param {Verdict} verdict */
      why: ({ costs, drives, given, generation, seed }) => {
        const you = `You: ${costText(costs.you)} after ${trialsText(drives)}.`;
        return `${you} Evolution: ${costText(costs.evolution)} at generation ${generation}, after ${trialsText(given)}. Random search: ${costText(costs.random)} after as many. Seed ${seed}.`;
      },
    },
  },
  tries: {
    luck: 'A hundred seeds of the easy task in the part Luck: how often does random search stay ahead there?',
    dear: 'The same duel with turning as costly as driving: {Rw} = 1',
    sharp: 'Start from 12, 12, 6, near the best that the sliders allow',
  },
  notice: [
    'You look at the robots and think. Evolution knows nothing of robots: all it ever sees is J.',
    'Evolution can leave the range in which the first gains are drawn. This random search cannot.',
    'A hand makes few trials, evolution hundreds. That is its way: it does not think, but it does not tire.',
  ],
};

/** @param {Verdict} verdict */
function who({ winner, costs }) {
  const { you, evolution, random } = costs;
  const by = (/** @type {number} */ less, /** @type {number} */ more) => fixed(more - less, 3);
  const rivals = Math.min(evolution, random);
  return {
    you: Number.isFinite(you) ? `You win: your J is ${by(you, rivals)} below the second.` : '',
    evolution: `Evolution wins: its J is ${by(evolution, Math.min(you, random))} below the second.`,
    random: `Random search wins: its J is ${by(random, Math.min(you, evolution))} below the second.`,
    both: 'Evolution and random search win, with the same J.',
  }[winner];
}

/** @param {Verdict} verdict */
function later({ costs, longest, later: { evolution, random }, passed }) {
  const ends = `After ${trialsText(longest)} evolution is at ${costText(evolution)}, random search at ${costText(random)}.`;
  if (!Number.isFinite(costs.you)) return ends;
  return `${ends} ${passed === null ? `Evolution has not come below your ${costText(costs.you)}.` : `Evolution was below your ${costText(costs.you)} after ${trialsText(passed)}.`}`;
}
