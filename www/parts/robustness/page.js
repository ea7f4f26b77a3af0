// The part of the page that shows from where one set of gains arrives, and what its controls do.
import { halves, robustnessSlice } from './state.js';
import { byId, followSize, write } from '../../kit/elements.js';
import { createSegmented } from '../../kit/segmented.js';
import { offerTable } from '../../kit/table.js';
import { robustnessTable } from './table.js';
import { arrowOf, isChord } from '../../kit/keyboard.js';
import { remember, watch } from '../../kit/memo.js';
import { endsOf } from '../../run/state.js';
import { lab, robustness as words } from '../../words/index.js';
import {
  angleOf,
  cellNear,
  gridAround,
  headingNear,
  headingOf,
  headings,
  holds,
  placeOf,
  sharesBySide,
  startOf,
  worstHeading,
} from './grid.js';
import { createLegend } from './legend.js';
import { createSpec, createSurveyRequests } from './request.js';
import { createRose } from './rose.js';
import { createShading } from './scale.js';
import { axesOf, createMap } from './view.js';

/** @typedef {import('../../run/actions/actions.js').Actions} Actions */
/** @typedef {import('../../run/scene.js').Scene} Scene */
/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../run/store.js').Store} Store */
/** @typedef {import('./request.js').Quantity} Quantity */
/** @typedef {import('./state.js').RobustnessState} RobustnessState */
/** @typedef {import('./request.js').Spec} Spec */
/** @typedef {import('./request.js').Survey} Survey */
/** @typedef {import('./scale.js').Shading} Shading */
/** @typedef {import('./view.js').MapModel} MapModel */

/** @param {import('../part.js').Tools} parts @returns {import('../part.js').Page} */
export function createRobustnessPage({ engine, store, actions, paper }) {
  const specOf = createSpec(paper);
  const rivalSpecOf = createSpec(paper);
  const requests = createSurveyRequests(engine, store);
  const map = createMap({ picture: byId('robustness-picture'), marks: byId('robustness-marks') });
  const legend = createLegend(byId('robustness-legend'));
  const controls = createControls(store);
  const texts = createTexts();
  const rose = createRose(byId('robustness-rose'), {
    chosen: () => robustnessSlice.of(store.get()).heading,
    onChoose: (heading) => robustnessSlice.update(store, { heading }),
  });
  const shadingOf = remember(createShading);
  const emptyGrid = remember(gridAround);
  const partsOf = remember(partsOfRose);
  const angle = remember((/** @type {number | null} */ heading) =>
    heading === null ? null : angleOf(heading),
  );
  const size = followSize(byId('robustness-map'), () => store.redraw());
  offerTable('robustness-table', () => {
    const { survey } = robustnessSlice.of(store.get());
    return survey && robustnessTable(survey);
  });
  followMap(store, actions, size);

  return {
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const { survey, heading, quantity, half, cursor } = robustnessSlice.of(state);
      const spec = specOf(state, state.driver);
      const rivalSpec = rivalSpecOf(state, scene.comparisonDriver);
      requests.follow(spec, rivalSpec, state.dragging);

      const watched = endsOf(state).start;
      const grid = survey?.grid ?? emptyGrid(state.experiment.goal, half, 2);
      const shading = survey && shadingOf(survey, quantity, heading);
      map.draw({
        grid,
        shading,
        heading: angle(heading),
        goal: survey?.spec.experiment.goal ?? state.experiment.goal,
        starts: state.experiment.starts,
        watched,
        run: scene.driving,
        cursor,
        size: size(),
        theme: state.theme,
      });
      controls.draw(robustnessSlice.of(state));
      if (shading) legend.draw({ shading, quantity, heading, theme: state.theme });
      const cell = cellNear(grid, cursor ?? watched);
      rose.draw({ heading, parts: survey && shading ? partsOf(survey, shading, quantity, cell) : noParts });
      texts.draw(state, scene, { spec, rivalSpec });
    },
  };
}

/** @type {(number | null)[]} */
const noParts = Array(headings).fill(null);

