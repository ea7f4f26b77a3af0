// The attributes of the element, which are its properties too, and the one that others have for it.

export const attributes = ['link', 'src', 'height', 'label'];

/** @param {HTMLElement} prototype */
export function reflect(prototype) {
  for (const name of attributes)
    Object.defineProperty(prototype, name, {
      get() {
        return this.getAttribute(name) ?? '';
      },
      // A framework sets null or undefined where nothing is given.
      set(value) {
        if (value === null || value === undefined) this.removeAttribute(name);
        else this.setAttribute(name, value);
      },
    });
}

/** The language in which it stands, also around a shadow tree. @param {Element} element @returns {string} */
export function languageAround(element) {
  const around = element.getRootNode();
  const own = element.closest('[lang]')?.getAttribute('lang');
  return own ?? (around instanceof ShadowRoot ? languageAround(around.host) : '');
}
