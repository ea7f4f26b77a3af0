// The part of the page that runs evolution with many seeds, in two views: how much of a result is luck?
/** @import { Page, Tools } from '../part.js' */
/** @import { LuckState } from './state.js' */
import './style.css';
import './contest.css';
import './places.css';
import { html, render } from 'lit-html';
import { listed } from '../../kit/segmented.js';
import { luckSlice } from './state.js';
import { segmentedOf } from '../../kit/fields.js';
import { createSection } from '../section.js';
import words from './words/index.js';
import { createContest } from './contest-page.js';
import { createSeeds } from './seeds-page.js';

/** @param {Tools} tools @returns {Page} */
export function createPage(tools) {
  const { store } = tools;
  const section = createSection('luck');
  const showView = (/** @type {LuckState['view']} */ view) =>
    render(
      html`${segmentedOf('luck-view', words.viewLegend, listed(words.views), view, (chosen) => luckSlice.update(store, { view: chosen }), 'small not-in-figure not-in-sight')}
        <div class="luck-sight" .hidden=${view !== 'seeds'}></div>
        <div class="luck-sight" .hidden=${view !== 'contest'}></div>`,
      section,
    );
  showView(luckSlice.of(store.get()).view);
  const [seedsElement, contestElement] = /** @type {HTMLElement[]} */ ([...section.children].slice(1));
  const views = { contest: createContest(contestElement, tools), seeds: createSeeds(seedsElement, tools) };

  return {
    element: section,
    draw(state) {
      const { view } = luckSlice.of(state);
      showView(view);
      views[view].draw(state);
    },
  };
}
