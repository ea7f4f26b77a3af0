// The step “duel” in English.
import { costText, fixed, grouped } from '../../../words/en/numbers.js';

/** @typedef {import('../common.js').Verdict} Verdict */

/** @param {number} count */
const drivesText = (count) => (count === 1 ? '1 drive' : `${grouped(count)} drives`);

export const duel = {
  texts: {
    begin: `The same robot, the same start, the same goal. You go first: find good gains by hand. Every change of a slider or a number is one drive, and only J counts. When you are content, *lock in your best*.

Then evolution gets as many drives as you had, and so does a third player, *random search*: it draws gains evenly between {=low} and {=high}, keeps the best, and learns nothing. Evolution needs {=count} drives for its first robots and {=count} for each generation after that. So do not stop too early.`,
    after: `With few drives luck decides. Evolution begins with the very robots that random search begins with, and for the first hundred drives it is hardly better. *Its strength is that it does not stop getting better*: it goes on from what was good. Let both go on, and try other seeds, before you say who won.`,
    next: `And yet there are starts from which evolution is no better than drawing lots. What makes it easy or hard? That depends on the ground it walks on: on J as a landscape over the gains.`,
  },
  duel: {
    drivesLabel: 'Your drives',
    drivesName: 'your drives',
    bestName: 'your best J',
    /** @param {number} drives @param {number} population */
    enough: (drives, population) => {
      const generation = Math.floor(drives / population) - 1;
      if (generation < 0) return `Evolution needs ${population} drives for its first robots. Go on.`;
      return generation === 0
        ? `Enough for evolution’s first robots, which are random. ${population} drives more are one generation.`
        : `Enough for evolution to come to generation ${generation}. ${population} drives more are one generation more.`;
    },
    lock: 'Lock in my best',
    locked: 'Locked in. Drive on if you like; it counts no more.',
    elsewhere: 'Locked in, for another start, goal or setting than you see now. Start over to duel here.',
    startOver: 'Start over',
    resultLabel: 'How the three compare',
    names: { you: 'you', evolution: 'evolution', random: 'random search' },
    heads: ['who', 'drives', 'best J'],
    drivesAxis: 'drives',
    costSymbol: 'J',
    cost: costText,
    /** @param {Verdict} verdict */
    caption: ({ seed, generation, drives, given }) =>
      `Seed ${seed}. Evolution is at generation ${generation}${given <= drives ? `, the last that fits into ${drivesText(drives)}` : ''}.`,
    /** @param {Verdict} verdict */
    sentence: (verdict) => [who(verdict), caution(verdict)].filter(Boolean).join(' '),
    later,
    /** @param {string} sentence */
    plotLabel: (sentence) => `The best J so far of all three against the number of drives. ${sentence}`,
    /** @param {number} drives */
    goOn: (drives) => `Let both go on to ${drivesText(drives)}`,
    /** @param {number} drives */
    backTo: (drives) => `Back to your ${drivesText(drives)}`,
    anotherSeed: 'Again with another seed',
    /** @param {Verdict} verdict */
    watch: ({ generation }) => `Show evolution’s best of generation ${generation}`,
    /** @param {number} rounds @param {Record<'you' | 'evolution' | 'random' | 'both', number>} score */
    score: (rounds, { you, evolution, random, both }) =>
      rounds === 1
        ? 'One seed is one throw of the dice.'
        : `Of ${rounds} seeds you win ${you}, evolution ${evolution}, random search ${random}${both > 0 ? `, those two together ${both}` : ''}.`,
  },
  quizzes: {
    ahead: {
      question:
        'Drives so far: {=drives}. Your best J: {=best}. Who will have the lowest J after as many drives? (Your prediction locks your best in.)',
      choices: ['I will', 'Evolution', 'Random search', 'Evolution and random search, with the same J'],
      /** @param {Verdict} verdict */
      why: (verdict) => {
        const { costs, drives, given, generation, seed } = verdict;
        const you =
          drives === 0
            ? 'You have not driven.'
            : `You: J ${costText(costs.you)} after ${drivesText(drives)}.`;
        return `${you} Evolution: J ${costText(costs.evolution)} at generation ${generation}, after ${drivesText(given)}. Random search: J ${costText(costs.random)} after as many. Seed ${seed}. ${caution(verdict)}`;
      },
    },
  },
  tries: {
    luck: 'A hundred seeds in the luck part: how often does random search stay ahead?',
    backwards: 'A start that looks away from the goal: another duel',
    round: 'A start on the goal, pointing the wrong way: another duel',
  },
  notice: [
    'You look at the robot and think. Evolution knows nothing of the robot: all it ever sees is J.',
    'Evolution can leave the range in which the first gains are drawn. This random search cannot.',
  ],
};

/** @param {Verdict} verdict */
function who({ winner, costs }) {
  const { you, evolution, random } = costs;
  const by = (/** @type {number} */ less, /** @type {number} */ more) => fixed(more - less, 3);
  return {
    you: `You win: ${by(you, Math.min(evolution, random))} below the second.`,
    evolution: `Evolution wins: ${by(evolution, Math.min(you, random))} below the second.`,
    random: `Random search wins: ${by(random, Math.min(you, evolution))} below the second.`,
    both: 'Evolution and random search win, with the same J.',
  }[winner];
}

/** What makes it less than a fair contest. @param {Verdict} verdict */
function caution({ drives, population, generation }) {
  if (drives < population)
    return `But they had ${population} drives each, for with fewer evolution cannot begin, and you had ${drives}.`;
  return generation === 0 ? 'Nothing has evolved yet: these are the first robots of both.' : '';
}

/** @param {Verdict} verdict */
function later({ costs, longest, later: { evolution, random }, passed }) {
  const ends = `After ${drivesText(longest)} evolution is at J ${costText(evolution)}, random search at ${costText(random)}.`;
  return `${ends} ${passed === null ? `Evolution has not come below your ${costText(costs.you)}.` : `Evolution was below your ${costText(costs.you)} after ${drivesText(passed)}.`}`;
}
