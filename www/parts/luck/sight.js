// What Luck shows around its pictures: what is run, what was found, and one seed.
/** @import { State } from '../../run/state.js' */
/** @import { LuckState } from './state.js' */
import { html } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { counts, lengths, luckSlice } from './state.js';
import { checkOf, selectOf } from '../../kit/fields.js';
import { unlessDouble, valueIn } from '../../kit/templates.js';
import { showTable } from '../../lab/table-sheet.js';
import words from './words/index.js';
import { hidesPaper } from '../../run/exercise.js';
import { changesButSeed } from '../changes.js';
import { drivesOf, surveyOf } from './request.js';
import { seedTable } from './table.js';

/**
 * @typedef {object} Events
 * @property {(patch: Partial<LuckState>) => void} update
 * @property {() => void} onRun
 * @property {(rank: number) => void} onRank
 * @property {(seed: number, generation: number) => void} onOpen
 */

const { texts } = words;
const countChoices = counts.map((count) => /** @type {const} */ ([count, words.countChoice(count)]));
const lengthChoices = lengths.map(
  (length) => /** @type {const} */ ([length, words.generationsChoice(length)]),
);

/** @param {State} state @param {number} index @param {boolean} fresh @param {Events} on */
export function sight(state, index, fresh, on) {
  const luck = luckSlice.of(state);
  const { log, soFar } = luck;
  const survey = surveyOf(state);
  // What seeds say together is said once all have run.
  const result = soFar ? null : survey;
  const finding = result ? words.finding(result) : invitationOf(runOf(state));
  return html`
    <div class="heading">
      <h2 id="luck-title">${texts.luckTitle}</h2>
      <p class="muted"><span id="luck-note">${noteText(state)}</span>
        <button id="luck-table" type="button" class="link" .hidden=${!result} @click=${() => showTable(result && seedTable(result))}>${texts.luckTable}</button></p>
    </div>
    ${bar(luck, on)}
    <p id="luck-status" class="luck-status" role="status">${statusText(state, fresh)}</p>
    <p id="luck-finding" class="luck-finding not-in-small-figure" aria-live=${result || luck.progress !== null ? 'polite' : 'off'}>${finding}</p>
    <div class="heading luck-legend">
      <p class="muted" data-picture="luck-curve" data-name=${texts.luckCurvePicture}>${texts.luckCurve}</p>
      ${checkOf('luck-log', texts.luckLog, log, (isOn) => on.update({ log: isOn }), { more: 'muted', isDisabled: !survey })}
    </div>
    <div id="luck-curve" class="luck-curve picture" data-picture="luck-curve" role="img"
      aria-label=${survey ? words.curveLabel(survey, result ? finding : `${words.seedsOf(survey.runs.length, survey.count)}.`) : words.emptyCurveLabel}></div>
    <div class="heading luck-legend muted" data-picture="luck-gains"><p>${texts.luckGainsTitle}${hidesPaper(state) ? '' : words.paperSign}</p>
      <p id="luck-median" .hidden=${!survey}>${texts.luckMedian}</p></div>
    <canvas id="luck-gains" class="luck-gains large-figure-only" data-picture="luck-gains" data-name=${texts.luckGainsPicture} role="img"
      aria-label=${survey ? words.gainsLabel(survey) : words.emptyGainsLabel}></canvas>
    ${seedInQuestion(luck, index, fresh, on)}`;
}

/** What runs, whatever has been set since, or would run. @param {State} state */
function runOf({ experiment, ...state }) {
  const { progress, asked, count, generations } = luckSlice.of(state);
  return (progress !== null && asked) || { experiment, count, generations };
}

/** What a press will do, or does. @param {ReturnType<typeof runOf>} run */
const invitationOf = ({ experiment, count, generations }) =>
  words.invitation(experiment, count, generations, drivesOf(experiment, generations));

/** @param {LuckState} luck @param {Events} on */
function bar({ progress, count, generations }, { onRun, update }) {
  const runs = progress !== null;
  return html`
    <div class="bar luck-bar">
      <button id="luck-run" type="button" class=${runs ? '' : 'primary'} data-other=${words.runText(count)} @click=${unlessDouble(onRun)}>${runs ? words.cancel : words.runText(count)}</button>
      ${selectOf('luck-count', texts.luckCount, countChoices, count, (chosen) => update({ count: chosen }), runs)}
      ${selectOf('luck-generations', texts.luckGenerations, lengthChoices, generations, (chosen) => update({ generations: chosen }), runs)}
      <progress id="luck-progress" max="1" class=${runs ? '' : 'visually-hidden'} aria-label=${texts.luckProgress}
        .value=${progress ?? 0}></progress>
    </div>`;
}

/** While others run, the room of what was said of one stays. @param {LuckState} luck @param {number} index @param {boolean} fresh @param {Events} on */
function seedInQuestion({ soFar, result }, index, fresh, { onRank, onOpen }) {
  const isThere = result !== null && !soFar && index >= 0;
  const rank = isThere ? result.summary.ranking.indexOf(index) + 1 : 1;
  const readout = isThere ? words.readout(result, index, rank) : '';
  const seed = isThere ? result.first + index : 1;
  return html`
    <div id="luck-seed" class=${`luck-seed not-in-figure${soFar ? ' later' : ''}`} .hidden=${!result}>
      <label class="bar"><span class="muted">${texts.luckLuckiest}</span>
        <input id="luck-rank" type="range" min="1" step="1" aria-label=${texts.luckRank} aria-valuetext=${readout}
          .max=${String(result?.runs.length ?? 1)} .value=${live(String(rank))}
          @input=${(/** @type {Event} */ event) => onRank(Number(valueIn(event)))}>
        <span class="muted">${texts.luckUnluckiest}</span></label>
      <p id="luck-readout" class="luck-readout">${readout}</p>
      <button id="luck-open" type="button" .hidden=${!fresh} @click=${() => onOpen(seed, result?.generations ?? 0)}>${words.openSeed(seed)}</button>
    </div>`;
}

/** @param {State} state */
function noteText(state) {
  const { experiment, history } = state;
  const { result, progress } = luckSlice.of(state);
  const { count } = runOf(state);
  // A whole number of seeds may come a bit short of it.
  if (progress !== null) return words.seedsOf(Math.floor(progress * count + 1e-9), count);
  return result ? words.surveyNote(result) : words.labNote(experiment.evolution.seed, history.length - 1);
}

/** @param {State} state @param {boolean} fresh */
function statusText(state, fresh) {
  const { experiment } = state;
  const { soFar, result, cancelled, message } = luckSlice.of(state);
  if (message) return words.failed(message, result !== null);
  const survey = soFar ?? result;
  const stale = survey && !fresh ? words.outOfDate(changesButSeed(survey.experiment, experiment)) : '';
  return [cancelled ? words.cancelled(result !== null) : '', stale].filter((text) => text !== '').join(' ');
}
