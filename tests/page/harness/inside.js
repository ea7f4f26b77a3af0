// What the harness does within the page. It is sent there as text, so nothing here may name anything else.

/**
 * Does something when what happened before is drawn, and what was opened is loaded. Other pages draw at once.
 * @param {(...args: any[]) => unknown} body
 * @param {unknown[]} args
 */
export function onceDrawn(body, args) {
  if (!window.pageFrames) return body(...args);
  const there = async () => {
    await pageFrames.drawn();
    while (document.querySelector('.part-waits')) {
      await new Promise((resolve) => setTimeout(resolve, 20));
      await pageFrames.drawn();
    }
  };
  return there().then(() => body(...args));
}

/**
 * Looks again and again until there is something to see.
 * @param {number} longest in milliseconds
 * @param {(...args: unknown[]) => unknown} condition
 * @param {unknown[]} args
 */
export async function look(longest, condition, args) {
  const end = performance.now() + longest;
  try {
    for (;;) {
      // A page that has just been opened has no element yet, and sees nothing.
      const result = document.documentElement && (await condition(...args));
      if (result || performance.now() > end) return { result };
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  } catch (error) {
    return { error: String(error) };
  }
}

/**
 * The one element that a selector finds, scrolled into view, and the middle of what is in sight of it, where a press there
 * meets it; else how many there are.
 * @param {string} selector
 */
export function findOne(selector) {
  const elements = document.querySelectorAll(selector);
  if (elements.length !== 1) return { count: elements.length };
  const [element] = elements;
  element.scrollIntoView({ block: 'nearest' });
  const [box] = element.getClientRects();
  // In a frame the keys that follow would go to the page around it.
  if (!box || window !== top || element instanceof HTMLOptionElement) return { element };
  const [x, y] = [
    (Math.max(box.left, 0) + Math.min(box.right, innerWidth)) / 2,
    (Math.max(box.top, 0) + Math.min(box.bottom, innerHeight)) / 2,
  ].map(Math.floor);
  const isMet =
    element.contains(document.elementFromPoint(x, y)) &&
    element.checkVisibility?.({ opacityProperty: true, visibilityProperty: true });
  return isMet ? { element, place: { x, y } } : { element };
}

/** @param {string} address of axe-core @param {string} selector @param {boolean} contrast whether colours are looked at */
export async function obstaclesOf(address, selector, contrast) {
  const own = /** @type {{ axe?: typeof import('axe-core') }} */ (/** @type {unknown} */ (window));
  if (!own.axe)
    await new Promise((resolve, reject) => {
      const script = document.createElement('script');
      Object.assign(script, { src: address, onload: resolve, onerror: reject });
      document.head.append(script);
    });
  const { violations } = await /** @type {typeof import('axe-core')} */ (own.axe).run(selector, {
    // What is read below names no selector, which takes time to find.
    selectors: false,
    resultTypes: ['violations'],
    // What the navigation has scrolled out of sight is no link that skips to something.
    rules: { 'color-contrast': { enabled: contrast }, 'skip-link': { enabled: false } },
  });
  return violations.map(
    ({ id, help, nodes }) => `${id}: ${help}: ${nodes.map(({ html }) => html).join(' ')}`,
  );
}
