// A list for a class: what to show, do or ask, each with the link that sets it up; and apart from it what is to be seen then.
import { html, nothing, render } from 'lit-html';
import { addressOf, isEmbedded } from '../kit/host.js';
import { create } from '../kit/elements.js';
import { hrefOf } from './path.js';
import { inline } from './prose.js';

/** @import { Block, Tools } from './page.js' */
/** @typedef {{ title: string, note?: string, apart?: string, items: Record<string, { text: string, seen?: string }> }} SheetWords */
/** @typedef {{ sheets: Record<string, SheetWords>, show: string, showApart: string, print: string, answersTo: (title: string) => string }} Words */
/** What of it: both together, or for students and for lecturers apart. @typedef {'all' | 'tasks' | 'answers'} Half */

/** Of the window for all that is shown to a class, while the notes stay here. */
const shownWindow = 'ep-shown';

/** What it shows without these notes: for students no address leads to the answers. @param {string} link */
const addressOfItem = (link) => addressOf(location.href, hrefOf(link, 0).slice(1), false);

/** Opens an item there; a frame need not be allowed to open any. @param {string} link @param {string} text */
function apartLink(link, text) {
  if (isEmbedded) return nothing;
  // A whole address, for what begins with # the lesson opens within this page.
  return html`<a class="sheet-apart" href=${addressOfItem(link)} target=${shownWindow}>${text}</a>`;
}

/** Prints this sheet alone. @param {HTMLElement} sheet */
function printAlone(sheet) {
  const done = () => {
    delete document.body.dataset.print;
    sheet.classList.remove('to-print');
  };
  // Where nothing could be printed, no end came of it.
  for (const other of document.querySelectorAll('.to-print')) other.classList.remove('to-print');
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
    const { title, note, apart, items: texts } = words.sheets[name];
    const muted = (/** @type {string} */ text) => html`<p class="muted">${inline(text, href)}</p>`;
    const rows = items.map(([item, link]) => {
      const { text, seen } = texts[item];
      if (half === 'answers') return html`<li>${seen ? muted(seen) : nothing}</li>`;
      const anchor =
        link !== null &&
        html`<a class="sheet-link" href=${href(link)} data-try=${`${name}-${item}`}>${words.show}</a>
          ${apartLink(link, words.showApart)}
          <a class="address" href=${addressOfItem(link)}>${words.show}: ${addressOfItem(link)}</a>`;
      return html`<li><p>${inline(text, href)}</p>${anchor || nothing}${half === 'all' && seen ? muted(seen) : nothing}</li>`;
    });
    const element = create('section', 'sheet-list');
    render(
      html`<div class="sheet-list-head row"><h3>${half === 'answers' ? words.answersTo(title) : title}</h3>
          <button type="button" class="link" @click=${() => printAlone(element)}>${words.print}</button></div>
        ${note && half !== 'answers' ? muted(note) : nothing}
        ${apart && !isEmbedded ? html`<div class="sheet-apart">${muted(apart)}</div>` : nothing}<ol>${rows}</ol>`,
      element,
    );
    return { element, draw() {} };
  },
});
