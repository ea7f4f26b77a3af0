// Where the focus goes when what was pressed goes away by it.
import { isSeen, onCapture } from './elements.js';

/** To be called once the page is drawn, with the heading of what is open: if what was pressed last is gone, and the focus with it, the next one has it, or what was opened by it. @param {string} selector Of all that may have it. */
export function createFocusKeeper(selector) {
  /** What was pressed, and what it stands in, from within. @type {Element[]} */
  let path = [];
  let open = '';
  let isElsewhere = false;
  const follow = () => {
    path = [];
    for (let at = document.activeElement; at && at !== document.body; at = at.parentElement) path.push(at);
  };
  const forget = () => {
    path = [];
    isElsewhere = false;
  };
  addEventListener('click', follow);
  onCapture(['pointerdown', 'keydown'], forget);

  /** @param {string} heading A selector. */
  return (heading) => {
    isElsewhere ||= heading !== open;
    open = heading;
    const [pressed] = path;
    if (!pressed || isSeen(pressed)) return;
    const { activeElement } = document;
    // Whoever frames the page keeps the focus that is there.
    if ((activeElement !== pressed && activeElement !== document.body) || !document.hasFocus())
      return forget();
    const place = path.find((one) => one.isConnected) ?? document.body;
    const isNext = (/** @type {Element} */ one) =>
      place.compareDocumentPosition(one) & Node.DOCUMENT_POSITION_FOLLOWING;
    const next = isElsewhere ? undefined : shown(selector).find(isNext);
    const [title] = shown(heading);
    // What is opened may still be loading.
    if (!next && !title) return;
    if (!next) title.tabIndex = -1;
    forget();
    (next ?? title).focus({ preventScroll: true });
  };
}

/** @param {string} selector */
const shown = (selector) =>
  /** @type {HTMLElement[]} */ ([...document.querySelectorAll(selector)]).filter(isSeen);
