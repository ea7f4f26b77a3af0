// A page that is loaded again, by somebody or by a telephone on its own, opens as it was left: its address tells of that only some
// moments later.
import { isEmbedded } from '../kit/host.js';
import { withStorage } from '../kit/tab.js';

/** Each address has its own, for one may go back to another. */
const keyNow = () => `ep-locomotion left ${location.href}`;

/** Keeps it for this tab as long as nobody sees the page: what is hidden may end without a word. A figure keeps nothing. @param {() => string | null} linkNow What is to be opened then; null, where the address says it. */
export function keepLeft(linkNow) {
  if (isEmbedded) return;
  /** Where it is kept. */
  let key = '';
  const forget = () => {
    if (key) withStorage((storage) => storage.removeItem(key));
    key = '';
  };
  const keep = () => {
    forget();
    withStorage((storage) => {
      const link = linkNow();
      if (link === null || `#${link}` === location.hash) return;
      storage.setItem(keyNow(), link);
      key = keyNow();
    });
  };
  addEventListener('pagehide', keep);
  addEventListener('pageshow', forget);
  document.addEventListener('visibilitychange', () => (document.hidden ? keep() : forget()));
}

/** Takes it up, once: the address is that of what was left. */
export function takeLeft() {
  if (isEmbedded) return;
  const left = withStorage((storage) => {
    const link = storage.getItem(keyNow());
    storage.removeItem(keyNow());
    return link;
  });
  const [entry] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType('navigation'));
  if (left && entry?.type !== 'navigate') history.replaceState(history.state, '', `#${left}`);
}
