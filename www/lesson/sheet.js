// A list for a class: what to show, do or ask, each with the link that sets it up; and apart from it what is to be seen then.
import { html, nothing, render } from 'lit-html';
import { addressOf } from '../kit/host.js';
import { create } from '../kit/elements.js';
import { inline } from './prose.js';

/** @import { Block, Tools } from './page.js' */
/** @typedef {{ title: string, note?: string, items: Record<string, { text: string, seen?: string }> }} SheetWords */
/** @typedef {{ sheets: Record<string, SheetWords>, show: string, print: string, answersTo: (title: string) => string }} Words */
/** What of it: both together, or for students and for lecturers apart. @typedef {'all' | 'tasks' | 'answers'} Half */

/** Prints this sheet alone. @param {HTMLElement} sheet */
function printAlone(sheet) {
  const done = () => {
    delete document.body.dataset.print;
    sheet.classList.remove('to-print');
  };
  document.body.dataset.print = 'sheet';
  sheet.classList.add('to-print');
  addEventListener('afterprint', done, { once: true });
  print();
}

/** @param {string} name of the sheet in the words @param {readonly (readonly [item: string, link: string | null])[]} items @param {Half} [half] */
export const sheet = (name, items, half = 'all') => ({
  kind: /** @type {const} */ ('view'),
  name,
  items,
  half,
  /** @param {Tools} _tools @param {Words} words @param {(link: string) => string} href @returns {Block} */
  create(_tools, words, href) {
    const { title, note, items: texts } = words.sheets[name];
    const muted = (/** @type {string} */ text) => html`<p class="muted">${inline(text, href)}</p>`;
    const rows = items.map(([item, link]) => {
      const { text, seen } = texts[item];
      if (half === 'answers') return html`<li>${seen ? muted(seen) : nothing}</li>`;
      const anchor =
        link !== null &&
        html`<a class="sheet-link" href=${href(link)} data-try=${`${name}-${item}`}>${words.show}</a>
          <span class="address">${addressOf(location.href, href(link).slice(1), false)}</span>`;
      return html`<li><p>${inline(text, href)}</p>${anchor || nothing}${half === 'all' && seen ? muted(seen) : nothing}</li>`;
    });
    const element = create('section', 'sheet-list');
    render(
      html`<div class="sheet-list-head"><h3>${half === 'answers' ? words.answersTo(title) : title}</h3>
          <button type="button" class="link" @click=${() => printAlone(element)}>${words.print}</button></div>
        ${note && half !== 'answers' ? muted(note) : nothing}<ol>${rows}</ol>`,
      element,
    );
    return { element, draw() {} };
  },
});
