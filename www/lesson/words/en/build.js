// The step “build” in English.

/** @import { Line } from '../../views/program.js' */
/** @import { Counts } from '../common.js' */

export const build = {
  texts: {
    begin: `The robot and its evolution fit into about seventy lines of program. This step says what they must contain, and gives you five numbers by which you know that yours are right.`,
    motion: `*The robot.* Its posture changes with {v} and {w}, and with nothing else. A program holds both for one sample of 0.01 s, in which the robot drives an exact arc: nothing is approximated. The law (5) gives {v} and {w}, for a goal at rest:`,
    errors: `*Its errors* change with {v} and {w} too. You need not integrate (4), for (3) gives the errors at every sample; but with (4) you can check the proof of step 4 with a pencil:`,
    program: `*The program.* One drive, and one generation. Press a phase in the figure: the lines that carry it out light up.`,
    check: `*Is it right?* Check the law first, then one drive, then another. All digits come from the program of this page as it runs now; yours may differ in the last two or three.`,
    task: `*An open task.* In step 12 one weight made the difference. Now leave the weights alone, {R} = 1, 1, and find another way to park from more than 95 % of unseen starts: a longer horizon, a penalty for each start that is missed, other starts to evolve on, a floor for {s} … Evolve, test on starts that you did not evolve on, and with five seeds. Say what your way costs, and whether it holds for another goal.`,
    recap: `*The lesson in seven sentences.*

*1.* Parking means bringing three errors to zero by choosing two velocities.

*2.* The law gives each error a gain, and its terms cancel so that one number, {V}, can only fall, as long as sin {te} is not 0 and the wheels do what is asked at every instant.

*3.* Real wheels saturate and computers wait between samples, so which gains are good is not a question for the proof alone.

*4.* {J} decides what “good” means, and its weights are a choice.

*5.* Evolution needs nothing but {J}: mutate, drive, compete, survive; the steps adapt themselves because good steps have good offspring.

*6.* Selection finds what few hands would try, but it stops where its steps collapse, and luck is part of it: one seed proves nothing.

*7.* An optimiser goes by the cost, not by what you meant, so test where you did not ask.`,
  },
  predictions: {
    title: 'Your predictions',
    /** @param {Counts} counts */
    counts: ({ all, answered, right }) =>
      `Of the ${all} questions on the path you have answered ${answered}; ${right === answered ? 'all' : right || 'none'} came out as you predicted.`,
    otherwise: 'These came out otherwise. What would you predict now?',
  },
  program: {
    label: 'One drive and one generation as pseudo-code',
    drive: /** @type {Line[]} */ ([
      [0, '', 'drive(gains):'],
      [1, '', 'posture ← start; t ← 0; integral ← 0'],
      [1, 'drive', 'repeat every 0.01 s:'],
      [2, 'drive', 'xₑ, yₑ, θₑ ← error(posture)          (3), θₑ wrapped to ±π'],
      [2, 'drive', 'stop if √(xₑ²+yₑ²) ≤ 0.05 m and |θₑ| ≤ 0.05, or t ≥ 10 s'],
      [2, 'drive', 'v, ω ← law(gains, xₑ, yₑ, θₑ)        (5), |sin θₑ| ≥ 10⁻⁶'],
      [2, 'drive', 'v ← clamp(v, ±2); ω ← clamp(ω, ±2π)'],
      [2, 'drive', 'integral ← integral + (xₑ²+yₑ²+θₑ² + R_v v² + R_ω ω²)·0.01'],
      [2, 'drive', 'h ← 0.005 ω; c ← 0.01 v sin(h)/h     (2); sin(0)/0 is 1'],
      [2, 'drive', 'x ← x + c cos(θ+h); y ← y + c sin(θ+h)'],
      [2, 'drive', 'θ ← θ + 2h; t ← t + 0.01'],
      [1, 'drive', 'J ← t + xₑ²+yₑ²+θₑ² + ½ integral + 1000 Σ max(0, −kᵢ)'],
    ]),
    generation: /** @type {Line[]} */ ([
      [0, 'parents', 'parents ← N = 20 of (gains ∈ [0.01, 10], σ = 1, J)'],
      [0, 'mutation', 'τ′ ← 1/√6; τ ← 1/√(2√3)'],
      [0, '', 'repeat for each generation:'],
      [1, 'mutation', 'for each parent, one offspring: common ← normal()'],
      [2, 'mutation', 'gainsⱼ ← parent’s gainsⱼ + parent’s σⱼ · normal()'],
      [2, 'mutation', 'σⱼ ← parent’s σⱼ · exp(τ′·common + τ·normal())'],
      [2, 'drive', 'J ← drive(gains)'],
      [1, 'tournament', 'for each of the 2N:'],
      [2, 'tournament', 'repeat 10 times: meet another at random'],
      [3, 'tournament', 'a win if own J ≤ its J'],
      [1, 'ranking', 'sort by wins, then by J'],
      [1, 'survivors', 'parents ← the first N'],
    ]),
  },
  values: {
    label: 'Five numbers to check a program with',
    heads: ['gains 3.23673, 0.09678, 5.17891 from (0, 0, 0) to (2, 2, 45°)', 'value'],
    rows: [
      'v that the law asks for at t = 0, in m/s',
      'ω that the law asks for at t = 0, in rad/s',
      'arrives after, in s',
      'J',
      'J of the gains 10, 10, 10',
    ],
  },
  downloads: {
    python: 'Save it in Python',
    javascript: 'Save it in JavaScript',
    about: 'About 70 lines each, without any library. The tests of this page run both against its own core.',
  },
  tries: {
    other: 'The task of step 12 with the goal at 0°: the same gains?',
    accelerate: 'The same with acceleration limits: what changes?',
    few: 'With six robots instead of twenty: does luck grow?',
  },
  notice: [
    'Random numbers of your own will not give this page’s evolutions digit by digit. Compare medians over many seeds instead.',
    'If the first two numbers are right and J is not, look at the order: is arrival tested before the command, and is the *limited* velocity in the integral?',
  ],
};
