// What stands around the map of robustness: its numbers, its controls and what the cursor reads.
/** @import { Scene } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Spec } from './request.js' */
/** @import { RobustnessState } from './state.js' */
import { html, render } from 'lit-html';
import { listed } from '../../kit/segmented.js';
import { halves, robustnessSlice } from './state.js';
import { segmentedOf, selectOf } from '../../kit/fields.js';
import { hasMovingReference } from '../../core/reference.js';
import { createTeller } from '../../lab/announcer.js';
import { tableButton } from '../../lab/table-sheet.js';
import { areShown } from './drives.js';
import { robustnessTable } from './table.js';
import { watch } from '../../kit/memo.js';
import { endsOf } from '../../run/state.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import {
  angleOf,
  cellNear,
  headingNear,
  headingOf,
  headings,
  nextHeading,
  holds,
  sharesBySide,
  startOf,
} from './grid.js';

const { texts } = words;

/** @typedef {{ note: string, share: string, summary: string, sides: string, rival: string, readout: string, isRead: boolean, ring: string }} Texts */

/** What stands around the map, drawn when it is another. @param {HTMLElement} element @param {Store} store */
export function createSight(element, store) {
  const changed = watch();
  const tell = createTeller('robustness');
  /** Until there is a new survey, the old number stands with its own name. @type {Pick<Texts, 'share' | 'sides'> & { name: string | null } | null} */
  let ofSurvey = null;
  const { update } = robustnessSlice.at(store);
  const on = {
    update,
    /** @param {string} choice */
    onHeadings: (choice) =>
      update({ heading: choice === 'all' ? null : headingNear(endsOf(store.get()).start.theta) }),
  };

  /** @param {State} state @param {Scene} scene @param {Spec} spec @param {Spec} rivalSpec */
  return (state, scene, spec, rivalSpec) => {
    const own = robustnessSlice.of(state);
    const { survey, rival, cursor } = own;
    const { generation, evolving } = state;
    const { comparisonDriver, driving } = scene;
    const { start } = endsOf(state);
    const { driver, found } = state;
    if (!changed(own, spec, rivalSpec, driver, found, generation, evolving, comparisonDriver, driving, start))
      return;
    const nameOf = (/** @type {State['driver']} */ driver) => lab.driverName(driver, generation, state.found);
    const follows = hasMovingReference(spec.experiment);
    const compared = rival?.spec === rivalSpec ? rival.tally.share : null;
    // Nobody waits for what could not be computed.
    const isOver = own.message !== '' && compared === null;
    if (follows) ofSurvey = { share: words.none, name: null, sides: '' };
    else if (survey?.spec === spec)
      ofSurvey = {
        share: words.percent(survey.tally.share),
        name: nameOf(driver),
        sides: words.sides(sharesBySide(survey.grid, spec.experiment.goal, survey.tally.count)),
      };
    else if (ofSurvey?.name === null) ofSurvey = null;
    // Before the first one its line stands where it will, but where none can come.
    const before = own.message
      ? { share: '', name: '', sides: '' }
      : { share: words.waits, name: nameOf(driver), sides: '' };
    const { name, ...told } = ofSurvey ?? before;
    const shown = {
      ...told,
      summary: name === null ? words.tracking : name && words.summary(name, own.heading !== null),
      note: noteText(own, spec),
      rival: follows || isOver ? '' : words.rivalText(nameOf(comparisonDriver), compared),
      readout: readoutText(state, scene),
      isRead: cursor !== null && !evolving,
      ring: (spec.experiment.disturbance.kind === 'random' ? words.ownDraws : words.ring)(
        headings,
        areShown(spec.experiment),
      ),
    };
    render(sight(own, shown, on), element);
    // What is said of the map before is not true of this one.
    const isStale = survey?.spec !== spec && own.message === '';
    element.setAttribute('aria-busy', String(isStale));
    const result = follows ? words.tracking : `${shown.share} ${shown.summary}.`;
    const said = own.message ? shown.readout : `${result} ${shown.readout}`;
    tell(isStale ? '' : said, isStale || evolving || cursor !== null);
  };
}

