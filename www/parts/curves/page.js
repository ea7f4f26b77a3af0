// The part of the page that shows runs against time and beside each other.
import { curvesSlice } from './state.js';
import { byId, followSize } from '../../kit/elements.js';
import { sampleBefore } from '../../lab/track.js';
import { createSegmented } from '../../kit/segmented.js';
import { createStability } from './stability/view.js';
import { remember, watch } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { curves as words, lab } from '../../words/index.js';
import { followPointer } from '../../kit/chart.js';
import { sampleTime } from './axes.js';
import { createComparison } from './compare.js';
import { createNumbers } from './numbers.js';
import { paidUntil } from '../../core/paid.js';
import { createPlots } from './plots.js';

/** @typedef {import('../../core/engine.js').Run} Run */
/** @typedef {import('../part.js').Tools} PageParts */
/** @typedef {import('../part.js').Page} Page */
/** @typedef {import('../../run/pins.js').Driven} Driven */
/** @typedef {import('../../run/scene.js').Scene} Scene */
/** @typedef {import('../../run/state.js').State} State */
/** @param {PageParts} parts @returns {Page} */
export function createCurvesPage(parts) {
  const { store, actions, paper } = parts;
  const lines = /** @type {HTMLCanvasElement} */ (byId('curves-lines'));
  const plots = createPlots({
    lines,
    cursor: /** @type {HTMLCanvasElement} */ (byId('curves-cursor')),
  });
  const readout = createReadout(byId('curves-readout'));
  const numbers = createNumbers(/** @type {HTMLTableElement} */ (byId('numbers-table')));
  const comparison = createComparison(parts);
  const stability = createStability(parts);
  const choice = createSegmented(byId('curves-view'), words.viewLegend, words.views, (view) =>
    curvesSlice.update(store, { view }),
  );
  const size = followSize(byId('curves-picture'), () => store.redraw());
  /** @type {Run | null} */
  let driving = null;
  followPointer(byId('curves-picture'), (px) => {
    if (driving) actions.scrub(sampleTime(driving, plots.timeAt(px)));
  });

  /** Whether nothing that drives differs from the paper's experiment. */
  const isPapers = remember(
    (/** @type {State['experiment']} */ own, /** @type {State['preset']} */ preset) => {
      const text = (/** @type {State['experiment']} */ { evolution, ...rest }) => JSON.stringify(rest);
      return text(own) === text(parts.engine.experiment(preset));
    },
  );
  const textsChanged = watch();
  /** @param {State} state @param {Scene} scene */
  const drawTexts = (state, scene) => {
    if (
      !textsChanged(scene.driving, scene.comparison, scene.pins, state.driver, state.found, state.generation)
    )
      return;
    const described = (/** @type {string} */ name, /** @type {Run} */ run) =>
      `${lab.comparisonText(name, run)}, ${lab.outcomeText(run)}`;
    lines.setAttribute(
      'aria-label',
      words.pictureLabel(
        lab.driverName(state.driver, state.generation, state.found),
        scene.driving,
        lab.outcomeText(scene.driving),
        described(
          scene.withoutDisturbance
            ? lab.withoutDisturbance
            : lab.driverName(scene.comparisonDriver, state.generation, state.found),
          scene.comparison,
        ),
        state.pins.map(({ name }, i) => described(name, scene.pins[i])),
      ),
    );
    const isPaper = state.driver === 'paper-ep' && isPapers(state.experiment, state.preset);
    byId('curves-note').textContent = isPaper
      ? words.figureNote(state.preset === 'velocity-limits' ? '5' : '7')
      : '';
  };

  return {
    draw(state, scene) {
      driving = scene.driving;
      const { view } = curvesSlice.of(state);
      const time = Math.min(state.robot.time, driving.finalTime);
      const name = lab.driverName(state.driver, state.generation, state.found);
      choice.draw(view);
      byId('curves-over-time').hidden = view !== 'time';
      byId('curves-stability').hidden = view !== 'stability';
      byId('curves-compare').hidden = view !== 'compare';
      byId('curves-numbers').hidden = view !== 'numbers';
      // What a gain does to V̇ is seen while it is moved.
      byId('gains').hidden = view !== 'stability';
      if (view === 'stability') stability.draw(state, scene, { name, time });
      if (view === 'compare')
        comparison.draw(state, { name, gains: gainsOf(state, state.driver, paper), scene });
      if (view === 'numbers') numbers.draw({ name, run: driving, time });
      if (view !== 'time') return;
      drawTexts(state, scene);
      readout.draw(driving, time);
      plots.draw({
        driving,
        comparison: scene.comparison,
        pins: state.pins,
        pinned: scene.pins,
        limits: scene.experiment.limits,
        time,
        size: size(),
        theme: state.theme,
      });
    },
  };
}

/** The values at the cursor, each in a place of its own. @param {HTMLElement} list */
function createReadout(list) {
  const items = words.readings.map(({ id, symbol, className, unit, text }) => {
    const item = document.createElement('div');
    const name = document.createElement('dt');
    const description = document.createElement('dd');
    const value = document.createElement('span');
    name.textContent = symbol;
    name.className = className;
    Object.assign(value, { id: `reading-${id}`, className: 'value' });
    description.append(value, unit);
    item.append(name, description);
    return { item, value, text };
  });
  list.replaceChildren(...items.map(({ item }) => item));
  const changed = watch();
  return {
    /** @param {Run} run @param {number} time */
    draw(run, time) {
      const i = sampleBefore(run, time);
      if (!changed(run, i)) return;
      for (const { value, text } of items) value.textContent = text(run, i, paidUntil(run, i));
    },
  };
}
