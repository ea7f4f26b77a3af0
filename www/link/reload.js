// A page that is loaded again, by somebody or by a telephone on its own, opens as it was left: its address tells of that only some
// moments later.
import { isEmbedded } from '../kit/host.js';
import { withStorage } from '../kit/tab.js';

/** Each address has its own, for one may go back to another. */
const prefix = 'ep-locomotion left ';

/** @param {Storage} storage @param {string} link */
function forget(storage, link) {
  for (const key of Object.keys(storage))
    if (key.startsWith(prefix) && storage.getItem(key) === link) storage.removeItem(key);
}

/**
 * Keeps it for this tab as long as nobody sees the page: what is hidden may end without a word. A figure keeps nothing.
 * @param {() => string | null} linkNow What is to be opened then; null, where the address says it.
 * @param {{ readonly replaced: string }} address The one before: that is loaded again where it was asked for just before it was replaced.
 */
export function keepLeft(linkNow, address) {
  if (isEmbedded) return;
  let kept = '';
  const show = () => withStorage((storage) => forget(storage, kept));
  const keep = () => {
    show();
    withStorage((storage) => {
      kept = linkNow() ?? '';
      if (!kept) return;
      for (const href of [location.href, address.replaced]) if (href) storage.setItem(prefix + href, kept);
    });
  };
  addEventListener('pagehide', keep);
  addEventListener('pageshow', show);
  document.addEventListener('visibilitychange', () => (document.hidden ? keep() : show()));
}

/** Takes it up, once: the address is that of what was left. */
export function takeLeft() {
  if (isEmbedded) return;
  const left = withStorage((storage) => {
    const link = storage.getItem(prefix + location.href);
    if (link) forget(storage, link);
    return link;
  });
  const [entry] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType('navigation'));
  if (left && entry?.type !== 'navigate') history.replaceState(history.state, '', `#${left}`);
}
