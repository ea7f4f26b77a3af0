// A page that is loaded again, by somebody or by a telephone on its own, opens as it was left: its address tells of that only some
// moments later.
import { isEmbedded } from '../kit/host.js';
import { withStorage } from '../kit/tab.js';

/** Each address has its own, for one may go back to another. */
const keyNow = () => `ep-locomotion left ${location.href}`;

/** Keeps it for this tab. Of a figure, the page around it says what it shows. @param {() => string | null} linkNow What is to be opened then; null, where the address says it. */
export function keepLeft(linkNow) {
  if (isEmbedded) return;
  addEventListener('pagehide', () => {
    const link = linkNow();
    withStorage((storage) =>
      link === null || `#${link}` === location.hash
        ? storage.removeItem(keyNow())
        : storage.setItem(keyNow(), link),
    );
  });
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
