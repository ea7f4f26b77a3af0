// The view of Luck in which several searches run with the same seeds and drives.
/** @import { State } from '../../run/state.js' */
/** @import { Tools } from '../part.js' */
/** @import { Contest } from './contest-request.js' */
import { render } from 'lit-html';
import { download } from '../../kit/download.js';
import { byIdIn } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { changesButSeed } from '../changes.js';
import { isAsked } from './contest-asked.js';
import { createContestChart } from './contest-chart.js';
import { createContestRequests } from './contest-request.js';
import { contestSight } from './contest-sight.js';
import { contestCsv, standingsOf } from './contest-summary.js';
import { luckSlice } from './state.js';
import words from './words/index.js';

/** @param {HTMLElement} element @param {Pick<Tools, 'engine' | 'store'>} tools */
export function createContest(element, { engine, store }) {
  const requests = createContestRequests(engine, store);
  const { now: luck, update } = luckSlice.at(store);
  const on = {
    update,
    redraw: store.redraw,
    onContest: () => (luck().contestRuns ? requests.cancel() : requests.run()),
    onCsv() {
      const { contest } = luck();
      if (contest) download(words.contestFile(contest), 'text/csv', contestCsv(contest));
    },
  };
  const standings = remember(
    /** @param {Contest | null} contest @param {number | null} target @param {number | null} until @param {number | null} only @param {number} draw */
    (contest, target, until, only, draw) =>
      contest ? standingsOf(contest, { target, until, only, draw }) : null,
  );
  const changes = remember(changesButSeed);
  /** Why what is shown is not what Run would show. @param {State} state */
  const staleText = (state) => {
    const own = luckSlice.of(state);
    if (!own.contest) return '';
    const since = changes(own.contest.experiment, state.experiment);
    if (since.length > 0) return words.outOfDate(since);
    return isAsked(own.contest, own) ? '' : words.otherContest;
  };
  const changed = watch();
  /** @param {State} state */
  const show = (state) => {
    const { contest, target, until, only, draw } = luckSlice.of(state);
    const found = standings(contest, target, until, only, draw);
    const isTyping = document.activeElement?.id === 'contest-target';
    if (!changed(luckSlice.of(state), state.experiment, isTyping)) return found;
    const stale = staleText(state);
    element.classList.toggle('stale', stale !== '');
    render(contestSight(state, found, stale, isTyping, on), element);
    return found;
  };
  show(store.get());
  // As many digits as the field shows.
  const chart = createContestChart(byIdIn(element, 'contest-chart'), {
    onTarget: (target) =>
      update({ target: Number(words.targetText(target).replace('−', '-')), targetError: '' }),
    onUntil: (drives) => update({ until: drives === luck().contest?.budget ? null : drives }),
  });

  return {
    /** @param {State} state */
    draw(state) {
      requests.follow();
      const { contest, budget, reading } = luckSlice.of(state);
      chart.draw({ contest, standings: show(state), budget, reading, theme: state.theme });
    },
  };
}
