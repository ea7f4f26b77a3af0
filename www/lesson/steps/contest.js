// Which part of the method does the work, and is it better than its rivals? What so many runs can tell of that.
import { contestOf, isWhole } from '../../parts/luck/contest-asked.js';
import { standingsOf } from '../../parts/luck/contest-summary.js';
import { luckSlice } from '../../parts/luck/state.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Contestant } from '../../parts/luck/contestants.js' */
/** @import { Standing } from '../../parts/luck/contest-summary.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Live } from '../page.js' */
/** @import { Quiz } from '../questions/quiz.js' */
/** @import { Written } from '../steps.js' */
/** @typedef {Pick<Standing, 'name' | 'count' | 'reached' | 'ert' | 'comparison' | 'told'>} Row What the words tell of a contestant. */

/** A little above the best that is known, and far above it. */
const [near, far] = [7.72, 8.09];
const budget = 4000;
const few = 5;

/** @param {readonly Contestant[]} others @param {number} target @param {number} [drives] */
const asked = (others, target, drives = budget) =>
  `luck&luck=contest&contestants=${others.join()}&seeds=51&budget=${drives}&target=${target}`;

/** The contest in sight; where it is not whole, it is run aside. @param {Live} live */
async function contestIn({ engine, state }) {
  const luck = luckSlice.of(state);
  const { contest } = luck;
  return contest && isWhole(contest, state.experiment, luck)
    ? contest
    : contestOf(engine, state.experiment, luck);
}

/** Below zero: worse than the first; 0: not to be told apart. @param {Row} row */
export const sideOf = ({ comparison }) => comparison?.side ?? 0;

/** The contest that is set up runs. @param {Store} store */
const begins = (store) => luckSlice.update(store, { wanted: true });

/** A question that a contest answers. @param {string} shows @param {Quiz['answer']} answer @param {readonly number[]} order @returns {Quiz} */
const contestQuiz = (shows, answer, order) => ({
  shows,
  order,
  begins,
  of: (state) => {
    const { others, seeds, budget } = luckSlice.of(state);
    return [others, seeds, budget];
  },
  ready: ({ state }) => !luckSlice.of(state).wanted && !luckSlice.of(state).contestRuns,
  answer,
});

const tournament = contestQuiz(
  asked(['truncation'], near),
  async (live) => {
    const [first, other] = standingsOf(await contestIn(live), { target: near }).lines;
    return { right: [0, 2, 1][sideOf(other) + 1], first, other, target: near };
  },
  [0, 2, 1],
);

const sigma = contestQuiz(
  asked(['fixed'], far),
  async (live) => {
    const contest = await contestIn(live);
    const [early, late] = [far, near].map((target) => standingsOf(contest, { target }).lines);
    const [isEarly, isLate] = [early, late].map(([, fixed]) => sideOf(fixed) < 0);
    return { right: isLate ? (isEarly ? 0 : 1) : isEarly ? 3 : 2, early, late, far, near };
  },
  [1, 0, 3, 2],
);

const fewer = contestQuiz(
  `${asked(['fixed'], near)}&only=${few}`,
  async (live) => {
    const { lines } = standingsOf(await contestIn(live), { target: near, only: few });
    const told = lines[1].told ?? 100;
    return { right: told > 80 ? 0 : told >= 20 ? 1 : 2, told, few, near };
  },
  [0, 2, 1],
);

const crowd = contestQuiz(
  `${asked(['n-100'], near, 20_000)}&until=${budget}`,
  async (live) => {
    const contest = await contestIn(live);
    const [early, late] = [budget, contest.budget].map((until) =>
      standingsOf(contest, { target: near, until }),
    );
    const isAhead = ({ lines: [first, other] } = early) => other.reached > first.reached;
    return {
      right: isAhead(late) ? (isAhead(early) ? 2 : 1) : isAhead(early) ? 3 : 0,
      early: early.lines,
      late: late.lines,
      drives: [early.budget, late.budget],
      near,
    };
  },
  [1, 3, 2, 0],
);

const rivals = contestQuiz(
  asked(['de', 'cma-es-7'], near),
  async (live) => {
    const { lines } = standingsOf(await contestIn(live), { target: near });
    const erts = lines.map(({ ert }) => ert);
    return { right: erts.indexOf(Math.min(...erts)), lines, near };
  },
  [0, 2, 1],
);

/** @type {Written} */
export const contest = {
  figure: 'evolve',
  blocks: [
    { kind: 'text', name: 'begin' },
    quiz('tournament', tournament),
    { kind: 'text', name: 'read', after: 'tournament' },
    quiz('sigma', sigma),
    { kind: 'text', name: 'drag', after: 'sigma' },
    quiz('fewer', fewer),
    { kind: 'text', name: 'slide', after: 'fewer' },
    quiz('crowd', crowd),
    { kind: 'text', name: 'budget', after: 'crowd' },
    quiz('rivals', rivals),
    { kind: 'text', name: 'ellipse', after: 'rivals' },
    tries(
      [
        ['floor', asked(['floor-0.1', 'fixed'], near, 20_000)],
        ['crossover', asked(['crossover', 'cauchy', 'parent'], near)],
        ['robots', asked(['n-6', 'n-100'], 7.8)],
        ['hand', asked(['hand', 'one-at-a-time', 'nelder-mead'], 7.8)],
        ['remedies', asked(['cma-es-7', 'cma-es-7-mirror', 'cma-es'], near)],
      ],
      begins,
    ),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
};
