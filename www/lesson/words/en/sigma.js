// The step “sigma” in English.
import { costText, fixed } from '../../../words/en/numbers.js';

/** @import { Ancestor } from '../../views/lineage.js' */
import { gainText, sigmaText } from '../../../parts/generation/words/common.js';

export const sigma = {
  lineage: {
    /** @param {number} generation @param {number} count @param {number} [first] Where the family begins: not at 0 if earlier ancestors are left out. */
    title: (generation, count, first = 0) =>
      generation === 0
        ? 'The best robot of generation 0: it has no parents.'
        : count === 1
          ? first > 0
            ? `The best robot of generation ${generation} was born in generation ${first} or before: its ancestors are left out.`
            : `The best robot of generation ${generation} is one of the first: it has no parents.`
          : `The best robot of generation ${generation} and its ${count === 2 ? 'parent' : `${count - 1} ancestors`}: the steps that were handed on.${first > 0 ? ` Those before generation ${first} are left out.` : ''}`,
    axis: 'born',
    /** @param {number} first @param {number} last */
    sigma: (first, last) => `σ ${sigmaText(first)} → ${sigmaText(last)}`,
    /** @param {string} gain @param {readonly Ancestor[]} family @param {number} i */
    label: (gain, family, i) =>
      `${gain} and its σ: ${family.map(({ born, individual: { gains, sigmas } }) => `generation ${born}: ${gainText(gains[i], sigmas[i])}, σ ${sigmaText(sigmas[i])}`).join('; ')}`,
    other: 'This search hands no step sizes from parent to offspring.',
  },
  texts: {
    begin: `Too short a step gets nowhere. Too long a step misses. And what was right at the beginning is too long near the end. So nobody sets the *step size*: every robot has its own {s} for each gain, a standard deviation, and hands it to its offspring, times a random factor. This is *self-adaptation*. The factor is the exponential of a normal draw, so it is *log-normal* and always positive:`,
    rates: `{N} is one draw for all three: all steps of an offspring grow or shrink together. {N2x}, {N2y} and {N2t} change each by itself; they are new draws, not those that moved the gains. {tau2} = {=common} and {tau} = {=own} are the paper’s, 1/√(2n) and 1/√(2√n) for n = 3 gains, and so is {s} = 1 at the start. In 70 % of all births a new {s} lies between half and twice the old one.

Nobody judges {s} itself. Steps of a good length make good offspring, and these inherit it, times their random factor: a new {s}, close to a good one. The picture shows how the best robot got its {s}: the bells of its family, from the first ancestor down; each shows where the gain of the next offspring was likely to land. The curves show the mean {s} of all robots, on a logarithmic axis: after {=generation} generations {=sx} for {kx}, {=sy} for {ky}, {=st} for {kt}.`,
    collapse: `In the long run {s} falls. A short step cannot spoil much, so offspring made with short steps survive more often and hand them on. Nothing stops this: *the step sizes collapse*. With seed 1 they are below a millionth [after 300 generations](lab&generation=300&curve=sigmas), and evolution stands still, whether it has found the best place or not. How soon is chance: [with seed 13](lab&seed=13&generation=300&curve=sigmas) some steps are still large by then. The usual remedy is a floor that {s} may not fall below. The paper states none, so here is none; [step 11](lesson&step=contest) lets you try one. Many evolution strategies have another: no parent survives, so none lives on with bad step sizes because it was lucky once (*comma selection*). So EP is a method with a weakness.`,
    next: `So far the task is kind to short steps: the best gains are not far from the first robots. And where they are far? Try it yourself first.`,
  },
  quizzes: {
    small: {
      question:
        'What if every robot begins with {s} = 0.01 instead of 1? The same robots, the same seed: where is the best J after 60 generations?',
      choices: [
        'Lower: small steps are careful',
        'At the same J: {s} adapts itself anyway',
        'Higher: with such steps it hardly gets away',
      ],
      /** @param {{ own: number, usual: number, generation: number, sigma: number, falls: boolean }} outcome */
      why: ({ own, usual, generation, sigma, falls }) =>
        `After ${generation} generations the best J is ${costText(own)}; with σ = 1 at the start it is ${costText(usual)}. Only about one birth in seven more than doubles a σ${falls ? ', and here σ does not even grow: the curves fall. Among steps so short the shortest do the least harm, and so they survive. The end of this step says more.' : `, so it takes many generations to make ${sigma} large.`}`,
    },
    further: {
      question:
        'Evolution goes on, with seed 1, from generation 150 to generation 300: as many drives again as before. How far does the best J still fall?',
      choices: ['About as far as before', 'Less, but visibly', 'By less than 0.01'],
      /** @param {{ before: number, after: number, half: number, generation: number, sigmas: string[] }} outcome */
      why: ({ before, after, half, generation, sigmas }) =>
        `In the first ${half} generations it fell by ${fixed(before, 3)}, in the next ${generation - half} by ${fixed(after, 5)}. At the end the mean σ are ${sigmas.join(', ')}.`,
    },
  },
  tries: {
    stuck: 'Seed 7 after 300 generations: how large is {s}? Other seeds get to a lower J',
    none: 'No steps at all: {s} = 0. Only the tournament is left',
    large: 'Far too large: {s} = 100',
    late: 'Generation 300, a mutation: can you see the gains change?',
  },
  notice: [
    'At the beginning the curves rise, though {s} is halved as often as doubled: doubling adds more to a mean than halving takes away.',
    'With seed 1 the step of {ky} shrinks first. Step 10 shows why this one.',
  ],
};
