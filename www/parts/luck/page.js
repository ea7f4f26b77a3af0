// The part of the page that runs evolution with many seeds: how much of a result is luck?
import { html, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { luckSlice } from './state.js';
import { byIdIn } from '../../kit/elements.js';
import { options, valueIn } from '../../kit/templates.js';
import { createSection } from '../section.js';
import { remember, watch } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import words from './words/index.js';
import { createSeedCurve } from './curve.js';
import { createSeedRequests, drivesOf, isSameButSeed } from './request.js';
import { createStrips } from './strips.js';
import { showTable } from '../../kit/table.js';
import { seedTable } from './table.js';

/** @typedef {import('../../core/engine.js').Experiment} Experiment */
/** @typedef {import('../../core/engine.js').Statistics} Statistics */
/** @typedef {import('../part.js').Tools} PageParts */
/** @typedef {import('../part.js').Page} Page */
/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../run/store.js').Store} Store */
/** @typedef {import('./state.js').LuckState} LuckState */
/** @typedef {import('./request.js').SeedSurvey} SeedSurvey */

/**
 * @typedef {object} Events
 * @property {(patch: Partial<LuckState>) => void} update
 * @property {() => void} onRun
 * @property {(rank: number) => void} onRank
 * @property {(seed: number) => void} onOpen
 * @property {() => void} onTable
 */

const { texts } = words;
const counts = [20, 100, 500].map((count) => /** @type {const} */ ([count, words.countChoice(count)]));
const lengths = [50, 100, 200].map(
  (length) => /** @type {const} */ ([length, words.generationsChoice(length)]),
);

/** @param {PageParts} parts @returns {Page} */
export function createLuckPage({ engine, store, actions, paper }) {
  const element = createSection('luck');
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
  /** @type {Events} */
  const on = {
    update: (patch) => luckSlice.update(store, patch),
    onRun: () => (luck().progress === null ? requests.run() : requests.cancel()),
    onRank: (rank) => choose(luck().result?.summary.ranking[rank - 1] ?? -1),
    onOpen: (seed) => {
      actions.useSeed(seed);
      actions.chooseDriver('evolved');
      actions.openPage('lab');
    },
    onTable: () => {
      const { result } = luck();
      showTable(result && seedTable(result));
    },
  };
  const isFresh = remember(
    (/** @type {Experiment} */ experiment, /** @type {SeedSurvey | null} */ result) =>
      !result || isSameButSeed(experiment, result.experiment),
  );
  const changed = watch();
  /** @param {State} state @param {number} index @param {boolean} fresh */
  const show = (state, index, fresh) => {
    if (!changed(luckSlice.of(state), state.experiment, state.history, index, fresh)) return;
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
    element,
    draw(state) {
      const { result, generations, log } = luckSlice.of(state);
      const fresh = isFresh(state.experiment, result);
      const index = questionOf(state);
      const labSeed = state.experiment.evolution.seed;
      const isLab = result && index >= 0 && fresh && result.first + index === labSeed;
      curve.draw({
        survey: result,
        generations: result?.generations ?? generations,
        lab: fresh && !isLab ? labLine(state.history, labSeed) : null,
        seed: result && index >= 0 ? seedLine(result, index) : null,
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
      show(state, index, fresh);
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

/** @param {State} state @param {number} index @param {boolean} fresh @param {Events} on */
function sight(state, index, fresh, on) {
  const luck = luckSlice.of(state);
  const { result, log } = luck;
  const finding = result
    ? words.finding(result)
    : words.invitation(luck.count, luck.generations, drivesOf(state.experiment, luck.generations));
  return html`
    <div class="heading">
      <h2 id="luck-title">${texts.luckTitle}</h2>
      <p class="muted"><span id="luck-note">${noteText(state)}</span>
        <button id="luck-table" type="button" class="link" .hidden=${!result} @click=${on.onTable}>${texts.luckTable}</button></p>
    </div>
    ${bar(luck, on)}
    <p id="luck-status" class="luck-status" role="status">${statusText(state, fresh)}</p>
    <p id="luck-finding" class="luck-finding">${finding}</p>
    <div class="heading luck-legend">
      <p class="muted" data-picture="luck-curve">${texts.luckCurve}</p>
      <label class="check muted"><input id="luck-log" type="checkbox" .checked=${live(log)} .disabled=${!result}
        @change=${() => on.update({ log: !log })}> <span>${texts.luckLog}</span></label>
    </div>
    <div id="luck-curve" class="luck-curve" data-picture="luck-curve" role="img"
      aria-label=${result ? words.curveLabel(result, finding) : words.emptyCurveLabel}></div>
    <div class="heading luck-legend muted" data-picture="luck-gains"><p>${texts.luckGainsTitle}</p>
      <p id="luck-median" .hidden=${!result}>${texts.luckMedian}</p></div>
    <canvas id="luck-gains" class="luck-gains" data-picture="luck-gains" role="img"
      aria-label=${result ? words.gainsLabel(result) : words.emptyGainsLabel}></canvas>
    ${seedInQuestion(result, index, fresh, on)}`;
}

/** @param {LuckState} luck @param {Events} on */
function bar({ progress, count, generations }, { onRun, update }) {
  const runs = progress !== null;
  return html`
    <div class="bar luck-bar">
      <button id="luck-run" type="button" class="primary" @click=${onRun}>${runs ? words.cancel : words.runText(count)}</button>
      <select id="luck-count" aria-label=${texts.luckCount}
        @change=${(/** @type {Event} */ event) => update({ count: Number(valueIn(event)) })}>${options(counts, count)}</select>
      <select id="luck-generations" aria-label=${texts.luckGenerations}
        @change=${(/** @type {Event} */ event) => update({ generations: Number(valueIn(event)) })}>${options(lengths, generations)}</select>
      <progress id="luck-progress" max="1" class=${runs ? '' : 'visually-hidden'} aria-label=${texts.luckProgress}
        .value=${progress ?? 0}></progress>
    </div>`;
}

/** @param {SeedSurvey | null} result @param {number} index @param {boolean} fresh @param {Events} on */
function seedInQuestion(result, index, fresh, { onRank, onOpen }) {
  const isThere = result !== null && index >= 0;
  const rank = isThere ? result.summary.ranking.indexOf(index) + 1 : 1;
  const readout = isThere ? words.readout(result, index, rank) : '';
  const seed = isThere ? result.first + index : 1;
  return html`
    <div id="luck-seed" class="luck-seed" .hidden=${!result}>
      <label class="bar"><span class="muted">${texts.luckLuckiest}</span>
        <input id="luck-rank" type="range" min="1" step="1" aria-label=${texts.luckRank} aria-valuetext=${readout}
          .max=${String(result?.runs.length ?? 1)} .value=${live(String(rank))}
          @input=${(/** @type {Event} */ event) => onRank(Number(valueIn(event)))}>
        <span class="muted">${texts.luckUnluckiest}</span></label>
      <p id="luck-readout" class="luck-readout">${readout}</p>
      <button id="luck-open" type="button" .hidden=${!fresh} @click=${() => onOpen(seed)}>${words.openSeed(seed)}</button>
    </div>`;
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

/** What is another one now. @param {Experiment} then @param {Experiment} now @returns {import('./words/common.js').Change[]} */
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
