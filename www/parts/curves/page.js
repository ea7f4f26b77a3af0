// The part of the page that shows runs against time and beside each other.
/** @import { Scene } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Page, Tools } from '../part.js' */
/** @import { CurvesView } from './state.js' */
import './style.css';
import './places.css';
import './stability/style.css';
import { html, render } from 'lit-html';
import { listed } from '../../kit/segmented.js';
import { segmentedOf } from '../../kit/fields.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { createSection } from '../section.js';
import { createComparison } from './compare.js';
import { createNumbers } from './numbers.js';
import { createOverTime } from './over-time.js';
import { createStability } from './stability/view.js';
import { curvesSlice } from './state.js';

/** What is said of the run on screen, and the robots' clock within it. @typedef {{ name: string, time: number }} Shown */
/** @typedef {{ draw: (state: State, scene: Scene, shown: Shown) => void }} View */

/** @param {Tools} tools @returns {Page} */
export function createPage(tools) {
  const { store } = tools;
  const element = createSection('curves', 'curves-section');
  const choose = (/** @type {CurvesView} */ view) => curvesSlice.update(store, { view });
  const show = (/** @type {CurvesView} */ view) =>
    render(
      html`
        <div class="heading">
          <h2 id="curves-title">${words.texts.curvesTitle}</h2>
          ${segmentedOf('curves-view', words.viewLegend, listed(words.views), view, choose, 'small')}
        </div>
        <div id="curves-over-time" class="curves-over-time column" .hidden=${view !== 'time'}></div>
        <div id="curves-stability" class="stability column" .hidden=${view !== 'stability'}></div>
        <div id="curves-compare" class="curves-compare column" .hidden=${view !== 'compare'}></div>
        <div id="curves-numbers" class="curves-scroll" tabindex="0" role="group"
          aria-label=${words.texts.numbersTable} .hidden=${view !== 'numbers'}></div>`,
      element,
    );
  show(curvesSlice.of(store.get()).view);
  const [time, stability, compare, numbers] = /** @type {HTMLElement[]} */ ([...element.children].slice(1));
  /** @type {Record<CurvesView, View>} */
  const views = {
    time: createOverTime(time, tools),
    stability: createStability(stability, tools),
    compare: createComparison(compare, tools),
    numbers: createNumbers(numbers),
  };

  return {
    element,
    draw(state, scene) {
      const { view } = curvesSlice.of(state);
      show(view);
      views[view].draw(state, scene, {
        name: lab.driverName(state.driver, state.generation, state.found),
        time: Math.min(state.robot.time, scene.driving.finalTime),
      });
    },
  };
}
