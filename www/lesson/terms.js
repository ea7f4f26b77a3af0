// One symbol, everywhere: who points at a term, or comes to it by keyboard, sees it in formulas, picture and sliders.
import { canScroll } from '../kit/finger.js';

/** @param {Element | null} element */
const termOf = (element) => element?.getAttribute('data-term')?.split(' ')[0] ?? '';

/** Everything of a term, and in the picture the symbols that the term is made of. @param {EventTarget | null} target @returns {string[]} Selectors. */
function meant(target) {
  const host = target instanceof Element ? target.closest('[data-term]') : null;
  if (!host) return [];
  const symbols = new Set([...host.querySelectorAll('[data-term]')].map(termOf));
  return [
    `[data-term~="${termOf(host)}"]`,
    ...[...symbols].map((symbol) => `#error-posture [data-term~="${symbol}"]`),
  ];
}

export function createLit() {
  let lit = '';
  const light = (/** @type {string[]} */ selectors) => {
    const selector = selectors.join();
    if (selector === lit) return;
    for (const element of document.querySelectorAll('.lit')) element.classList.remove('lit');
    if (selector) for (const element of document.querySelectorAll(selector)) element.classList.add('lit');
    lit = selector;
  };
  for (const kind of ['pointerover', 'focusin'])
    document.addEventListener(kind, (event) => light(meant(event.target)));
  document.addEventListener('focusout', () => light([]));
  // A finger that was lifted lets one see what it lay on, until it comes down elsewhere.
  document.addEventListener('pointerleave', (event) => canScroll(event) || light([]));
}
