// The part of the page that shows what error remains under a disturbance, against the sets of Theorem 2.
/** @import { Page, Tools } from '../part.js' */
/** @typedef {import('../../core/engine.js').Experiment['disturbance']} Disturbance */
import './style.css';
import './places.css';
import { html, render } from 'lit-html';
import { createTeller } from '../../lab/announcer.js';
import { remember, watch } from '../../kit/memo.js';
import { tableButton } from '../../lab/table-sheet.js';
import words from './words/index.js';
import { createSection } from '../section.js';
import { createControls } from './controls.js';
import { createPlots } from './plots.js';
import { createRequests, createSpec } from './request.js';
import { disturbanceSlice } from './state.js';
import { hasAnother, summarize } from './summary.js';
import { remainsTable, tableOf } from './table.js';

/** What is added, or that the experiment adds something else. @param {Disturbance} tried @param {Disturbance} own */
const noteOf = (tried, own) => (hasAnother(own, tried) ? words.ownText(own) : words.kindText(tried));

/** @param {Tools} tools @returns {Page} */
export function createPage(tools) {
  const { engine, store, paper } = tools;
  const element = createSection('disturbance');
  const specOf = createSpec(engine, paper);
  const requests = createRequests(engine, store);
  const controlsOf = createControls(tools);
  const summaryOf = remember(summarize);
  const changed = watch();
  const tell = createTeller('disturbance');
  /** @type {ReturnType<typeof createPlots> | null} */
  let plots = null;

  return {
    element,
    retry: requests.retry,
    draw(state, scene) {
      const { tried, theme } = state;
      const { error, measured, message } = disturbanceSlice.of(state);
      const spec = specOf(state);
      const own = state.experiment.disturbance;
      requests.follow(spec);
      const isStale = measured?.spec !== spec && !message;
      if (changed(tried, own, error, message, measured, isStale)) {
        element.setAttribute('aria-busy', String(isStale));
        render(
          html`
            <div class="heading">
              <h2 id="disturbance-title">${words.texts.disturbanceTitle}</h2>
              ${tableButton('disturbance', measured, (shown) => remainsTable(summaryOf(shown)))}
              <p id="disturbance-note" class=${message ? 'field-error' : 'muted'}>${message ? words.failed(message, measured !== null) : noteOf(tried, own)}</p>
            </div>
            ${controlsOf(tried, error)} ${tableOf(measured && summaryOf(measured), !measured && message !== '')}`,
          element,
        );
      }
      tell(measured ? words.summaryText(summaryOf(measured)) : '', state.evolving);
      plots ??= createPlots(element, store.redraw);
      const time = Math.min(state.robot.time, scene.driving.finalTime);
      if (measured) plots.draw({ measured, time, theme });
    },
  };
}
