// The part of the page that runs evolution with many seeds: how much of a result is luck?
import { luckSlice } from './state.js';
import { byId, write } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { luck as words } from '../../words/index.js';
import { createSeedCurve } from './curve.js';
import { createSeedRequests, drivesOf, isSameButSeed } from './request.js';
import { createStrips } from './strips.js';
import { offerTable } from '../../kit/table.js';
import { seedTable } from './table.js';

/** @typedef {import('../../core/engine.js').Experiment} Experiment */
/** @typedef {import('../../core/engine.js').Statistics} Statistics */
/** @typedef {import('../part.js').Tools} PageParts */
/** @typedef {import('../part.js').Page} Page */
/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../run/store.js').Store} Store */
/** @typedef {import('./state.js').LuckState} LuckState */
/** @typedef {import('./request.js').SeedSurvey} SeedSurvey */

const counts = [20, 100, 500];
const lengths = [50, 100, 200];

/** @param {PageParts} parts @returns {Page} */
export function createLuckPage({ engine, store, actions, paper }) {
  const requests = createSeedRequests(engine, store, paper);
  const luck = () => luckSlice.of(store.get());

  /** Drives with the gains that a seed ended with. @param {number} index */
  const choose = (index) => {
    const run = luck().result?.runs[index];
    if (!run) return;
    luckSlice.update(store, { chosen: index });
    actions.driveGains(run.champion.gains, 'luck');
    actions.driveAgain();
  };
  /** @param {number} index */
  const point = (index) => {
    const pointed = index < 0 ? null : index;
    if (pointed !== luck().pointed) luckSlice.update(store, { pointed });
  };
  const on = { onPoint: point, onChoose: choose };
  const curve = createSeedCurve(byId('luck-curve'), on);
  const strips = createStrips(byId('luck-gains'), on);
  offerTable('luck-table', () => {
    const { result } = luck();
    return result && seedTable(result);
  });
  const controls = createControls(store, {
    onRun: () => (luck().progress === null ? requests.run() : requests.cancel()),
    onRank: (rank) => choose(luck().result?.summary.ranking[rank - 1] ?? -1),
    onOpen: (seed) => {
      actions.useSeed(seed);
      actions.chooseDriver('evolved');
      actions.openPage('lab');
    },
  });

  const isFresh = remember(
    (/** @type {Experiment} */ experiment, /** @type {SeedSurvey | null} */ result) =>
      !result || isSameButSeed(experiment, result.experiment),
  );
  const labLine = remember((/** @type {Statistics[]} */ history, /** @type {number} */ seed) => ({
    name: words.labLine(seed),
    costs: history.map(({ best }) => best.cost),
  }));
  const seedLine = remember((/** @type {SeedSurvey} */ { first, runs }, /** @type {number} */ index) => ({
    name: words.seedLine(first + index),
    costs: runs[index].best,
  }));

  return {
    draw(state) {
      const { result, generations, log } = luckSlice.of(state);
      const fresh = isFresh(state.experiment, result);
      const index = questionOf(state);
      const seed = result && index >= 0 ? seedLine(result, index) : null;
      const labSeed = state.experiment.evolution.seed;
      const isLab = result && index >= 0 && fresh && result.first + index === labSeed;
      curve.draw({
        survey: result,
        generations: result?.generations ?? generations,
        lab: fresh && !isLab ? labLine(state.history, labSeed) : null,
        seed,
        index,
        log,
        theme: state.theme,
      });
      strips.draw({
        survey: result,
        paper: result?.paper.gains ?? gainsOf(state, 'paper-ep', paper),
        range: state.experiment.evolution.initialRange,
        index,
        theme: state.theme,
      });
      controls.draw(state, index, fresh);
    },
  };
}

/** The index of the seed in question: under the pointer, else chosen, else the lab's own. @param {State} state */
function questionOf(state) {
  const { experiment } = state;
  const { result, pointed, chosen } = luckSlice.of(state);
  if (!result) return -1;
  const lab = experiment.evolution.seed - result.first;
  return pointed ?? chosen ?? (lab >= 0 && lab < result.runs.length ? lab : result.summary.ranking[0]);
}

/**
 * @param {Store} store
 * @param {{ onRun: () => void, onRank: (rank: number) => void, onOpen: (seed: number) => void }} on
 */
