// As much of a browser's document as the lesson's words need to be written down as HTML, under Node.

/** What is said in HTML; the rest is for who can press it. */
const kept = ['class', 'scope', 'role', 'aria-label', 'display', 'displaystyle', 'stretchy'];

/** @param {string} text */
const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

export class Element {
  /** @type {(Element | string)[]} */
  nodes = [];
  /** @type {Map<string, string>} */
  attributes = new Map();
  /** @type {Record<string, string>} */
  dataset = {};

  /** @param {string} localName */
  constructor(localName) {
    this.localName = localName;
  }

  get children() {
    return this.nodes.filter((node) => typeof node !== 'string');
  }

  /** @returns {string} */
  get textContent() {
    return this.nodes.map((node) => (typeof node === 'string' ? node : node.textContent)).join('');
  }

  /** @param {string} text */
  set className(text) {
    this.setAttribute('class', text);
  }

  /** @param {string} name */
  getAttribute(name) {
    return this.attributes.get(name) ?? null;
  }

  /** @param {string} name @param {string} value */
  setAttribute(name, value) {
    this.attributes.set(name, value);
  }

  /** @param {(Element | string)[]} nodes */
  append(...nodes) {
    this.nodes.push(...nodes);
  }

  /** @param {(Element | string)[]} nodes */
  replaceChildren(...nodes) {
    this.nodes = nodes;
  }

  /** As HTML, with the values that its texts name. @param {Record<string, string>} values @returns {string} */
  html(values) {
    const { value } = this.dataset;
    if (value !== undefined && !(value in values)) throw new Error(`the article has no value for ${value}`);
    const inside =
      value === undefined
        ? this.nodes.map((node) => (typeof node === 'string' ? escaped(node) : node.html(values))).join('')
        : escaped(values[value]);
    // Where nothing runs, no link leads anywhere.
    if (this.localName === 'a') return inside;
    const attributes = kept
      .filter((name) => this.attributes.has(name))
      .map((name) => ` ${name}="${escaped(/** @type {string} */ (this.attributes.get(name)))}"`);
    return `<${this.localName}${attributes.join('')}>${inside}</${this.localName}>`;
  }
}

export const document = {
  createElement: (/** @type {string} */ tag) => new Element(tag),
  createElementNS: (/** @type {string} */ _namespace, /** @type {string} */ tag) => new Element(tag),
};
