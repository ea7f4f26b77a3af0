// One symbol, everywhere: who points at a term, or comes to it by keyboard, sees it in formulas, picture and sliders.

/** @param {EventTarget | null} target */
const termOf = (target) =>
  target instanceof Element
    ? (target.closest('[data-term]')?.getAttribute('data-term')?.split(' ')[0] ?? '')
    : '';

export function createLit() {
  let lit = '';
  const light = (/** @type {string} */ term) => {
    if (term === lit) return;
    for (const element of document.querySelectorAll('.lit')) element.classList.remove('lit');
    if (term)
      for (const element of document.querySelectorAll(`[data-term~="${term}"]`)) element.classList.add('lit');
    lit = term;
    document.body.toggleAttribute('data-lit', term !== '');
  };
  for (const kind of ['pointerover', 'focusin'])
    document.addEventListener(kind, (event) => light(termOf(event.target)));
  for (const kind of ['pointerleave', 'focusout']) document.addEventListener(kind, () => light(''));
}
