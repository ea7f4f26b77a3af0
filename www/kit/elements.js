/** @template {HTMLElement} [T=HTMLElement] @param {string} id @returns {T} */
export const byId = (id) => /** @type {T} */ (document.getElementById(id));

/** As byId(), of what stands in no page yet. @template {HTMLElement} [T=HTMLElement] @param {ParentNode} root @param {string} id @returns {T} */
export const byIdIn = (root, id) => /** @type {T} */ (root.querySelector(`#${id}`));

/** @typedef {Record<string, string | number>} Attributes */

/** A new element with what it holds. @param {string} tag @param {string | Attributes} given its class, or all attributes that it has @param {(Node | string)[]} children */
export function create(tag, given, ...children) {
  const attributes = typeof given === 'object' ? given : given && { class: given };
  return fill(document.createElement(tag), attributes || {}, children);
}

/** A new element of a picture. @param {string} tag @param {Attributes} attributes @param {(Node | string)[]} children */
export function svg(tag, attributes, ...children) {
  const element = /** @type {SVGElement} */ (document.createElementNS('http://www.w3.org/2000/svg', tag));
  return fill(element, attributes, children);
}

/** @template {Element} E @param {E} element @param {Attributes} attributes @param {(Node | string)[]} children */
function fill(element, attributes, children = []) {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}

/** What a slider that is no input says where it is not seen. @param {Element} element @param {number} min @param {number} max @param {number} now @param {string} text */
export const tellValue = (element, min, max, now, text) =>
  fill(element, { 'aria-valuemin': min, 'aria-valuemax': max, 'aria-valuenow': now, 'aria-valuetext': text });

/** Only what is new: a button whose text is replaced while it is held gets no click in WebKit. @param {Element} element @param {string} text */
export function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** Hears of events before what they are for does. @template {keyof WindowEventMap} K @param {readonly K[]} types @param {(event: WindowEventMap[K]) => void} act */
export function onCapture(types, act) {
  for (const type of types) addEventListener(type, act, { capture: true });
}

/** The size of an element in pixels, kept up to date. @param {HTMLElement} element @param {(size: { width: number, height: number }) => void} onResize */
export function followSize(element, onResize) {
  let size = { width: 0, height: 0 };
  let density = devicePixelRatio;
  const measure = () => {
    size = { width: element.clientWidth, height: element.clientHeight };
    density = devicePixelRatio;
    onResize(size);
  };
  // In the next frame: what is drawn now might change a size that is being told.
  new ResizeObserver(() => requestAnimationFrame(measure)).observe(element);
  measures.set(element, () => {
    if (density !== devicePixelRatio) measure();
  });
  followed.add(new WeakRef(element));
  return () => size;
}

/** What is followed, as long as anybody else holds it: a step of the lesson makes its pictures anew at every visit. @type {Set<WeakRef<HTMLElement>>} */
const followed = new Set();
/** @type {WeakMap<HTMLElement, () => void>} */
const measures = new WeakMap();
// Another density of pixels comes without another size.
globalThis.addEventListener?.('resize', () => {
  for (const held of followed) {
    const element = held.deref();
    if (element) measures.get(element)?.();
    else followed.delete(held);
  }
});
