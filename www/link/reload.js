// A page that is loaded again, by somebody or by a telephone on its own, opens as it was left: its address tells of that only some
// moments later.
/** @import { Opened } from '../run/actions/page.js' */
/** @import { State } from '../run/state.js' */
import { isEmbedded } from '../kit/host.js';
import { isBack, withStorage } from '../kit/tab.js';
import { workId } from '../run/exercise.js';
import { caughtUp, spentOf } from '../run/state.js';

/** Each address has its own, for one may go back to another. */
const prefix = 'ep-locomotion left ';
/** Whose work on which exercise was left, since when it lasted, by the machine's clock, for the page's own begins anew, what was driven, and how long it had lasted. */
const workKey = 'ep-locomotion work';

/** @param {Storage} storage @param {string} link */
function forget(storage, link) {
  for (const key of Object.keys(storage))
    if (key.startsWith(prefix) && storage.getItem(key) === link) storage.removeItem(key);
}

/** @param {Storage} storage @param {State} state */
function keepWork(storage, state) {
  const lasted = performance.now() - state.work.begun;
  const shown = caughtUp(state);
  const kept = [workId(state), Date.now() - lasted, spentOf(shown), shown.generation, lasted];
  if (workId(state)) storage.setItem(workKey, JSON.stringify(kept));
}

/**
 * Keeps it for this tab as long as nobody sees the page: what is hidden may end without a word. A figure keeps nothing.
 * @param {() => string | null} linkNow What is to be opened then; null, where the address says it.
 * @param {{ readonly replaced: string }} address The one before: that is loaded again where it was asked for just before it was replaced.
 * @param {() => State} stateNow
 */
export function keepLeft(linkNow, address, stateNow) {
  if (isEmbedded) return;
  let kept = '';
  const show = () => withStorage((storage) => forget(storage, kept));
  const keep = () => {
    show();
    withStorage((storage) => {
      keepWork(storage, stateNow());
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
  if (left && isBack()) history.replaceState(history.state, '', `#${left}`);
}

/** The work on an exercise goes on where the page is loaded again. @param {Opened} opened @returns {Opened} */
export function takeWork(opened) {
  if (isEmbedded || !isBack()) return opened;
  const kept = withStorage((storage) => {
    const [id, since, driven = 0, generation = 0, lasted = 0] = JSON.parse(storage.getItem(workKey) ?? '[]');
    // Of other generations the link itself says more, or less, of what was driven.
    const made = generation === opened.generation ? driven : 0;
    const isWhole = [since, lasted].every(Number.isFinite) && Number.isSafeInteger(made);
    return isWhole ? { id, since, made, lasted } : null;
  });
  if (!kept?.id || kept.id !== workId(opened)) return opened;
  // That clock may have been set back meanwhile.
  const begun = performance.now() - Math.max(kept.lasted, Date.now() - kept.since);
  return { ...opened, student: { ...opened.student, begun, made: kept.made } };
}
