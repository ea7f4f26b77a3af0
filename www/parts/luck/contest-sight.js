// What the contest shows around its picture: who runs, how much, the target, and the table with its verdicts.
/** @import { State } from '../../run/state.js' */
/** @import { Standing, Standings } from './contest-summary.js' */
/** @import { Contestant } from './contestants.js' */
/** @import { LuckState } from './state.js' */
import { html, noChange, nothing } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { selectOf } from '../../kit/fields.js';
import { choicesOf, listed } from '../../kit/segmented.js';
import { createSwatch } from '../../kit/swatch.js';
import { options, selectAll, unlessDouble, valueIn } from '../../kit/templates.js';
import { styles } from '../../run/pins.js';
import { numberOf } from '../../words/numbers.js';
import { runsOf } from './contest-request.js';
import { ingredientNames, mostOthers, rivalNames } from './contestants.js';
import { budgets, contestSeeds, luckSlice } from './state.js';
import words from './words/index.js';

/**
 * @typedef {object} ContestEvents
 * @property {(patch: Partial<LuckState>) => void} update
 * @property {() => void} redraw
 * @property {() => void} onContest
 * @property {() => void} onCsv
 */

const { contestTexts: texts } = words;
const seedChoices = contestSeeds.map((count) => /** @type {const} */ ([count, words.countChoice(count)]));
const budgetChoices = budgets.map((drives) => /** @type {const} */ ([drives, words.drivesChoice(drives)]));
const [legend, rows] = [0, 1].map(() => styles.map(createSwatch));

/** @param {State} state @param {Standings | null} standings @param {string} stale What of the lab has changed since. @param {boolean} isTyping What is typed stays. @param {ContestEvents} on */
export function contestSight(state, standings, stale, isTyping, on) {
  const luck = luckSlice.of(state);
  const { contest, contestRuns } = luck;
  const sentences = standings?.lines.map(heardOf).filter((text) => text !== '') ?? [];
  return html`
    <div class="heading">
      <h2 id="contest-title">${texts.title}</h2>
      <p class="muted"><span id="contest-note">${noteText(luck)}</span>
        <button id="contest-csv" type="button" class="link" .hidden=${contestRuns || !contest?.lines.some(({ trials }) => trials.length > 0)} @click=${on.onCsv}>${texts.csv}</button></p>
    </div>
    ${bar(luck, on)}
    ${entrants(luck, on)}
    <p id="contest-status" class="luck-status" role="status">${statusText(luck, stale)}</p>
    <p id="contest-said" class="visually-hidden" role="status">${contest && !contestRuns && !contest.cancelled ? `${noteText(luck)}. ${sentences.join(' ')}` : ''}</p>
    ${contest ? nothing : html`<p id="contest-finding" class="luck-finding not-in-small-figure">${words.contestInvitation(luck, state.experiment.starts.length)}</p>`}
    <fieldset id="contest-reading" class="segmented small" .hidden=${!standings?.lowest}>
      ${choicesOf('contest-reading', texts.reading, listed(words.readings), luck.reading, (reading) => on.update({ reading }))}
    </fieldset>
    <div class="luck-curve picture contest-chart"><div id="contest-chart" data-picture="contest" data-name=${texts.picture} role="img"
      aria-label=${words.contestLabel(sentences)}></div></div>
    ${contest && standings?.lowest ? [targetField(luck, standings, isTyping, on), fewerSeeds(luck, standings, on)] : nothing}
    ${standings ? table(standings) : nothing}`;
}

/** @param {LuckState} luck @param {ContestEvents} on */
function bar({ contest, contestRuns, others, seeds, budget }, { onContest, update }) {
  const { done, all } = contest ? runsOf(contest) : { done: 0, all: 1 };
  const runText = words.contestRunText(1 + others.length, seeds);
  return html`
    <div class="bar luck-bar contest-bar">
      <button id="contest-run" type="button" class=${contestRuns ? '' : 'primary'} data-other=${runText} @click=${unlessDouble(onContest)}>${contestRuns ? words.cancel : runText}</button>
      ${selectOf('contest-seeds', texts.seeds, seedChoices, seeds, (chosen) => update({ seeds: chosen }), contestRuns)}
      ${selectOf('contest-budget', texts.budget, budgetChoices, budget, (chosen) => update({ budget: chosen }), contestRuns)}
      <progress max="1" class=${contestRuns ? '' : 'visually-hidden'} aria-label=${texts.progress} .value=${contestRuns ? done / Math.max(1, all) : 0}></progress>
    </div>`;
}

/** Who runs: the lab's own, and as many others as there are colours. @param {LuckState} luck @param {ContestEvents} on */
function entrants({ others, contestRuns }, { update }) {
  const choose = (/** @type {number} */ place) => (/** @type {Event} */ event) => {
    const name = /** @type {Contestant | ''} */ (valueIn(event));
    const chosen = Array.from({ length: mostOthers }, (_, i) => (i === place ? name : (others[i] ?? '')));
    update({ others: [...new Set(chosen.filter((one) => one !== ''))] });
  };
  const named = (/** @type {readonly Contestant[]} */ names) =>
    names.map((name) => /** @type {const} */ ([name, words.contestantName(name)]));
  return html`<ul class="contestants not-in-figure not-on-paper">
    <li class="row">${legend[0]}<span>${words.asInLab}</span></li>
    ${Array.from({ length: mostOthers }, (_, i) => {
      const own = others[i] ?? '';
      return html`<li class="row">${legend[i + 1]}<select id="contestant-${i + 2}" aria-label=${words.contestantLabel(i + 2)}
        .disabled=${contestRuns} @change=${choose(i)}>${options([/** @type {const} */ (['', texts.nobody])], own)}
        <optgroup label=${texts.ingredients}>${options(named(ingredientNames), own)}</optgroup>
        <optgroup label=${texts.rivals}>${options(named(rivalNames), own)}</optgroup></select></li>`;
    })}
  </ul>`;
}

