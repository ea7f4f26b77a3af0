// The step “contest” in English.
import { fixed } from '../../../words/numbers.js';
import { grouped } from '../../../words/en/numbers.js';

/** @typedef {import('../../steps/contest.js').Row} Row */

/** @param {Row} row */
const ertText = ({ ert }) => (Number.isFinite(ert) ? grouped(Math.round(ert)) : '∞');
/** @param {Row} row */
const reachedText = ({ reached, count }) => `${reached} of ${count}`;
/** @param {number} p */
const pText = (p) => (p < 0.001 ? 'p < 0.001' : `p = ${fixed(p, 3)}`);

/** What the ranks say of the other one. @param {Row} row @param {string} name */
function rankText({ comparison, count }, name) {
  if (!comparison) return '';
  const { a12, p, side } = comparison;
  if (side === 0) return `${count} runs cannot tell the two apart (${pText(p)}).`;
  if (p >= 0.05)
    return `That one gets there more often is not chance; who wins a pair one cannot tell (${pText(p)}).`;
  const part = Math.round(100 * Math.max(a12, 1 - a12));
  return `In ${part} of 100 pairs, one run of each, ${name} is the ${a12 > 0.5 ? 'better' : 'worse'} (${pText(p)}).`;
}

export const contest = {
  texts: {
    begin: `The method has many parts: a tournament, step sizes that adapt themselves, a population. *Which of them does the work?* Take one away, and see. But one run is one throw of the dice: where two searches are nearly equal, it tells next to nothing. So every contestant here runs *51 times*, with the same seeds, and may make *4\u202f000 drives* each time. Nobody counts generations, for a generation of one may cost ten times as many drives as that of another. The first contestant is the paper’s EP, *as in the lab*.

Two things can be asked of a run: how low is {J} when the drives are used up, or *how many drives until {J} is below a target*? Here it is the second: 7.72, about a quarter of a percent above the best that is known.`,
    read: `That is how such a result looks, and it is a result. The shaded bands, each the middle half of the runs, overlap. The table counts: how many runs *reached* the target; *ERT*, how many drives it takes on average if a run that failed is begun again with another seed; *A12*, how often a run of this one beats a run of the first; *p*, how often chance alone would make a difference at least as large, if both were equally good: below 0.05 one says that it is not chance. (This test knows nothing of the shared seeds. Where the first robots still decide, as at 8.09, it therefore says too often that it cannot tell; at 7.72 that makes no difference.) Step 7 showed a better robot falling in the tournament. As far as can be measured here, that does no harm, and no good.`,
    drag: `*Now drag the target*: the dot at the left end of the dashed line, slowly from 8.09 down to 7.72. At the top the curves lie together; further down they part, and that of {s} = 1 hardly falls any more. A step of 1 is good for finding the valley and useless for finding its lowest point. So the step sizes of step 8 *do* work, but only beyond a certain accuracy. Had we asked for 8.09 alone, we would have called them a waste.`,
    slide: `Press *other seeds* under the picture, again and again: the sentence flips between a clear difference and none, though nothing but the seeds has changed. Then move the slider *Had you run only* to 3, to 10, to 20. So few runs mostly leave the question open, and it is we who read an answer into them. Now and then they even show a difference that is not there.`,
    budget: `Drag the *vertical* line, the number of drives at which the curves are read, from 4\u202f000 to the end. With twenty robots {J} falls early and then stands still: a run that is not at the target by then hardly ever gets there. With a hundred it falls later, and more runs get there. *Without a target, a budget and the number of runs there is no winner*, only an anecdote.`,
    ellipse: `Why does the famous CMA-ES lose? [Open it on the landscape](landscape&x=kx&y=ky&evolution.method=cma-es&population=7&generation=55): the ellipse is the distribution from which it draws. It has shrunk almost to a point, and this point is not the lowest. Seven trials a generation, of which it follows the best three, are what its authors advise for three gains on smooth ground. Here the ground has ripples and ends at a wall: below {ky} = 0 there is the penalty.

There are remedies: [mirror what falls below 0](landscape&x=kx&y=ky&evolution.method=cma-es&population=7&evolution.belowZero=mirror&generation=570), or [let it try twenty](landscape&x=kx&y=ky&evolution.method=cma-es&generation=199) before it decides. Both are shown after 4\u202f000 drives. (Its authors have another, which is not in this contest: begin anew, each time with twice as many.) Which of the two helps more? The last of the things to try lets them run; there the one that tries twenty is called simply *CMA-ES*. So was it the method that lost, or whoever set it up?`,
    next: `One task, one start, three gains: what wins here need not win elsewhere. The contest counts how *soon* a search finds what the cost asks for. Whether the cost asks for the right thing, no contest tells.`,
  },
  quizzes: {
    tournament: {
      question:
        'Take the tournament away: the twenty of lowest {J} survive, always. How does that do, after 51 runs each?',
      choices: [
        'Clearly worse: the luck of the tournament keeps variety alive',
        'Clearly better: nothing good is ever lost',
        'Nobody can tell: with 51 runs of each there is no clear difference',
      ],
      /** @param {{ first: Row, other: Row, target: number }} outcome */
      why: ({ first, other, target }) =>
        `With the tournament ${reachedText(first)} runs get below ${target}, without it ${reachedText(other)}; the expected drives are ${ertText(first)} and ${ertText(other)}. ${rankText(other, 'the one without')}`,
    },
    sigma: {
      question:
        'Now {s} stays at 1 for good: nothing adapts. Which reaches an easy target, {J} = 8.09, sooner: self-adaptation or {s} = 1? And which reaches 7.72 sooner?',
      choices: [
        'Self-adaptation is sooner at both',
        'At 8.09 self-adaptation is no sooner; at 7.72 it is far ahead',
        'Self-adaptation is sooner at neither',
        'At 8.09 self-adaptation is far ahead; at 7.72 it is no sooner',
      ],
      /** @param {{ early: Row[], late: Row[], far: number, near: number }} outcome */
      why: ({ early, late, far, near }) =>
        `To ${far} it takes ${ertText(early[0])} drives with self-adaptation and ${ertText(early[1])} with σ = 1: ${rankText(early[1], 'σ = 1')} ${reachedText(late[0])} runs with self-adaptation get below ${near}, and ${reachedText(late[1])} with σ = 1.`,
    },
    fewer: {
      question:
        'The difference at 7.72 could hardly be larger. Had you run only *five* seeds of each: how often would you have been able to tell?',
      choices: ['Nearly always', 'About half of the time', 'Hardly ever'],
      /** @param {{ told: number, few: number }} outcome */
      why: ({ told, few }) =>
        `In ${told} of 100 draws of ${few} out of the 51 seeds. And few differences are as large as this one.`,
    },
    crowd: {
      question:
        'A hundred robots instead of twenty, and as many drives in all. With which do more runs get below 7.72?',
      choices: [
        'With twenty, after 4\u202f000 drives and after 20\u202f000',
        'With twenty after 4\u202f000 drives, with a hundred after 20\u202f000',
        'With a hundred, both times',
        'With a hundred after 4\u202f000 drives, with twenty after 20\u202f000',
      ],
      /** @param {{ early: Row[], late: Row[], drives: number[] }} outcome */
      why: ({ early, late, drives }) =>
        `After ${grouped(drives[0])} drives: ${reachedText(early[0])} runs with twenty robots, ${reachedText(early[1])} with a hundred. After ${grouped(drives[1])}: ${reachedText(late[0])} and ${reachedText(late[1])}.`,
    },
    rivals: {
      question:
        'Two rivals with the same drives: *differential evolution* (DE), which takes its steps from the differences between its robots, and *CMA-ES*, a famous one, which learns the shape of the valley, with the seven trials a generation that its authors advise. Which needs the fewest drives to 7.72 (ERT)?',
      choices: ['The paper’s EP', 'DE', 'CMA-ES with 7'],
      /** @param {{ lines: Row[] }} outcome */
      why: ({ lines: [ep, de, cma] }) =>
        `ERT is ${ertText(ep)} for EP, ${ertText(de)} for DE and ${ertText(cma)} for CMA-ES with 7. Runs that get below the target: ${reachedText(ep)}, ${reachedText(de)} and ${reachedText(cma)}.`,
    },
  },
  tries: {
    floor: 'The remedy of step 8: {s} never below 0.1, with 20\u202f000 drives',
    crossover:
      'Three more parts: crossover, Cauchy steps (now and then a very long one), each offspring against its own parent',
    robots: 'Six, twenty or a hundred robots, to {J} = 7.8',
    hand: 'One gain after the other, as a hand does with sliders that end at 0; the same without that end; and Nelder–Mead, four robots of which the worst steps over the others',
    remedies: 'CMA-ES with 7, and its two remedies',
  },
  notice: [
    'Of the three more parts to try, only crossover, in which robots trade gains *and* step sizes, is better as far as *51 runs* can tell. The paper has no crossover.',
    'With Cauchy steps 41 runs reach the target instead of 34. 51 runs cannot tell that from chance, which does not prove that it is chance. Letting offspring meet only their own parent is fatal.',
    'With a floor, far fewer runs miss the target in the end, but none gets much below it either: by then the steps are too long.',
    'Whether six robots come to 7.8 sooner than twenty, 51 runs cannot tell. A hundred need twice as many drives.',
    'A hand that moves one slider after the other beats evolution in two pairs of three, for the best {ky} lies at 0, where such sliders end. But it gets stuck more often: 37 runs get to 7.8, not 49. Without that end it is lost.',
  ],
};
