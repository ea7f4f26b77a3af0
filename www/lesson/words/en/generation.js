// The step “generation” in English.
import { costText } from '../../../words/en/numbers.js';

/** @typedef {{ stays: boolean, cost: number, wins: number, place: number }} Fate */

export const generation = {
  newborn: {
    /** @param {number} better @param {number} count */
    title: (better, count) =>
      `Drives of ${count} offspring (pale: their parents’). Below: J. Green, bold J: better, ${better}.`,
    /** @param {number} count */
    alone: (count) => `Drives of ${count} offspring. Below: J.`,
    /** @param {number} count */
    parents: (count) => `The drives of ${count} parents. Below: J.`,
    /** @param {number} number @param {boolean} _isParent */
    name: (number, _isParent) => String(number),
  },
  texts: {
    begin: `You tried one set of gains, the three numbers of a robot, after another. *Evolutionary programming* (EP) keeps {=count} sets at a time: a *population* of *individuals*, here robots. The first are *generation 0*: each gain is drawn at random between {=low} and {=high}, and each robot drives once, at a cost {J} (lower is better): it is *evaluated*. (The number by which robots are compared is their *fitness*; here it is {J}, so the fittest has the lowest. All chance comes from one number, the *seed*: with the same seed everything happens again, with another seed, chance falls differently.) Then EP repeats four moves; each round makes the next *generation*. The numbers in the text are those of the robot chosen in the figure; press any other.`,
    mutate: `*1. [Mutate](generation&generation=1&phase=mutation&individual=26).* Every parent has one *offspring*. Its gains are the parent’s, each moved by a random step: the parent’s *step size* {s} (its *strategy parameter*) times a draw {N} from the standard normal distribution (the bell curve), which is rarely beyond −2 or 2. (The figure shows new step sizes, too; step 8 is about them.)`,
    drive: `*2. [Drive](generation&generation=1&phase=drive&individual=26).* All offspring drive, above the figure. {=child} comes to J {=childCost}; its parent had {=parentCost}. Better than their parent: {=better} of {=count} offspring. As a rule most are worse: a random step is more often bad than good.`,
    rule: `*3. Tournament.* All {=all} robots, parents and offspring, meet {=bouts} others each, drawn at random *with replacement*: a robot may meet the same opponent twice, but never itself. It wins a bout unless its opponent has the lower J.

*4. Survive.* The {=count} with the most wins stay as parents of the next generation, with their gains, step sizes and J. Tournament and survival together are the *selection*. Before you press: a question.`,
    select: `*3. [Tournament](generation&generation=1&phase=tournament&individual=26).* {=chosen} wins {=wins} of {=bouts}. In the figure, *expected* is how many a robot of its {J} would win on average; the rest is luck. *Rank*: most wins first. *4. [Survive](generation&generation=1&phase=survivors&individual=26).* {=fate} Press the moves (in the figure: *phases*) one by one, and look at other robots.`,
    next: `These four moves are the paper’s EP. The idea is L.\u00a0J.\u00a0Fogel’s, of the 1960s; this form, for numbers and with a tournament, D.\u00a0B.\u00a0Fogel’s, of about 1990; the rule for step sizes in step 8 is Schwefel’s. Nothing is crossed: an offspring has one parent. That there are 20 robots, that opponents are drawn with replacement, and that the lower J goes first when the wins are equal, is our choice, and so is when to stop: after as many generations as one likes one takes the best robot. And how large should a step be? Every robot begins with {s} = 1; from then on nobody sets it.`,
  },
  /** @param {string} name @param {string} fate */
  fate: (name, fate) => `${name[0].toUpperCase()}${name.slice(1)} ${fate}.`,
  quizzes: {
    luck: {
      question: 'In generation 1 offspring 11 drives better than offspring 9. Which of the two stays?',
      choices: ['Only offspring 11', 'Only offspring 9', 'Both', 'Neither'],
      /** @param {{ better: Fate, worse: Fate, bouts: number }} outcome */
      why: ({ better, worse, bouts }) =>
        `Offspring 11 has J ${costText(better.cost)} and wins ${better.wins} of ${bouts}: it ${better.stays ? 'stays' : 'falls'}. Offspring 9 has J ${costText(worse.cost)} and wins ${worse.wins}: it ${worse.stays ? 'stays' : 'falls'}. By J alone they are number ${better.place} and number ${worse.place}. What counts is wins, and these depend on whom one meets.`,
    },
    best: {
      question: 'And the very best robot: can the best J get worse from one generation to the next?',
      choices: [
        'Yes, when it has bad luck in the tournament',
        'Yes, when its offspring drives worse',
        'No, never',
      ],
      /** @param {{ rose: number, fell: number, generations: number }} outcome */
      why: ({ rose, fell, generations }) =>
        `The *fitness curve* shows the best J of each generation: in these ${generations} it fell ${fell} times and ${rose === 0 ? 'never rose' : `rose ${rose} times`}. Nobody has a lower J than the best: it wins every bout, whomever it meets, and among those with as many wins the lower J goes first. And it does not give way to its offspring; both stand in the same tournament. That the best always survives is called *elitism*.`,
    },
  },
  tries: {
    lucky: 'Seed 3: parent 13 has a high J and stays. Whom did it meet?',
    below: 'Offspring 15 took one step too far: what does J charge it for?',
    bouts: '200 bouts for each instead of 10: is there still luck?',
    late: 'Generation 60: how many offspring drive better than their parent now?',
  },
  notice: [
    'A generation costs 20 drives, not 40: the parents have driven already.',
    'Offspring are made with the step sizes of their parent. They get new step sizes too, but use them only for their own offspring. *Evolution strategies* that adapt themselves do it the other way round: first the new step size, then a step with it.',
  ],
};