function createControls(store, { onRun, onRank, onOpen }) {
  const run = byId('luck-run');
  /** @type {HTMLSelectElement} */
  const count = byId('luck-count');
  /** @type {HTMLSelectElement} */
  const generations = byId('luck-generations');
  /** @type {HTMLInputElement} */
  const log = byId('luck-log');
  /** @type {HTMLInputElement} */
  const rank = byId('luck-rank');
  /** @type {HTMLProgressElement} */
  const progress = byId('luck-progress');
  const open = byId('luck-open');
  count.replaceChildren(...counts.map((one) => new Option(words.countChoice(one), String(one))));
  generations.replaceChildren(...lengths.map((one) => new Option(words.generationsChoice(one), String(one))));

  run.addEventListener('click', onRun);
  count.addEventListener('change', () => luckSlice.update(store, { count: Number(count.value) }));
  generations.addEventListener('change', () =>
    luckSlice.update(store, { generations: Number(generations.value) }),
  );
  log.addEventListener('change', () => luckSlice.update(store, { log: log.checked }));
  rank.addEventListener('input', () => onRank(Number(rank.value)));
  open.addEventListener('click', () => onOpen(Number(open.dataset.seed)));
  const changed = watch();

  return {
    /** @param {State} state @param {number} index @param {boolean} fresh */
    draw(state, index, fresh) {
      const { experiment, history } = state;
      const luck = luckSlice.of(state);
      const { result } = luck;
      if (!changed(luck, experiment, history, index, fresh)) return;
      const runs = luck.progress !== null;
      write(run, runs ? words.cancel : words.runText(luck.count));
      progress.classList.toggle('visually-hidden', !runs);
      progress.value = luck.progress ?? 0;
      count.value = String(luck.count);
      generations.value = String(luck.generations);
      log.checked = luck.log;
      write(byId('luck-note'), noteText(state));
      write(byId('luck-status'), statusText(state, fresh));
      const finding = result
        ? words.finding(result)
        : words.invitation(luck.count, luck.generations, drivesOf(experiment, luck.generations));
      write(byId('luck-finding'), finding);
      byId('luck').classList.toggle('stale', !fresh);
      byId('luck-curve').setAttribute(
        'aria-label',
        result ? words.curveLabel(result, finding) : words.emptyCurveLabel,
      );
      byId('luck-gains').setAttribute(
        'aria-label',
        result ? words.gainsLabel(result) : words.emptyGainsLabel,
      );
      for (const id of ['luck-seed', 'luck-table', 'luck-median']) byId(id).hidden = !result;
      log.disabled = !result;
      if (!result || index < 0) return;
      const own = result.summary.ranking.indexOf(index) + 1;
      const text = words.readout(result, index, own);
      rank.max = String(result.runs.length);
      rank.value = String(own);
      rank.setAttribute('aria-valuetext', text);
      write(byId('luck-readout'), text);
      const seed = result.first + index;
      open.dataset.seed = String(seed);
      write(open, words.openSeed(seed));
      open.hidden = !fresh;
    },
  };
}

/** @param {State} state */
function noteText(state) {
  const { experiment, history } = state;
  const { result, progress, count } = luckSlice.of(state);
  if (progress !== null) return words.progressText(progress, count);
  return result ? words.surveyNote(result) : words.labNote(experiment.evolution.seed, history.length - 1);
}

/** @param {State} state @param {boolean} fresh */
function statusText(state, fresh) {
  const { experiment } = state;
  const { result, cancelled, message } = luckSlice.of(state);
  if (message) return words.failed(message, result !== null);
  const stale = result && !fresh ? words.outOfDate(changesOf(result.experiment, experiment)) : '';
  return [cancelled ? words.cancelled(result !== null) : '', stale].filter((text) => text !== '').join(' ');
}

/** What is another one now. @param {Experiment} then @param {Experiment} now @returns {import('../../words/common/luck.js').Change[]} */
function changesOf(then, now) {
  const named = /** @type {const} */ ([
    ['start', then.starts, now.starts],
    ['goal', then.goal, now.goal],
    ['limits', then.limits, now.limits],
  ]);
  const changes = named
    .filter(([, before, after]) => JSON.stringify(before) !== JSON.stringify(after))
    .map(([name]) => name);
  const { starts, goal, limits } = now;
  return isSameButSeed({ ...then, starts, goal, limits }, now) ? changes : [...changes, 'other'];
}
