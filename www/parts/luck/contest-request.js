// Asking the workers for a contest: a few seeds of each contestant at a time, so that what was done before a cancel is kept.
/** @import { Engine, Experiment, Trial } from '../../core/engine.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Contestant } from './contestants.js' */
import { isTooLongSurvey, mostRobotsOfCall } from '../../core/bounds.js';
import { messageOf } from '../../words/errors.js';
import { settings } from '../../words/index.js';
import { isWhole, partsOf } from './contest-asked.js';
import { entered } from './contestants.js';
import { luckSlice } from './state.js';
import words from './words/index.js';

/** A contestant: null is the lab's own search. The trials are in the order of the seeds. @typedef {{ name: Contestant | null, trials: readonly Trial[], error: string }} Line */
/**
 * @typedef {object} Contest
 * @property {Experiment} experiment Its own seed does not matter.
 * @property {number} seeds How many each was asked to run, from 1 on.
 * @property {number} budget In drives.
 * @property {readonly Line[]} lines The lab's own first.
 * @property {boolean} cancelled
 */

/** How many runs there are, and how many there would be in the end. @param {Contest} contest */
export function runsOf({ lines, seeds }) {
  const running = lines.filter(({ error }) => error === '');
  return {
    done: running.reduce((sum, { trials }) => sum + trials.length, 0),
    all: running.length * seeds,
  };
}

/** @param {Contest} contest @param {number} index @param {Partial<Line>} patch @returns {Contest} */
const withLine = (contest, index, patch) => ({
  ...contest,
  lines: contest.lines.map((line, i) => (i === index ? { ...line, ...patch } : line)),
});

/** Why it does not even begin; empty: it does. @param {Experiment} experiment @param {Pick<Contest, 'seeds' | 'budget'>} asked @param {number} count Of contestants. */
function refusalOf(experiment, { seeds, budget }, count) {
  const robots = count * seeds * budget;
  if (isTooLongSurvey(experiment, robots)) return words.tooLong(robots);
  const most = mostRobotsOfCall(experiment);
  return budget > most ? words.runTooLong(budget, most) : '';
}

/** @param {Engine} engine @param {Store} store */
export function createContestRequests(engine, store) {
  let newest = new AbortController();
  const { now: luck, update } = luckSlice.at(store);

  /** One part of one contestant. @param {Contest} asked @param {number} index @param {[number, number]} seeds @param {AbortSignal} signal */
  async function runPart({ experiment, lines, budget }, index, seeds, signal) {
    /** @param {(line: Line) => Partial<Line>} patchOf */
    const note = (patchOf) => {
      const { contest } = luck();
      if (!signal.aborted && contest)
        update({ contest: withLine(contest, index, patchOf(contest.lines[index])) });
    };
    try {
      const runs = await engine.surveys.trials(
        entered(experiment, lines[index].name),
        { seeds, drives: budget },
        { signal },
      );
      // What one part of has failed stays without trials.
      note(({ trials, error }) =>
        error ? {} : { trials: [...trials, ...runs].sort((a, b) => a.seed - b.seed) },
      );
    } catch (error) {
      note(() => ({ trials: [], error: settings.named(messageOf(error)) }));
    }
  }

  /** What was done stays. */
  function cancel() {
    newest.abort();
    const { contest } = luck();
    update({ contestRuns: false, contest: contest && { ...contest, cancelled: true } });
  }

  return {
    async run() {
      if (luck().contestRuns) cancel();
      const { experiment } = store.get();
      const { others, seeds, budget } = luck();
      const names = [null, ...others];
      const contestMessage = refusalOf(experiment, { seeds, budget }, names.length);
      if (contestMessage) return update({ contestMessage });
      newest = new AbortController();
      const { signal } = newest;
      const lines = names.map((name) => ({ name, trials: [], error: '' }));
      const contest = { experiment, seeds, budget, lines, cancelled: false };
      update({ contest, contestRuns: true, contestMessage: '' });
      // All contestants with the first seeds, then all with the next.
      const parts = partsOf(experiment, { seeds, budget }).flatMap((part) =>
        names.map((_, index) => runPart(contest, index, part, signal)),
      );
      await Promise.all(parts);
      if (!signal.aborted) update({ contestRuns: false });
    },

    /** Runs it where the lesson has asked for it, unless it is there. */
    follow() {
      const { contest, contestRuns, wanted } = luck();
      if (!wanted) return;
      update({ wanted: false });
      if (contestRuns || !isWhole(contest, store.get().experiment, luck())) this.run();
    },

    cancel,
  };
}
