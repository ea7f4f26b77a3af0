// The Lyapunov function of the run on screen: V, what the law promises of its rate, and what the robot makes of that.
import { curvesSlice } from '../state.js';
import { followPointer } from '../../../kit/chart.js';
import { sampleTime } from '../axes.js';
import { byId, create, followSize, formula, write } from '../../../kit/elements.js';
import { sampleBefore } from '../../../lab/track.js';
import { remember, watch } from '../../../kit/memo.js';
import { offerTable } from '../../../kit/table.js';
import { stability as words } from '../../../words/index.js';
import { createPlots } from './plots.js';
import { summaryOf } from './summary.js';
import { stabilityTable } from './table.js';

/** @typedef {import('../../../core/engine.js').Experiment} Experiment */
/** @typedef {import('../../../core/engine.js').Stability} Stability */
/** @typedef {import('../../part.js').Tools} PageParts */
/** @typedef {import('../../../run/pins.js').Pins} Pins */
/** @typedef {import('../../../run/scene.js').Scene} Scene */
/** @typedef {import('../../../run/state.js').State} State */
/** @typedef {import('../../../core/engine.js').Triple} Triple */

/** @param {Pick<PageParts, 'engine' | 'store' | 'actions'>} parts */
export function createStability({ engine, store, actions }) {
  /** @type {HTMLCanvasElement} */
  const lines = byId('stability-lines');
  const plots = createPlots({ lines, cursor: byId('stability-cursor') });
  const readout = createReadout(byId('stability-readout'));
  const note = byId('stability-note');
  const picture = byId('stability-picture');
  /** @type {HTMLInputElement} */
  const log = byId('stability-log');
  const size = followSize(picture, () => store.redraw());
  log.addEventListener('change', () => curvesSlice.update(store, { scale: log.checked ? 'log' : 'linear' }));

  const stabilityOne = () =>
    remember((/** @type {Experiment} */ experiment, /** @type {Triple} */ gains) =>
      engine.stability(experiment, gains),
    );
  const [drivingOf, comparisonOf] = [stabilityOne(), stabilityOne()];
  const pinnedOf = remember((/** @type {Pins} */ pins) =>
    pins.map(({ experiment, gains }) => engine.stability(experiment, gains)),
  );

  /** @type {{ name: string, driving: Stability } | null} */
  let shown = null;
  followPointer(picture, (px) => {
    if (shown) actions.scrub(sampleTime(shown.driving, plots.timeAt(px)));
  });
  offerTable('stability-table', () => shown && stabilityTable(shown.name, shown.driving));

  const textsChanged = watch();
  return {
    /** @param {State} state @param {Scene} scene @param {{ name: string, time: number }} of */
    draw(state, { experiment, gains, compared }, { name, time }) {
      const { pins, theme } = state;
      const isLog = curvesSlice.of(state).scale === 'log';
      const driving = drivingOf(experiment, gains);
      shown = { name, driving };
      log.checked = isLog;
      if (textsChanged(driving, name)) {
        const summary = summaryOf(driving, experiment, gains);
        write(note, words.noteText(summary));
        lines.setAttribute('aria-label', words.pictureLabel(name, summary));
      }
      readout.draw(driving, experiment.law, time);
      plots.draw({
        driving,
        law: experiment.law,
        comparison: comparisonOf(compared.experiment, compared.gains),
        pins,
        pinned: pinnedOf(pins),
        isLog,
        time,
        size: size(),
        theme,
      });
    },
  };
}

/** @type {readonly (readonly [id: keyof typeof words.terms.kanayama, read: (run: Stability, i: number) => number])[]} */
const readings = [
  ['lyapunov', (run, i) => run.lyapunov[i]],
  ['rate', (run, i) => run.rate[i]],
  ['promised', (run, i) => run.promisedX[i] + run.promisedY[i] + run.promisedTheta[i]],
  ['x', (run, i) => run.promisedX[i]],
  ['y', (run, i) => run.promisedY[i]],
  ['theta', (run, i) => run.promisedTheta[i]],
];

/** The values at the cursor, those of the law as the equation that they are. @param {HTMLElement} list */
function createReadout(list) {
  const items = readings.map(([id, read]) => {
    const term = create('dt', '');
    const value = create('dd', '');
    value.id = `stability-${id}`;
    return { id, read, term, value, item: create('div', id, term, value) };
  });
  list.replaceChildren(...items.map(({ item }) => item));
  const lawChanged = watch();
  const changed = watch();
  return {
    /** @param {Stability} run @param {Experiment['law']} law @param {number} time */
    draw(run, law, time) {
      if (lawChanged(law))
        for (const { id, term } of items) term.replaceChildren(...formula(words.terms[law][id]));
      const i = sampleBefore(run, time);
      if (!changed(run, i)) return;
      const [lyapunov, ...rates] = items.map(({ read }) => read(run, i));
      const texts = [words.amount(lyapunov), ...words.amounts(rates)];
      for (const [n, { value }] of items.entries()) value.textContent = texts[n];
    },
  };
}
