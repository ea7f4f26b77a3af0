// A list for a class: what to show or ask, each with the link that sets it up, and what is to be seen then.
import { html, nothing, render } from 'lit-html';
import { create } from '../kit/elements.js';
import { inline } from './prose.js';

/** @import { Block, Tools } from './page.js' */
/** @typedef {{ title: string, note?: string, items: Record<string, { text: string, seen?: string }> }} SheetWords */

/** @param {string} name of the sheet in the words @param {readonly (readonly [item: string, link: string | null])[]} items */
export const sheet = (name, items) => ({
  kind: /** @type {const} */ ('view'),
  items,
  /** @param {Tools} _tools @param {{ sheets: Record<string, SheetWords>, show: string, answer: string }} words @param {(link: string) => string} href @returns {Block} */
  create(_tools, words, href) {
    const { title, note, items: texts } = words.sheets[name];
    const muted = (/** @type {string} */ text) => html`<p class="muted">${inline(text, href)}</p>`;
    const rows = items.map(([item, link]) => {
      const { text, seen } = texts[item];
      const anchor =
        link !== null &&
        html`<a class="sheet-link" href=${href(link)} data-try=${`${name}-${item}`}>${words.show}</a>`;
      const answer =
        seen &&
        (link ? muted(seen) : html`<details><summary>${words.answer}</summary>${muted(seen)}</details>`);
      return html`<li><p>${inline(text, href)}</p>${anchor || nothing}${answer || nothing}</li>`;
    });
    const element = create('section', 'sheet-list');
    render(html`<h3>${title}</h3>${note ? muted(note) : nothing}<ol>${rows}</ol>`, element);
    return { element, draw() {} };
  },
});
