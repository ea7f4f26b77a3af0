// The part of the page that shows what error remains under a disturbance, against the sets of Theorem 2.
import { disturbanceSlice } from './state.js';
import { byId } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { disturbance as words } from '../../words/index.js';
import { createControls } from './controls.js';
import { createPlots } from './plots.js';
import { createRequests, createSpec } from './request.js';
import { summarize } from './summary.js';
import { createTable } from './table.js';

/** @typedef {import('../../run/scene.js').Scene} Scene */
/** @typedef {import('../../run/state.js').State} State */

/** @param {import('../part.js').Tools} parts @returns {import('../part.js').Page} */
export function createDisturbancePage(parts) {
  const { engine, store, paper } = parts;
  const specOf = createSpec(engine, paper);
  const requests = createRequests(engine, store);
  const controls = createControls(parts);
  const table = createTable();
  const plots = createPlots(table.plots, () => store.redraw());
  const summaryOf = remember(summarize);
  const noteChanged = watch();

  return {
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const { tried } = state;
      const { error, measured, message } = disturbanceSlice.of(state);
      const spec = specOf(state);
      requests.follow(spec);
      controls.draw(tried, error);
      if (noteChanged(tried, message, measured?.spec === spec)) {
        byId('disturbance-note').textContent = message ? words.failed(message) : words.kindText(tried);
        byId('disturbance').setAttribute('aria-busy', String(measured?.spec !== spec && !message));
      }
      byId('remains').classList.toggle('unmeasured', !measured);
      if (!measured) return;
      table.draw(summaryOf(measured));
      const time = Math.min(state.robot.time, scene.driving.finalTime);
      plots.draw({ measured, time, theme: state.theme });
    },
  };
}
