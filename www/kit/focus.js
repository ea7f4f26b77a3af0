// Where the focus goes when what was pressed goes away by it.

/** To be called once the page is drawn: if what was pressed last is gone, and the focus with it, the next one has it. @param {string} selector Of all that may have it. */
export function createFocusKeeper(selector) {
  /** What was pressed, and what it stands in, from within. @type {Element[]} */
  let path = [];
  const follow = () => {
    path = [];
    for (let at = document.activeElement; at && at !== document.body; at = at.parentElement) path.push(at);
  };
  const forget = () => {
    path = [];
  };
  addEventListener('click', follow);
  for (const kind of ['pointerdown', 'keydown']) addEventListener(kind, forget, true);

  return () => {
    const [pressed] = path;
    if (!pressed || pressed.checkVisibility()) return;
    const { activeElement } = document;
    const place = path.find((one) => one.isConnected) ?? document.body;
    forget();
    // Whoever frames the page keeps the focus that is there.
    if ((activeElement !== pressed && activeElement !== document.body) || !document.hasFocus()) return;
    const isNext = (/** @type {Element} */ one) =>
      one.checkVisibility() && place.compareDocumentPosition(one) & Node.DOCUMENT_POSITION_FOLLOWING;
    const all = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(selector));
    [...all].find(isNext)?.focus({ preventScroll: true });
  };
}
