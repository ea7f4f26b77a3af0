// The step “task” in English.
import { shareText } from '../../../parts/robustness/words/common.js';
import { costText, fixed, grouped } from '../../../words/en/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */
/** @typedef {import('../common.js').Share} Share */
/** How gains fare: from how many starts they arrive. @typedef {{ gains: readonly number[], training: Fares, unseen: Fares, own: number }} Result */
/** @typedef {{ starts: readonly unknown[], arrived: Uint8Array, count: number, cost: number }} Fares */

export const task = {
  texts: {
    good: `The robot of steps 7, 8 and 10 was evolved on *one* start. Generation {=generation}: it arrives after {=time} s at J {=cost}; the gains of the paper come to {=paper} here. There is little left to find. *So has this robot learned to park?*

Put it to the test: the same gains, other starts. {=places} places in a square with sides of {=side} m around the goal, with {=headings} headings at each, make {=starts} starts.`,
    beside: `Watch those that fail, here or on [the map](robustness&generation=100), where a press on a hatched place drives from there. The robot drives up, turns the right way, and stops *beside* the goal: {xe} and {te} are gone, {ye} is left. The gain against {ye} is {ky}, and evolution has left it at {=ky}.`,
    asked: `Why so small? The one start that evolution was given lies straight behind the goal, on the goal’s own line: there {ye} is {=ye} m. On this drive {ky} has almost nothing to do, and costs. So evolution took it away. That was no mistake: it was asked about *one* drive, and it made that drive cheap. To fit what was asked so closely that one fails elsewhere is called *overfitting*; to do well where one was not asked, *generalisation*.

*An optimiser goes by the cost, not by what you meant.*`,
    many: `So ask for more: let {J} be the *mean over many starts*, and evolve again. [Training](training&generation=100) does that three times: on one start, on 32 on a circle, on 36 on a grid. Each result is then tested on 1000 starts that none has seen, in a circle around the goal, not in a square with corners as above. Your prediction sets it going.`,
    half: `Better, and still far from all of the unseen starts. More starts alone do not solve it, so look at what the cost *asks for*. Who starts beside the goal must turn away, drive, and turn back, and turning is energy. Gains made for one such start alone park there: that costs less than to wait. But *one* set of gains must serve all 32, and a set with which all of them park turns hard everywhere: at {Rw} = 1 that costs more, in the mean, than a set that leaves some robots beside the goal until the time is up. (You saw in step 6 that to stay can cost less.) The price of turning was our choice. Here it is: *make it a tenth*, 0.1 in the place of 1.`,
    whole: `Press any start in the pictures, and its drive is drawn. Nothing about the robot, the law, the starts or evolution has changed. *What was asked for has.* This is what you played in step 9. And between 0.1 and 1? Set another price of turning, press *Evolve again*, and find where the robots stop parking.`,
    next: `This holds far beyond robots: look at what a cost does *not* ask for. Ours has never asked for a floor that pushes.`,
  },
  quizzes: {
    share: {
      question: 'From how many of these starts does it arrive?',
      choices: [
        'From nearly all',
        'From about three quarters',
        'From about half',
        'From a quarter, or fewer',
      ],
      /** @param {Share} outcome */
      why: ({ count, starts, share }) =>
        `From ${grouped(count)} of ${grouped(starts)}, that is ${percent(share)}. The picture with which this step opens has 32 other starts, those of step 9.`,
    },
    arbitrary: {
      question:
        'The arbitrary gains of the paper, 10, 10, 10, cost more from its start. From how many starts do they arrive?',
      choices: ['From fewer', 'From about as many', 'From more'],
      /** @param {{ own: Share, other: Share, best: Run, dear: Run }} outcome */
      why: ({ own, other, best, dear }) =>
        `They arrive from ${percent(other.share)} of the starts, the evolved ones from ${percent(own.share)}. From the start of the paper it was J ${costText(dear.cost.total)} against ${costText(best.cost.total)}. What is best in one place need not be good in others.`,
    },
    price: {
      question: 'Evolved on 32 starts instead of one: what becomes of {J} from the one start of the paper?',
      choices: ['It falls', 'It stays as it is', 'It rises'],
      /** @param {{ one: Result, many: Result }} outcome */
      why: ({ one, many }) =>
        `From ${costText(one.own)} to ${costText(many.own)}. In return the robot arrives from ${many.unseen.count} of the ${many.unseen.starts.length} starts that it never saw, instead of ${one.unseen.count}. And {ky} is ${fixed(many.gains[1], 2)} now, not ${fixed(one.gains[1], 4)}: asked for, it came back. The table has all three robots.`,
    },
    turning: {
      question:
        'With turning at a tenth of its price, evolved again on the same 32 starts: from how many of the 1000 unseen starts do the robots park?',
      choices: ['From fewer', 'From somewhat more than half', 'From nearly all of them'],
      /** @param {{ before: Result, after: Result }} outcome */
      why: ({ before, after }) =>
        `From ${after.unseen.count} of ${after.unseen.starts.length}, instead of ${before.unseen.count}. The gains were ${gainsText(before.gains)} and are ${gainsText(after.gains)} now.`,
    },
  },
  tries: {
    beside: 'A start that fails: watch where it ends',
    withKy: 'The same start with {ky} = 10',
    training: 'Evolve all three: one start, 32, 36, tested on 1000 others',
    cheap: 'The same with seed 3: evolve, and look at the grid',
    both: 'Driving at a tenth, too: {R} = 0.1, 0.1. Do you still reach all?',
  },
  notice: [
    'The map has an axis: the direction in which the goal points. The robot arrives from behind and from ahead, and hardly ever from the sides.',
    'Even trained on many starts, the robot misses some. With {Rw} = 1 {J} asks for cheap drives, not for arrivals: with seed 3 the gains of the grid arrive less often than the arbitrary ones, at a far lower mean {J}.',
    'Gains look best where they were evolved: compare “trained on” with “never seen”.',
  ],
};

/** @param {number} share */
const percent = (share) => `${shareText(share)} %`;

/** @param {readonly number[]} gains */
const gainsText = (gains) => gains.map((gain) => fixed(gain, gain < 10 ? 2 : 0)).join(', ');
