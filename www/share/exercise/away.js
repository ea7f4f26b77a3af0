// What an exercise hides is taken out of the document: no style, no screen reader, no search finds it there. It comes back to
// its place.

/** @param {(element: Element) => void} onReturn What is done with one that is back. */
export function createAway(onReturn) {
  /** What is away, in the order in which it went, and what keeps its place. @type {Map<Element, Comment>} */
  const away = new Map();
  return {
    /** Takes out what is there. @param {string} selector */
    take(selector) {
      if (selector === '') return;
      for (const element of document.querySelectorAll(selector)) {
        // It went with one around it.
        if (!element.isConnected) continue;
        const place = document.createComment('');
        element.replaceWith(place);
        away.set(element, place);
      }
    },

    /** Brings back all whose place is still there: one of a view that was drawn anew is gone with it. Whether there was any. */
    bringBack() {
      const back = [...away].reverse();
      away.clear();
      for (const [element, place] of back)
        if (place.parentNode) {
          place.replaceWith(element);
          onReturn(element);
        }
      return back.length > 0;
    },
  };
}
