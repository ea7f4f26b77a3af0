// Formulas that know the running numbers: the same formula once with its symbols and, when asked, with what they are now.
import { create, write } from '../../kit/elements.js';
import { arrowOf, isChord } from '../../kit/keyboard.js';
import words from '../words/index.js';
import { isFirst, lineOf, withDots } from './notation.js';
import { isSymbol, mathml, symbol } from './symbols.js';

/** @import { Formula, Leaf } from './notation.js' */
/** @import { Block } from '../page.js' */

/** One stop of the keyboard; in it the arrow keys go from term to term, which also scrolls what is too long for a small screen. @param {string} className @param {readonly string[]} lines @param {Leaf} leaf */
function scroller(className, lines, leaf) {
  const math = mathml('math', mathml('mtable', ...lines.map((text) => lineOf(text, leaf))));
  math.setAttribute('display', 'block');
  const all = [.../** @type {NodeListOf<MathMLElement>} */ (math.querySelectorAll('[data-term]'))];
  // The symbols of a term light up with it.
  const terms = all.filter((one) => !one.parentElement?.closest('[data-term]'));
  for (const term of terms) term.setAttribute('tabindex', '-1');
  const attributes = { class: className, tabindex: 0, role: 'group', 'aria-label': words.formula };
  const element = create('div', attributes, math);
  element.addEventListener('keydown', (event) => {
    const [right] = arrowOf(event.key) ?? [0];
    const next = terms[terms.findIndex((term) => term.matches(':focus')) + right];
    if (right === 0 || isChord(event) || !next) return;
    event.preventDefault();
    // A term has its name; a symbol is called by its letters, or by the number in its place.
    if (next.getAttribute('role') !== 'group') {
      next.setAttribute('role', 'math');
      next.setAttribute('aria-label', next.textContent ?? '');
    }
    next.focus();
  });
  element.addEventListener('focusin', ({ target }) => {
    element.tabIndex = target === element ? 0 : -1;
  });
  element.addEventListener('focusout', () => {
    element.tabIndex = 0;
  });
  return element;
}

/** @param {Formula} formula @returns {Block} */
export function createFormula({ label, lines, filled = lines, numbers }) {
  const shown = scroller('formula-lines', lines, symbol);
  shown.querySelector('mtable')?.setAttribute('displaystyle', 'true');
  const element = create('div', 'formula', shown, create('span', 'formula-number', label));
  if (!numbers) return { element, draw() {} };

  /** @type {Map<string, Element[]>} */
  const leaves = new Map();
  const leafOf = (/** @type {string} */ term) => {
    const leaf = mathml('mn', '–');
    leaf.setAttribute('data-term', term);
    leaf.setAttribute('class', `live ${(isSymbol(term) && symbol(term).getAttribute('class')) || ''}`);
    leaves.set(term, [...(leaves.get(term) ?? []), leaf]);
    return leaf;
  };
  const now = scroller('formula-lines formula-now', filled, leafOf);
  withDots(now);
  now.hidden = true;
  const attributes = { class: 'link formula-button', type: 'button', 'aria-expanded': 'false' };
  const button = create('button', attributes, words.showNumbers);
  let isOpen = false;
  let isKnown = true;
  const show = () => {
    button.hidden = !isKnown;
    now.hidden = !isKnown || !isOpen;
  };
  button.addEventListener('click', () => {
    isOpen = !isOpen;
    button.setAttribute('aria-expanded', String(isOpen));
    button.textContent = isOpen ? words.hideNumbers : words.showNumbers;
    show();
  });
  element.append(now, button);
  return {
    element,
    draw(live) {
      const known = numbers(live);
      // Without a birth there is nothing to fill in.
      isKnown = Object.keys(known).length > 0;
      show();
      for (const [term, all] of leaves) {
        const text = known[term] ?? '–';
        for (const leaf of all) write(leaf, text.startsWith('−') && !isFirst(leaf) ? `(${text})` : text);
      }
    },
  };
}