/** Of each heading of a cell the part of the scale. @param {Survey} survey @param {Shading} shading @param {Quantity} quantity @param {number} cell */
function partsOfRose({ runs }, shading, quantity, cell) {
  const { arrived, finalTime, cost } = runs;
  const values = { share: arrived, time: finalTime, cost }[quantity];
  return noParts.map((_, heading) => {
    const run = cell * headings + heading;
    return arrived[run] ? shading.part(values[run]) : null;
  });
}

/** A cursor for pointer and keys, and the drives from where it is. @param {Store} store @param {Actions} actions @param {() => MapModel['size']} size */
function followMap(store, actions, size) {
  const element = byId('robustness-map');
  element.setAttribute('aria-label', words.mapLabel);

  /** @param {MouseEvent} event */
  const pointAt = (event) => {
    const { survey } = robustnessSlice.of(store.get());
    if (!survey) return null;
    const { left, top } = element.getBoundingClientRect();
    const { frame, x, y } = axesOf({ grid: survey.grid, size: size() });
    const [px, py] = [event.clientX - left, event.clientY - top];
    const inside = px >= frame.left && px <= frame.right && py >= frame.top && py <= frame.bottom;
    return inside ? { x: x.invert(px), y: y.invert(py) } : null;
  };
  /** @param {{ x: number, y: number } | null} point */
  const driveFrom = (point) => {
    const { survey, heading } = robustnessSlice.of(store.get());
    if (!survey || !point) return;
    const cell = cellNear(survey.grid, point);
    actions.tryStart(
      startOf(survey.grid, cell, heading ?? nextHeading(survey, cell, endsOf(store.get()).start)),
    );
  };

  element.addEventListener('click', (event) => {
    const cursor = pointAt(event);
    robustnessSlice.update(store, { cursor });
    driveFrom(cursor);
  });
  element.addEventListener('pointermove', (event) => {
    if (event.pointerType !== 'touch') robustnessSlice.update(store, { cursor: pointAt(event) });
  });
  element.addEventListener('pointerleave', (event) => {
    if (event.pointerType !== 'touch') robustnessSlice.update(store, { cursor: null });
  });
  element.addEventListener('blur', () => robustnessSlice.update(store, { cursor: null }));

  element.addEventListener('keydown', (event) => {
    const state = store.get();
    const { survey, cursor } = robustnessSlice.of(state);
    if (!survey || isChord(event)) return;
    const from = cursor ?? endsOf(state).start;
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      robustnessSlice.update(store, { cursor: from });
      driveFrom(from);
    } else if (event.key === 'Escape') robustnessSlice.update(store, { cursor: null });
    const step = arrowOf(event.key);
    if (!step) return;
    event.preventDefault();
    const cells = event.shiftKey ? 8 : 1;
    const { grid } = survey;
    const last = grid.x.count - 1;
    const [column, row] = placeOf(grid, from).map((index, i) =>
      Math.min(Math.max(index + cells * step[i], 0), last),
    );
    robustnessSlice.update(store, { cursor: startOf(grid, row * grid.x.count + column, 0) });
  });
}

/** The worst heading of a cell, or the one after that which is being watched there. @param {Survey} survey @param {number} cell @param {import('../../core/engine.js').Posture} watched */
function nextHeading({ grid, runs }, cell, watched) {
  const current = headingOf(grid, cell, watched);
  return current < 0 ? worstHeading(runs, cell) : (current + 1) % headings;
}

/** @param {Store} store */
function createControls(store) {
  const quantities = createSegmented(
    byId('robustness-quantity'),
    words.quantityLegend,
    words.quantities,
    (quantity) => robustnessSlice.update(store, { quantity }),
  );
  const choice = createSegmented(
    byId('robustness-headings'),
    words.headingLegend,
    words.headingChoices,
    (value) =>
      robustnessSlice.update(store, { heading: value === 'all' ? null : watchedHeading(store.get()) }),
  );
  /** @type {HTMLSelectElement} */
  const extent = byId('robustness-half');
  extent.replaceChildren(...halves.map((half) => new Option(words.extent(half), String(half))));
  extent.addEventListener('change', () =>
    robustnessSlice.update(store, { half: Number(extent.value), cursor: null }),
  );
  return {
    /** @param {RobustnessState} robustness */
    draw({ quantity, heading, half }) {
      quantities.draw(quantity);
      choice.draw(heading === null ? 'all' : 'one');
      extent.value = String(half);
    },
  };
}

