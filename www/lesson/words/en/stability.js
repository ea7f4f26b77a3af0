// The step “stability” in English.
import { costText, fixed } from '../../../words/en/numbers.js';

/** @param {number} V */
const heightText = (V) => (V < 1e4 ? fixed(V, 2) : costText(V));

export const stability = {
  texts: {
    bowl: `Three errors are hard to watch at once. So take one number for all of them, {V}. Think of a bowl, the one in the picture: {V} is how high the robot stands on its wall. It is zero only at the bottom, where the robot is parked. At {=time} s it is {=V}. Play the drive, and watch the robot roll.`,
    falls: `Now the trick. The law was *built* so that {V} can only fall. To see it, one needs to know how the errors move. A dot over a symbol means: how fast it changes. The robot itself moves by its {v} and its {w}:`,
    errors: `Differentiate (3), put (2) in, and this is left. {vr} and {wr} are the goal’s own speed and turn rate, 0 for a goal at rest:`,
    chain: `How fast does {V} change, if the goal is at rest? By the chain rule:`,
    left: `With the law (5) put in, all terms but three cancel. What is left is the rate at which {V} changes. For a goal at rest it is the core of the paper’s Theorem 1, that the errors go to zero; the paper refers to an earlier one for the proof, so this one is ours:`,
    parts: `Three parts, one for each gain. Each is a square or a fourth power with a minus sign, so as long as its gain is positive, the part is never positive; and all three are zero together only at the bottom and at one other spot, which the last note below describes. In the figure the three are stacked, from 0 outwards: that of {kx}, that of {ky}, that of {kt}; the line is how fast {V} really changes. Here no limit interferes, and the two agree. So the robot rolls down until it is at the bottom of the bowl. Such a {V} is called a *Lyapunov function*.`,
    before: `Before this law there was a simpler one, by Kanayama and others. It follows a moving goal well. But its {w} is {wr} plus {vr} times a correction: the robot turns only while the goal *moves*.`,
    next: `The proof says that {V} never rises. From another start the program shows that at times it does. Both are right: the next step tells why.`,
  },
  bowl: {
    /** @param {number} V */
    label: (V) =>
      `A bowl. The robot stands on its wall at the height V ${fixed(V, 3)}, and rolls down as it drives.`,
    height: 'V',
  },
  cancel: {
    label: 'The terms of the rate of V, with what they come to now',
    said: [
      'Three terms, and a law of five. Put it in:',
      'Seven terms. Two of them contain ky and a division by sin θₑ.',
      'The two are the same, once with plus and once with minus: gone, and the division with them. That is what the term of ω with ky is for.',
      'The two with xₑ yₑ go the same way: that is why kx stands in ω. Three terms are left.',
    ],
    amounts: 'The number under each term is what it comes to at the robot’s clock; move it, and they change.',
    otherLaw: 'Now Kanayama’s rule drives, so no number stands under the terms of (5).',
    presses: ['Put the law in', 'Strike out the two with ky', 'Strike out the two with kx'],
    again: 'Once more',
  },
  quizzes: {
    negative: {
      question:
        '{ky} is set to −0.5, the other two stay above zero. The drive lasts two seconds, in which the law decides 2000 times a second (elsewhere 100 times), nearly at every instant. What becomes of {V}?',
      choices: [
        'It still falls to zero, only later',
        'It falls, and comes to rest above zero',
        'It falls at first, and then it rises',
      ],
      /** @param {{ first: number, last: number, least: number }} outcome */
      why: ({ first, last, least }) =>
        `{V} begins at ${heightText(first)}, falls to ${heightText(least)} and ends at ${heightText(last)}. With {ky} below zero its part is above zero: it pushes the robot up the wall, with the fourth power of its distance to the side. At first the other two parts are stronger. As {xe} and {te} shrink, those two fade, and the part of {ky} is left.`,
    },
    kanayama: {
      question:
        'Kanayama’s rule with the gains 3, 1, 5, the same start, the same goal at rest, and again without limits. Where does the robot stop?',
      choices: [
        'At the goal, pointing the right way',
        'At the goal, pointing the wrong way',
        'Beside the goal',
      ],
      /** @param {{ away: number, turned: number }} outcome */
      why: ({ away, turned }) =>
        `It stops ${fixed(away, 2)} m from the goal. Its largest turn rate was ${fixed(turned, 2)} rad/s: with a goal at rest the rule never turns. (It has a V of its own, which is the one shown.) This is the flaw that law (5), by Shim and Kim in 1994, was made to mend; their paper of 1995 looks for its gains.`,
    },
  },
  tries: {
    other: 'Another start: now {V} rises at times, though the proof forbids it',
    negativeTurn: '{kt} below zero: −2',
    track:
      'A goal that drives away at 0.5 m/s, with the velocity limits on: the law, which then has terms with {vr} too, follows it',
    kanayamaTracks: 'Kanayama’s rule with the same moving goal and limits: it follows, too',
  },
  notice: [
    'The two terms with {ky} cancel only where sin {te} is not 0. Where it is 0 and {ye} is not, the law has no value, and what our program puts in its place can raise {V} at once: [such a start](curves&view=stability&drives=hand&gains=3,8,5&start=2,1,45deg&limits.speed=off&limits.turnRate=off). Hardly a drive avoids that: the one with which this step opens soon comes to sin {te} = 0, still beside the goal’s line and turning ever faster, and the program leaps over it between two samples. What happens just there the proof does not say.',
    'Early the part of {kx} is the largest: most of {V} is lost by driving ahead.',
    'Close to the goal all parts are tiny, and that of {ky} the tiniest: the fourth power of a small number is very small. The last centimetres to the side take long. The dotted curve is that of the dotted drive, for comparison; what a generation is, step 7 tells.',
    'One spot is flat without being the bottom: [on the goal, turned by 180°](curves&view=stability&drives=hand&gains=3,1,5&start=2,2,-135deg). There every term of the law is zero, and {V} stays at 2. It is no hilltop but a *saddle*: wherever the robot moves, {V} rises; only turning leads down. For seconds nothing happens, until rounding in the last digits has tipped the balance. By the law every robot that starts on the goal’s line, facing exactly backwards, ends there too.',
  ],
};