/** @param {LuckState} luck @param {Standings} standings @param {boolean} isTyping @param {ContestEvents} on */
function targetField({ target, targetError, contest }, standings, isTyping, { update, redraw }) {
  const change = (/** @type {Event} */ event) => {
    const text = valueIn(event);
    const value = numberOf(text);
    update(
      Number.isFinite(value)
        ? { target: value, targetError: '' }
        : { targetError: words.targetRefused(text) },
    );
  };
  return html`
    <div class="bar contest-target not-in-figure">
      <label class="bar"><span>${texts.target}</span>
        <input id="contest-target" type="text" inputmode="decimal" .value=${isTyping ? noChange : live(words.targetText(standings.target))}
          aria-describedby="contest-target-error" aria-invalid=${String(targetError !== '')}
          @focus=${selectAll} @blur=${redraw} @change=${change}></label>
      ${
        target === null
          ? html`<span id="contest-usual" class="muted">${standings.lowest ? words.usualTargetText(standings.lowest) : ''}</span>`
          : html`<button id="contest-usual" type="button" class="link" @click=${() => update({ target: null, targetError: '' })}>${texts.usualTarget}</button>`
      }
      <button id="contest-whole" type="button" class="link" .hidden=${standings.budget === contest?.budget}
        @click=${() => update({ until: null })}>${words.untilText(standings.budget)}</button>
      <span id="contest-target-error" class="contest-error" role="alert">${targetError}</span>
    </div>`;
}

/** What one would have said after fewer runs. @param {LuckState} luck @param {Standings} standings @param {ContestEvents} on */
function fewerSeeds({ draw, contestRuns }, { count, seeds }, { update }) {
  const change = (/** @type {Event} */ event) => {
    const only = Number(valueIn(event));
    update({ only: only === seeds ? null : only });
  };
  return html`
    <div class="bar contest-fewer not-in-figure">
      <label class="bar"><span>${texts.fewer}</span>
        <input id="contest-only" type="range" min="1" max=${seeds} .value=${live(String(count))} .disabled=${contestRuns} aria-valuetext=${words.seedsText(count, seeds)} @input=${change}></label>
      <span id="contest-count">${words.seedsText(count, seeds)}</span>
      <button id="contest-others" type="button" class="link" .disabled=${contestRuns || count === seeds} @click=${() => update({ draw: draw + 1 })}>${texts.otherSeeds}</button>
    </div>`;
}

/** @param {Standing} standing */
const sentenceOf = ({ name, error, verdict }) => error || (verdict ? words.verdictText(verdict, name) : '');

/** Away from its line, where one does not see whom it is about. @param {Standing} standing */
const heardOf = (standing) =>
  ['same', 'undecided'].includes(standing.verdict?.kind ?? '')
    ? `${words.shortName(standing.name)}: ${sentenceOf(standing)}`
    : sentenceOf(standing);

/** @param {Standings} standings */
const table = ({ lines }) => html`
  <div class="contest-scroll" tabindex="0" role="region" aria-label=${texts.caption}><table id="contest-table" class="contest-table" data-picture="contest">
    <caption class="visually-hidden">${texts.caption}</caption>
    <thead><tr><td></td>${words.contestColumns.map(({ text, hint }) => html`<th scope="col" title=${hint}>${text}</th>`)}</tr></thead>
    ${lines.map(
      (line, i) => html`<tbody data-contestant=${line.name ?? 'lab'}>
        <tr><th scope="row">${rows[i]}${words.shortName(line.name)}</th>${cellsOf(line).map((text, column) => html`<td>${text}${column === 1 ? intervalOf(line) : nothing}</td>`)}</tr>
        ${sentenceOf(line) === '' ? nothing : html`<tr class="verdict"><td colspan="6">${sentenceOf(line)}${line.told === null ? nothing : html` <span>${words.toldText(line.told, line.count)}</span>`}</td></tr>`}
      </tbody>`,
    )}
  </table></div>
  <p class="contest-columns muted large-figure-only">${words.columnsText}</p>`;

/** @param {Standing} line */
function cellsOf({ count, reached, ert, median, comparison }) {
  if (count === 0) return ['', '', '', '', ''];
  return [
    words.reachedText(reached, count),
    Number.isFinite(ert) ? words.wholeNumber(Math.round(ert)) : '∞',
    words.medianText(median),
    comparison ? words.pairsText(comparison.a12) : '',
    comparison ? words.probability(comparison.p) : '',
  ];
}

/** @param {Standing} line */
const intervalOf = ({ ert, interval }) =>
  interval && Number.isFinite(ert)
    ? html` <small>${words.intervalText(Math.round(interval[0]), Math.round(interval[1]))}</small>`
    : nothing;

/** @param {LuckState} luck */
function noteText({ contest, contestRuns }) {
  if (!contest) return '';
  const { done, all } = runsOf(contest);
  if (contestRuns) return words.contestProgress(done, all);
  return words.drivesChoice(done * contest.budget) + words.asOne(contest.experiment.starts.length);
}

/** @param {LuckState} luck @param {string} stale */
function statusText({ contest, contestMessage }, stale) {
  if (contestMessage) return contestMessage;
  const { done, all } = contest ? runsOf(contest) : { done: 0, all: 0 };
  return [contest?.cancelled ? words.contestCancelled(done, all) : '', stale]
    .filter((text) => text !== '')
    .join(' ');
}