/** @param {State} state */
const watchedHeading = (state) => headingNear(endsOf(state).start.theta);

function createTexts() {
  const [note, share, summary, rival, readout, sides] = [
    'note',
    'share',
    'summary',
    'rival',
    'readout',
    'sides',
  ].map((name) => byId(`robustness-${name}`));
  const surveyChanged = watch();
  const readoutChanged = watch();

  return {
    /** @param {State} state @param {Scene} scene @param {{ spec: Spec, rivalSpec: Spec }} specs */
    draw(state, scene, { spec, rivalSpec }) {
      const { survey, rival: other, message, heading, cursor } = robustnessSlice.of(state);
      const fresh = survey?.spec === spec;
      const generation = state.history.length - 1;
      if (surveyChanged(survey, fresh, other, rivalSpec, message, state.driver, state.found, generation)) {
        write(note, noteText(robustnessSlice.of(state), spec));
        note.classList.toggle('failed', message !== '');
        // Until there is a new one, the old number stands with its own name.
        if (survey && fresh) {
          write(share, words.percent(survey.tally.share));
          const name = lab.driverName(state.driver, generation, state.found);
          write(summary, words.summary(name));
          write(
            sides,
            words.sides(sharesBySide(survey.grid, survey.spec.experiment.goal, survey.tally.count)),
          );
        }
        const compared = lab.driverName(scene.comparisonDriver, generation, state.found);
        write(rival, words.rivalText(compared, other?.spec === rivalSpec ? other.tally.share : null));
      }
      if (readoutChanged(survey, heading, cursor, scene.driving, endsOf(state).start))
        write(readout, readoutText(state, scene));
    },
  };
}

/** @param {RobustnessState} robustness @param {Spec} spec */
function noteText({ survey, message }, spec) {
  const { linear, angular } = spec.experiment.referenceVelocity;
  if (message) return words.failed(message);
  if (survey?.spec !== spec) return words.computing;
  if (linear !== 0 || angular !== 0) return words.tracking;
  return words.startsText(survey.runs.arrived.length, survey.milliseconds);
}

/** What the cursor reads, or else the run that is watched. @param {State} state @param {Scene} scene */
function readoutText(state, scene) {
  const { survey, heading, cursor } = robustnessSlice.of(state);
  const { start } = endsOf(state);
  const { arrived, finalTime, cost } = scene.driving;
  const run = { heading: start.theta, arrived, finalTime, cost: cost.total };
  if (!survey) return '';
  const { grid, tally, runs } = survey;
  if (!cursor) {
    const counts = holds(grid, start) ? [words.there(tally.count[cellNear(grid, start)], headings)] : [];
    return [words.watched(start, run), ...counts].join(' ');
  }

  const cell = cellNear(grid, cursor);
  const place = startOf(grid, cell, 0);
  /** @param {number} index */
  const driveOf = (index) => {
    const at = cell * headings + index;
    return {
      heading: angleOf(index),
      arrived: runs.arrived[at] === 1,
      finalTime: runs.finalTime[at],
      cost: runs.cost[at],
    };
  };
  const current = headingOf(grid, cell, start);
  if (heading !== null)
    return `${words.driveText(place, driveOf(heading))} ${words.clickToWatch(current === heading)}`;
  const counts = words.cellText(place, {
    arrived: tally.count[cell],
    headings,
    time: tally.time[cell],
    cost: tally.cost[cell],
  });
  const next = nextHeading(survey, cell, start);
  return `${counts} ${
    current >= 0 ? words.watching(run, angleOf(next)) : words.invitation(angleOf(next), driveOf(next).arrived)
  }`;
}
