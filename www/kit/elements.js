/** @template {HTMLElement} [T=HTMLElement] @param {string} id @returns {T} */
export const byId = (id) => /** @type {T} */ (document.getElementById(id));

/** A new element with what it holds. @param {string} tag @param {string} className @param {(Node | string)[]} children */
export function create(tag, className, ...children) {
  const element = document.createElement(tag);
  if (className) element.className = className;
  element.append(...children);
  return element;
}

/** A formula, every second piece of which is a subscript. @param {readonly string[]} pieces */
export const formula = (pieces) => pieces.map((piece, i) => (i % 2 ? create('sub', '', piece) : piece));

/** The size of an element in pixels, kept up to date. @param {HTMLElement} element @param {() => void} onResize */
export function followSize(element, onResize) {
  let size = { width: 0, height: 0 };
  new ResizeObserver(() => {
    size = { width: element.clientWidth, height: element.clientHeight };
    onResize();
  }).observe(element);
  return () => size;
}
