// The part of the page that shows from where one set of gains arrives, and what its controls do.
/** @import { Run } from '../../core/engine.js' */
/** @import { Page, Tools } from '../part.js' */
/** @import { Actions } from '../../run/actions/actions.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Quantity, Survey } from './request.js' */
/** @import { Shading } from './scale.js' */
/** @import { RobustnessState } from './state.js' */
/** @import { MapModel } from './view.js' */
import '../map.css';
import './style.css';
import './places.css';
import { robustnessSlice } from './state.js';
import { byIdIn } from '../../kit/elements.js';
import { followSize } from '../../kit/size.js';
import { createSection } from '../section.js';
import { followKeys, followPointing, pointIn } from '../../kit/map.js';
import { once, remember } from '../../kit/memo.js';
import { endsOf } from '../../run/state.js';
import { areShown, createDrives } from './drives.js';
import { angleOf, cellNear, gridAround, headings, nextHeading, placeOf, startOf } from './grid.js';
import { createSight } from './sight.js';
import { createLegend } from './legend.js';
import { createSpec, createSurveyRequests } from './request.js';
import { createRose } from './rose.js';
import { createShading, readingOf } from './scale.js';
import { axesOf, createMap } from './view.js';

/** @param {Tools} parts @returns {Page} */
export function createPage({ engine, store, actions, paper }) {
  const element = createSection('robustness');
  const specOf = createSpec(paper);
  const rivalSpecOf = createSpec(paper);
  const requests = createSurveyRequests(engine, store);
  const show = createSight(element, store);
  const shadingOf = remember(createShading);
  const emptyGrid = remember(gridAround);
  const partsOf = remember(partsOfRose);
  const drivesOf = createDrives(engine, store.redraw);
  const angle = remember((/** @type {number | null} */ heading) =>
    heading === null ? null : angleOf(heading),
  );
  const views = once(() => createViews(element, store, actions));

  return {
    element,
    retry: requests.retry,
    draw(state, scene) {
      const { survey, heading, quantity, half, cursor, lit } = robustnessSlice.of(state);
      const spec = specOf(state, state.driver);
      const rivalSpec = rivalSpecOf(state, scene.comparisonDriver);
      requests.follow(spec, rivalSpec, state.dragging);
      show(state, scene, spec, rivalSpec);

      const { map, legend, rose, size } = views();
      const watched = endsOf(state).start;
      const grid = survey?.grid ?? emptyGrid(state.experiment.goal, half, 2);
      const shading = survey && shadingOf(survey, quantity, heading);
      const cell = cellNear(grid, cursor ?? watched);
      const isPointed = survey !== null && (cursor !== null || lit !== null);
      const nextOf = () => (isPointed ? (heading ?? nextHeading(survey, cell, watched)) : null);
      const shown = lit ?? nextOf();
      map.draw({
        grid,
        shading,
        heading: angle(heading),
        goal: survey?.spec.experiment.goal ?? state.experiment.goal,
        starts: state.experiment.starts,
        watched,
        run: scene.driving,
        cell: cursor && cell,
        drives: isPointed && areShown(survey.spec.experiment) ? drivesOf(survey.spec, grid, cell) : noDrives,
        lit: shown,
        size: size(),
        theme: state.theme,
      });
      if (shading) legend.draw({ shading, quantity, heading, theme: state.theme });
      const parts = survey && shading ? partsOf(survey, shading, quantity, cell) : noParts;
      rose.draw({ heading, lit: shown, parts });
    },
  };
}

/** What is drawn by hand, where the templates have made room for it. @param {HTMLElement} element @param {Tools['store']} store @param {Tools['actions']} actions */
function createViews(element, store, actions) {
  const root = byIdIn(element, 'robustness-map');
  const size = followSize(root, store.redraw);
  followCursor(root, store, actions, size);
  const { now, update } = robustnessSlice.at(store);
  return {
    size,
    map: createMap(root),
    legend: createLegend(byIdIn(element, 'robustness-legend')),
    rose: createRose(byIdIn(element, 'robustness-rose'), {
      chosen: () => now().heading,
      onChoose: (heading) => update({ heading }),
      onPoint: (lit) => update({ lit }),
    }),
  };
}

/** @type {(number | null)[]} */
const noParts = Array(headings).fill(null);
/** @type {Run[]} */
const noDrives = [];

/** Of each heading of a cell the part of the scale. @param {Survey} survey @param {Shading} shading @param {Quantity} quantity @param {number} cell */
function partsOfRose(survey, shading, quantity, cell) {
  return noParts.map((_, heading) => {
    const value = readingOf(survey, quantity, heading)(cell);
    return Number.isNaN(value) ? null : shading.part(value);
  });
}

/** A cursor for pointer and keys, and the drives from where it is. @param {HTMLElement} element @param {Store} store @param {Actions} actions @param {() => MapModel['size']} size */
function followCursor(element, store, actions, size) {
  const { now: own, update } = robustnessSlice.at(store);
  const put = (/** @type {RobustnessState['cursor']} */ cursor) => update({ cursor });
  const watched = () => endsOf(store.get()).start;
  /** @param {MouseEvent} event */
  const at = (event) => {
    const { survey } = own();
    if (!survey) return null;
    const { frame, x, y } = axesOf({ grid: survey.grid, size: size() });
    const [px, py] = pointIn(element, event);
    const inside = px >= frame.left && px <= frame.right && py >= frame.top && py <= frame.bottom;
    return inside ? { x: x.invert(px), y: y.invert(py) } : null;
  };
  /** @param {RobustnessState['cursor']} point */
  const driveFrom = (point) => {
    const { survey, heading } = own();
    put(point);
    if (!survey || !point) return;
    const cell = cellNear(survey.grid, point);
    actions.tryStart(startOf(survey.grid, cell, heading ?? nextHeading(survey, cell, watched())));
  };
  element.addEventListener('click', (event) => driveFrom(at(event)));
  followPointing(element, (event) => put(event && at(event)));
  // A finger rests on a cell before it is lifted, and then the robot drives.
  for (const kind of /** @type {const} */ (['pointerdown', 'pointermove']))
    element.addEventListener(kind, (event) => {
      if (event.pointerType === 'touch') put(at(event));
    });
  followKeys(element, {
    onEnter: () => driveFrom(own().cursor ?? watched()),
    onEscape() {
      if (own().cursor === null) return false;
      put(null);
      return true;
    },
    onStep(step, isWide) {
      const { survey, cursor } = own();
      if (!survey) return;
      const { grid } = survey;
      const last = grid.x.count - 1;
      const [column, row] = placeOf(grid, cursor ?? watched()).map((index, i) =>
        Math.min(Math.max(index + (isWide ? 8 : 1) * step[i], 0), last),
      );
      put(startOf(grid, row * grid.x.count + column, 0));
    },
  });
}
