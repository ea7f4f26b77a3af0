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

/** Whether it takes room on the page. Safari before 17.4 cannot tell it itself. @param {Element} element */
export const isSeen = (element) => element.checkVisibility?.() ?? element.getClientRects().length > 0;

/** Hears of events before what they are for does. @template {keyof WindowEventMap} K @param {readonly K[]} types @param {(event: WindowEventMap[K]) => void} act */
export function onCapture(types, act) {
  for (const type of types) addEventListener(type, act, { capture: true });
}
