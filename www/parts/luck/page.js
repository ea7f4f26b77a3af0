// The part of the page that runs evolution with many seeds: how much of a result is luck?
import { luckSlice } from './state.js';
import { html, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { byId, create } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { luck as words, texts } from '../../words/index.js';
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
  const canvases = { curve: create('div', 'luck-curve'), gains: create('canvas', 'luck-gains') };
  const curve = createSeedCurve(canvases.curve, on);
  const strips = createStrips(/** @type {HTMLCanvasElement} */ (canvases.gains), on);
  const controls = createControls(byId('luck'), store, canvases, {
    onRun: () => (luck().progress === null ? requests.run() : requests.cancel()),
    onRank: (rank) => choose(luck().result?.summary.ranking[rank - 1] ?? -1),
    onOpen: (seed) => {
      actions.useSeed(seed);
      actions.chooseDriver('evolved');
      actions.openPage('lab');
    },
  });
  controls.draw(store.get(), -1, true);
  offerTable('luck-table', () => {
    const { result } = luck();
    return result && seedTable(result);
  });

  const modelsOf = createModels(paper);
  return {
    draw(state) {
      const models = modelsOf(state);
      curve.draw(models.curve);
      strips.draw(models.strips);
      controls.draw(state, models.index, models.fresh);
    },
  };
}

/** What the pictures show. @param {PageParts['paper']} paper */
function createModels(paper) {
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

  return (/** @type {State} */ state) => {
    const { result, generations, log } = luckSlice.of(state);
    const { theme } = state;
    const fresh = isFresh(state.experiment, result);
    const index = questionOf(state);
    const seed = result && index >= 0 ? seedLine(result, index) : null;
    const labSeed = state.experiment.evolution.seed;
    const isLab = result && index >= 0 && fresh && result.first + index === labSeed;
    const lab = fresh && !isLab ? labLine(state.history, labSeed) : null;
    return {
      index,
      fresh,
      curve: {
        survey: result,
        generations: result?.generations ?? generations,
        ...{ lab, seed, index, log, theme },
      },
      strips: {
        survey: result,
        paper: result?.paper.gains ?? gainsOf(state, 'paper-ep', paper),
        range: state.experiment.evolution.initialRange,
        ...{ index, theme },
      },
    };
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

/** @typedef {{ onRun: () => void, onRank: (rank: number) => void, onOpen: (seed: number) => void }} Events */
/** @typedef {{ curve: HTMLElement, gains: HTMLElement }} Canvases */

/** @param {HTMLElement} root @param {Store} store @param {Canvases} canvases @param {Events} events */
function createControls(root, store, canvases, events) {
  for (const [name, canvas] of Object.entries(canvases)) {
    canvas.id = `luck-${name}`;
    canvas.setAttribute('role', 'img');
    canvas.dataset.picture = `luck-${name}`;
  }
  const on = {
    ...events,
    count: (/** @type {Event} */ event) => luckSlice.update(store, { count: chosenIn(event) }),
    generations: (/** @type {Event} */ event) => luckSlice.update(store, { generations: chosenIn(event) }),
    log: (/** @type {Event} */ { target }) =>
      luckSlice.update(store, { log: /** @type {HTMLInputElement} */ (target).checked }),
  };
  const changed = watch();

  return {
    /** @param {State} state @param {number} index @param {boolean} fresh */
    draw(state, index, fresh) {
      const { experiment, history } = state;
      const luck = luckSlice.of(state);
      if (!changed(luck, experiment, history, index, fresh)) return;
      const { result } = luck;
      const finding = result
        ? words.finding(result)
        : words.invitation(luck.count, luck.generations, drivesOf(experiment, luck.generations));
      root.classList.toggle('stale', !fresh);
      canvases.curve.setAttribute(
        'aria-label',
        result ? words.curveLabel(result, finding) : words.emptyCurveLabel,
      );
      canvases.gains.setAttribute('aria-label', result ? words.gainsLabel(result) : words.emptyGainsLabel);
      render(
        html`
          ${surveyBar(luck, noteText(state), on)}
          <p id="luck-status" class="luck-status" role="status">${statusText(state, fresh)}</p>
          <p id="luck-finding" class="luck-finding">${finding}</p>
          <div class="heading luck-legend">
            <p class="muted" data-picture="luck-curve">${texts.luckCurve}</p>
            <label class="check muted"><input id="luck-log" type="checkbox" .checked=${live(luck.log)} .disabled=${!result} @change=${on.log}> <span>${texts.luckLog}</span></label>
          </div>
          ${canvases.curve}
          <div class="heading luck-legend muted" data-picture="luck-gains"><p>${texts.luckGainsTitle}</p><p id="luck-median" .hidden=${!result}>${texts.luckMedian}</p></div>
          ${canvases.gains}
          ${seedBar(result, index, fresh, on)}`,
        root,
      );
    },
  };
}

/** @param {Event} event */
const chosenIn = ({ target }) => Number(/** @type {HTMLSelectElement} */ (target).value);

/** @param {readonly number[]} choices @param {number} chosen @param {(choice: number) => string} text */
const options = (choices, chosen, text) =>
  choices.map(
    (one) => html`<option value=${String(one)} .selected=${live(one === chosen)}>${text(one)}</option>`,
  );

/** What to run. @param {LuckState} luck @param {string} note @param {Pick<Events, 'onRun'> & Record<'count' | 'generations', (event: Event) => void>} on */
function surveyBar({ result, progress, count, generations }, note, on) {
  const runs = progress !== null;
  return html`
    <div class="heading">
      <h2 id="luck-title">${texts.luckTitle}</h2>
      <p class="muted"><span id="luck-note">${note}</span> <button id="luck-table" type="button" class="link" .hidden=${!result}>${texts.luckTable}</button></p>
    </div>
    <div class="bar luck-bar">
      <button id="luck-run" type="button" class="primary" @click=${on.onRun}>${runs ? words.cancel : words.runText(count)}</button>
      <select id="luck-count" aria-label=${texts.luckCount} @change=${on.count}>${options(counts, count, words.countChoice)}</select>
      <select id="luck-generations" aria-label=${texts.luckGenerations} @change=${on.generations}>${options(lengths, generations, words.generationsChoice)}</select>
      <progress id="luck-progress" class=${runs ? '' : 'visually-hidden'} max="1" .value=${progress ?? 0} aria-label=${texts.luckProgress}></progress>
    </div>`;
}

/** The seed in question. @param {SeedSurvey | null} result @param {number} index @param {boolean} fresh @param {Events} on */
function seedBar(result, index, fresh, on) {
  const own = result ? result.summary.ranking.indexOf(index) + 1 : 1;
  const text = result && index >= 0 ? words.readout(result, index, own) : '';
  const seed = (result?.first ?? 0) + index;
  const onRank = (/** @type {Event} */ event) => on.onRank(chosenIn(event));
  return html`
    <div id="luck-seed" class="luck-seed" .hidden=${!result}>
      <label class="bar"><span class="muted">${texts.luckLuckiest}</span> <input id="luck-rank" type="range" min="1" step="1" aria-label=${texts.luckRank} aria-valuetext=${text} .max=${String(result?.runs.length ?? 1)} .value=${live(String(own))} @input=${onRank}> <span class="muted">${texts.luckUnluckiest}</span></label>
      <p id="luck-readout" class="luck-readout">${text}</p>
      <button id="luck-open" type="button" .hidden=${!fresh} @click=${() => on.onOpen(seed)}>${words.openSeed(seed)}</button>
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
