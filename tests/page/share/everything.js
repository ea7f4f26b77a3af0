/** What can be found of the document, of all of its shadow trees, and of what hangs on no style: the names of things, and what is said of them. @param {string} [but] Selects what is passed over, with its label. */
export function everything(but) {
  /** @type {Set<string>} */
  const found = new Set();
  const add = (/** @type {string | null | undefined} */ text) => {
    const tidy = text?.replace(/\s+/g, ' ').trim();
    if (tidy) found.add(tidy);
  };
  const isLeftOut = (/** @type {Node} */ node) =>
    but !== undefined &&
    node instanceof Element &&
    (node.matches(but) || (node instanceof HTMLLabelElement && node.querySelector(but) !== null));
  const look = (/** @type {Document | ShadowRoot} */ root) => {
    const walker = document.createTreeWalker(
      root,
      NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT | NodeFilter.SHOW_COMMENT,
      (node) => (isLeftOut(node) ? NodeFilter.FILTER_REJECT : NodeFilter.FILTER_ACCEPT),
    );
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (!(node instanceof Element)) {
        if (!node.parentElement?.matches('script, style')) add(node.nodeValue);
        continue;
      }
      for (const { name, value } of node.attributes) {
        if (name === 'id') add(`#${value}`);
        else if (/^(aria-|title|alt|placeholder|value|label|data-)/.test(name)) add(value);
      }
      if (node instanceof HTMLInputElement || node instanceof HTMLTextAreaElement) add(node.value);
      if (node.shadowRoot) look(node.shadowRoot);
    }
  };
  look(document);
  add(document.title);
  return [...found];
}
