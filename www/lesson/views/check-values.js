// Five numbers with all their digits, by which one knows that a program is right; and the same program to take away.
import { html, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { download } from '../../kit/download.js';
import { createWaiting } from '../../lab/waiting.js';
import { tableOf } from './paper-table.js';

/** @import { Engine, PaperResult } from '../../core/engine.js' */
/** @import { Block, Tools } from '../page.js' */
/** @typedef {{ values: { label: string, heads: readonly string[], rows: readonly string[] }, downloads: { python: string, javascript: string, about: string } }} BuildWords */

/** From the core as it runs: v and ω that the law asks for at the start, t_f and J of the paper's gains, J of the arbitrary ones. @param {Pick<Engine, 'experiment' | 'samples' | 'drive'>} engine @param {PaperResult[]} paper */
export function checkValues(engine, paper) {
  const experiment = engine.experiment('velocity-limits');
  const [ep, arbitrary] = paper.map(({ gains }) => gains);
  const { command } = engine.samples(experiment, ep).at(0);
  const [best, other] = engine.drive(experiment, [ep, arbitrary]);
  return [command.linear, command.angular, best.finalTime, best.cost.total, other.cost.total];
}

/** @param {Tools} tools @param {BuildWords} words @returns {Block} */
export function createCheckValues({ engine }, { values: words }) {
  const values = checkValues(engine, engine.paper());
  const rows = words.rows.map((text, i) => [text, String(values[i]).replace('-', '−')]);
  const element = tableOf('lesson-table ruled check-values', words.heads, rows);
  element.id = 'check-values';
  element.setAttribute('aria-label', words.label);
  return { element, draw() {} };
}

const files = {
  'park.py': () => import('../files/park.py?raw'),
  'park.mjs': () => import('../files/park.mjs?raw'),
};

/** @param {Tools} _tools @param {BuildWords} words @returns {Block} */
export function createDownloads(_tools, { downloads: words }) {
  const element = create('div', 'downloads');
  const waiting = createWaiting();
  const save = async (/** @type {keyof typeof files} */ name) => {
    waiting.element.remove();
    try {
      const { default: text } = await files[name]();
      download(name, 'text/plain', text);
    } catch (error) {
      waiting.fail(error);
      element.append(waiting.element);
    }
  };
  render(
    html`<div class="bar"><button id="download-python" type="button" @click=${() => save('park.py')}>${words.python}</button>
      <button id="download-javascript" type="button" @click=${() => save('park.mjs')}>${words.javascript}</button></div>
      <p class="muted">${words.about}</p>`,
    element,
  );
  return { element, draw() {} };
}
