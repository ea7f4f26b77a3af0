// The step “stability” in English.
import { fixed } from '../../../words/numbers.js';

export const stability = {
  texts: {
    bowl: `Three errors are hard to watch at once. So take one number for all of them, {V}. Think of a bowl: {V} is how high the robot stands on its wall. It is zero only at the bottom, where the robot is parked. At {=time} s it is {=V}.`,
    falls: `Now the trick. The law was *built* so that {V} can only fall. Put the law into the motion of the errors, and nearly everything cancels. What is left is the speed with which {V} changes:`,
    parts: `Three parts, one for each gain. Each is a square or a fourth power with a minus sign: while its gain is above zero, it cannot be. In the figure the three are stacked in their colours; the line is how fast {V} really changes. Here no limit disturbs, and the two agree. So the robot only ever rolls down, to the bottom of the bowl. This is the paper’s Theorem 1, and such a {V} is called a *Lyapunov function*.`,
    before: `Before this law there was a simpler one, by Kanayama and others. It follows a moving goal well. But with it the robot turns only while the goal *moves*.`,
    next: `The proof says that {V} never rises. From another start the program shows that at times it does. Both are right: the next step tells why.`,
  },
  quizzes: {
    negative: {
      question: '{ky} is set to −1, the other two stay above zero. What becomes of {V}?',
      choices: [
        'It still falls to zero, only later',
        'It stops falling before zero',
        'In the end it is higher than at the start',
      ],
      /** @param {{ first: number, last: number, most: number }} outcome */
      why: ({ first, last, most }) =>
        `V begins at ${fixed(first, 2)} and ends at ${fixed(last, 2)}; the highest is ${fixed(most, 2)}. With ky below zero the orange part is above zero: it pushes the robot up the wall, and the farther it is to the side, the harder, with the fourth power.`,
    },
    kanayama: {
      question: 'Kanayama’s rule, the same start, the same goal standing still. Where does the robot stop?',
      choices: [
        'At the goal, pointing the right way',
        'At the goal, pointing the wrong way',
        'Beside the goal',
      ],
      /** @param {{ away: number, turned: number }} outcome */
      why: ({ away, turned }) =>
        `It stops ${fixed(away, 2)} m from the goal. Its largest turn rate was ${fixed(turned, 2)} rad/s: with a goal at rest the rule never turns, and V stays where it is. This is what the paper set out to mend.`,
    },
  },
  tries: {
    other: 'Another start: now {V} rises at times, though the proof forbids it',
    negativeTurn: '{kt} below zero: −2',
    track: 'A goal that drives away at 0.5 m/s: the law follows it',
    kanayamaTracks: 'Kanayama’s rule with the same moving goal: it follows, too',
  },
  notice: [
    'Early the blue part is the largest: most of {V} is lost by driving ahead.',
    'Close to the goal all parts are tiny, and the orange one the tiniest: the fourth power of a small number is very small. The last centimetres to the side take long.',
    'One spot is flat without being the bottom: [on the goal, turned by 180°](curves&view=stability&drives=hand&gains=3,1,5&start=2,2,-135deg). There every push is zero, and {V} stays at 2, as on the top of a hill. For seconds nothing happens. Then the last digits of the computer’s numbers have tipped the robot over.',
  ],
};
