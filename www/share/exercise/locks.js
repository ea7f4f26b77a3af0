// A control, or a fieldset of them, is locked by the browser's own means; what is no form says so itself.

/** Those that would be disabled if they were not locked. @type {WeakMap<Element, boolean>} */
const otherwise = new WeakMap();

/** @param {Element} element @param {boolean} locked */
export function lock(element, locked) {
  if (element.hasAttribute('data-locked') === locked) return;
  element.toggleAttribute('data-locked', locked);
  if ('disabled' in element) {
    if (locked) otherwise.set(element, Boolean(element.disabled));
    element.disabled = locked || otherwise.get(element);
  } else if (locked) element.setAttribute('aria-disabled', 'true');
  else element.removeAttribute('aria-disabled');
  const others = (element.getAttribute('aria-describedby') ?? '').replace(/ ?exercise-locks$/, '');
  const described = locked ? `${others} exercise-locks`.trim() : others;
  if (described) element.setAttribute('aria-describedby', described);
  else element.removeAttribute('aria-describedby');
}

/** Its view has had a say in it: that holds when it is no longer locked. @param {Element} element */
export function lockAgain(element) {
  if (!('disabled' in element) || !element.hasAttribute('data-locked')) return;
  otherwise.set(element, Boolean(element.disabled));
  element.disabled = true;
}

/** A link cannot be disabled. @param {Event} event */
export function keepFromLinks(event) {
  if (!(event.target instanceof Element) || !event.target.closest('a[data-locked]')) return;
  event.preventDefault();
  event.stopPropagation();
}