/** @param {RobustnessState} robustness @param {Texts} shown @param {{ update: (patch: Partial<RobustnessState>) => void, onHeadings: (choice: string) => void }} on */
function sight({ survey, message, quantity, heading, half }, shown, { update, onHeadings }) {
  const choice = heading === null ? 'all' : 'one';
  /** @type {[number, string][]} */
  const extents = halves.map((one) => [one, words.extent(one)]);
  return html`
    <div class="heading">
      <h2 id="robustness-title">${texts.robustnessTitle}</h2>
      <p id="robustness-note" class=${message ? 'muted failed' : 'muted'}>${shown.note}</p>
      ${tableButton('robustness', survey, robustnessTable)}
    </div>
    <p class="cost-line row"><span id="robustness-share" class="share">${shown.share}</span> <span class="muted"><span
      id="robustness-summary">${shown.summary}</span><br><span id="robustness-rival">${shown.rival}</span></span></p>
    <div class="bar survey-bar">
      ${segmentedOf('robustness-quantity', words.quantityLegend, listed(words.quantities), quantity, (chosen) => update({ quantity: chosen }))}
      <label class="survey-extent muted">${selectOf('robustness-half', texts.robustnessExtent, extents, half, (chosen) => update({ half: chosen, cursor: null }))}
        <span>${texts.robustnessAround}</span></label>
    </div>
    <div class="survey column">
      <div id="robustness-map" class="survey-map layers" data-picture="robustness" data-name=${words.texts.robustnessPicture} tabindex="0" role="application"
        aria-label=${words.mapLabel}
        aria-describedby="robustness-share robustness-summary robustness-sides robustness-readout">
        <canvas id="robustness-picture" aria-hidden="true"></canvas>
        <canvas id="robustness-marks" aria-hidden="true"></canvas>
      </div>
      <div class="survey-side">
        ${segmentedOf('robustness-headings', words.headingLegend, listed(words.headingChoices), choice, onHeadings)}
        <div id="robustness-rose" class="rose" data-picture="robustness" role="slider" tabindex="0"></div>
        <div id="robustness-legend" class="survey-legend not-in-small-figure" data-picture="robustness"></div>
      </div>
    </div>
    <p class="survey-ring not-in-figure">${shown.ring}</p>
    <p id="robustness-sides" class="visually-hidden">${shown.sides}</p>
    <p id="robustness-readout" class="readout not-in-figure" aria-live=${shown.isRead ? 'polite' : 'off'}>${shown.readout}</p>`;
}

/** @param {RobustnessState} robustness @param {Spec} spec */
function noteText({ survey, message }, spec) {
  if (message) return words.failed(message, survey !== null);
  if (survey?.spec !== spec) return words.computing;
  return words.startsText(survey.runs.arrived.length, survey.milliseconds);
}

/** What the cursor reads, or else the run that is watched. @param {State} state @param {Scene} scene */
function readoutText(state, scene) {
  const { survey, heading, cursor } = robustnessSlice.of(state);
  const { start } = endsOf(state);
  const { driving } = scene;
  const run = { heading: start.theta, outcome: lab.outcomeText(driving), cost: driving.cost.total };
  if (!survey) return '';
  const { grid, tally, runs, spec } = survey;
  const follows = hasMovingReference(spec.experiment);
  if (!cursor) {
    const counts =
      holds(grid, start) && !follows ? [words.there(tally.count[cellNear(grid, start)], headings)] : [];
    return [words.watched(start, run), ...counts].join(' ');
  }

  const cell = cellNear(grid, cursor);
  const place = startOf(grid, cell, 0);
  /** @param {number} index */
  const driveOf = (index) => {
    const at = cell * headings + index;
    return {
      heading: angleOf(index),
      outcome: lab.outcomeText({
        ...driving,
        outcome: runs.arrived[at] === 1 ? 'arrived' : 'horizon',
        finalTime: runs.finalTime[at],
      }),
      cost: runs.cost[at],
    };
  };
  const current = headingOf(grid, cell, start);
  if (heading !== null)
    return `${words.driveText(place, driveOf(heading))} ${words.clickToWatch(current === heading)}`;
  const counts = follows
    ? `${words.placeText(place)}.`
    : words.cellText(place, {
        arrived: tally.count[cell],
        headings,
        time: tally.time[cell],
        cost: tally.cost[cell],
      });
  const next = nextHeading(survey, cell, start);
  const arrives = follows || runs.arrived[cell * headings + next] === 1;
  return `${counts} ${
    current >= 0 ? words.watching(run, angleOf(next)) : words.invitation(angleOf(next), arrives)
  }`;
}
