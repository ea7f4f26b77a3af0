// A list for a class: what to show or ask, each with the link that sets it up, and what is to be seen then.
import { create } from '../kit/elements.js';
import { inline } from './prose.js';

/** @typedef {import('./page.js').Block} Block */
/** @typedef {{ title: string, note?: string, items: Record<string, { text: string, seen?: string }> }} SheetWords */

/** @param {string} name of the sheet in the words @param {readonly (readonly [item: string, link: string | null])[]} items */
export const sheet = (name, items) => ({
  kind: /** @type {const} */ ('view'),
  items,
  /** @param {import('./page.js').Tools} _tools @param {{ sheets: Record<string, SheetWords>, show: string, answer: string }} words @param {(link: string) => string} href @returns {Block} */
  create(_tools, words, href) {
    const { title, note, items: texts } = words.sheets[name];
    const rows = items.map(([item, link]) => {
      const { text, seen } = texts[item];
      const row = create('li', '', create('p', '', ...inline(text, href)));
      if (link !== null) {
        const anchor = Object.assign(create('a', 'sheet-link', words.show), { href: href(link) });
        anchor.dataset.try = `${name}-${item}`;
        row.append(anchor);
      }
      if (seen)
        row.append(
          link === null
            ? create(
                'details',
                '',
                create('summary', '', words.answer),
                create('p', 'muted', ...inline(seen, href)),
              )
            : create('p', 'muted', ...inline(seen, href)),
        );
      return row;
    });
    const element = create('section', 'sheet-list', create('h3', '', title));
    if (note) element.append(create('p', 'muted', ...inline(note, href)));
    element.append(create('ol', '', ...rows));
    return { element, draw() {} };
  },
});
