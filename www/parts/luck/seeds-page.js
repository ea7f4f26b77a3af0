// The view of Luck in which one search runs with many seeds.
/** @import { Experiment, Statistics } from '../../core/engine.js' */
/** @import { Actions } from '../../run/actions/actions.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Tools } from '../part.js' */
/** @import { SeedSurvey } from './request.js' */
/** @import { Events } from './sight.js' */
import { render } from 'lit-html';
import { luckSlice } from './state.js';
import { byIdIn } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { hidesPaper } from '../../run/exercise.js';
import { isSameButSeed } from '../changes.js';
import words from './words/index.js';
import { createSeedCurve } from './curve.js';
import { createSeedRequests, surveyOf } from './request.js';
import { sight } from './sight.js';
import { createStrips } from './strips.js';

/** @param {HTMLElement} element @param {Tools} tools */
export function createSeeds(element, { engine, store, actions, paper }) {
  const requests = createSeedRequests(engine, store, paper);
  const { now: luck, update } = luckSlice.at(store);

  /** Drives with the gains that a seed ended with. @param {number} index */
  const choose = (index) => {
    const { soFar, result } = luck();
    const run = result?.runs[index];
    if (!run || soFar) return;
    update({ chosen: index });
    actions.driveGains(run.champion.gains, 'luck');
    actions.driveAgain();
  };
  /** @param {number} index */
  const point = (index) => {
    const pointed = index < 0 || luck().soFar ? null : index;
    if (pointed !== luck().pointed) update({ pointed });
  };
  const on = createEvents(store, actions, requests, choose);
  const isFresh = remember(
    (/** @type {Experiment} */ experiment, /** @type {SeedSurvey | null} */ result) =>
      !result || isSameButSeed(experiment, result.experiment),
  );
  const changed = watch();
  /** @param {State} state @param {number} index @param {boolean} fresh */
  const show = (state, index, fresh) => {
    if (!changed(luckSlice.of(state), hidesPaper(state), state.experiment, state.history, index, fresh))
      return;
    element.classList.toggle('stale', !fresh);
    render(sight(state, index, fresh, on), element);
  };
  show(store.get(), -1, true);
  const events = { onPoint: point, onChoose: choose };
  const curve = createSeedCurve(byIdIn(element, 'luck-curve'), events);
  const strips = createStrips(byIdIn(element, 'luck-gains'), events);
  const labLine = remember((/** @type {Statistics[]} */ history, /** @type {number} */ seed) => ({
    name: words.labLine(seed),
    costs: history.map(({ best }) => best.cost),
  }));
  const seedLine = remember((/** @type {SeedSurvey} */ { first, runs }, /** @type {number} */ index) => ({
    name: words.seedLine(first + index),
    costs: runs[index].best,
  }));

  return {
    /** @param {State} state */
    draw(state) {
      requests.follow();
      const { generations, log } = luckSlice.of(state);
      const survey = surveyOf(state);
      const fresh = isFresh(state.experiment, survey);
      const index = questionOf(state);
      const labSeed = state.experiment.evolution.seed;
      const isLab = survey && index >= 0 && fresh && survey.first + index === labSeed;
      curve.draw({
        survey,
        generations: survey?.generations ?? generations,
        lab: fresh && !isLab ? labLine(state.history, labSeed) : null,
        seed: survey && index >= 0 ? seedLine(survey, index) : null,
        index,
        log,
        theme: state.theme,
      });
      strips.draw({
        survey,
        paper: hidesPaper(state) ? null : (survey?.paper.gains ?? gainsOf(state, 'paper-ep', paper)),
        range: state.experiment.evolution.initialRange,
        index,
        theme: state.theme,
      });
      show(state, index, fresh);
    },
  };
}

/** The index of the seed in question: under the pointer, else chosen, else the lab's own; that alone while seeds run. @param {State} state */
function questionOf(state) {
  const { soFar, result, pointed, chosen } = luckSlice.of(state);
  const survey = soFar ?? result;
  if (!survey) return -1;
  const lab = state.experiment.evolution.seed - survey.first;
  const isRun = lab >= 0 && lab < survey.runs.length;
  if (soFar) return isRun ? lab : -1;
  return pointed ?? chosen ?? (isRun ? lab : survey.summary.ranking[0]);
}

/** @param {Store} store @param {Actions} actions @param {ReturnType<typeof createSeedRequests>} requests @param {(index: number) => void} choose @returns {Events} */
function createEvents(store, actions, requests, choose) {
  const { now: luck, update } = luckSlice.at(store);
  return {
    update,
    onRun: () => (luck().progress === null ? requests.run() : requests.cancel()),
    onRank: (rank) => choose(luck().result?.summary.ranking[rank - 1] ?? -1),
    onOpen: (seed, generation) => {
      actions.showSeed(seed, generation);
      actions.chooseDriver('evolved');
      actions.openPage('lab');
    },
  };
}
