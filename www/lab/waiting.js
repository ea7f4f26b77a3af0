// What stands in the place of something that is loaded on demand.
import { create } from '../kit/elements.js';
import { canLoad, leaving } from '../kit/host.js';
import { isLost } from '../words/errors.js';
import { opening as words } from '../words/index.js';

/** In milliseconds: what has not come by then may never come, for a network can fall silent. */
export const long = 10_000;

/** @param {string} [note] What else is said where it fails. */
export function createWaiting(note = '') {
  const said = create('p', { class: 'part-waits', role: 'status' }, words.waits);
  const element = create('div', '', said);
  const timer = setTimeout(() => {
    said.append(` ${words.anew}`);
    element.append(...createRetry());
  }, long);
  return {
    element,
    /** It is there. */
    end: () => clearTimeout(timer),
    /** It could not be loaded, and the rest goes on; where the core is lost nothing does. @param {unknown} error */
    fail(error) {
      clearTimeout(timer);
      if (isLost(error)) throw error;
      console.warn(error);
      const failed = create('p', '', `${words.failed} ${words.anew} ${note}`);
      const box = { class: 'message part-failed', role: 'alert' };
      element.replaceChildren(create('div', box, failed, ...createRetry()));
    },
  };
}

/** The button, and what is said where it is still not there. */
function createRetry() {
  const again = create('button', { type: 'button' }, words.again);
  const still = create('p', { role: 'status' }, '');
  again.addEventListener('click', async () => {
    still.textContent = '';
    if (!(await loadPageAgain())) still.textContent = words.still;
  });
  return [again, still];
}

/** A browser may remember that a module could not be loaded, and after a new version its file has another name: so the whole page is loaded again, but only if it can be. */
async function loadPageAgain() {
  if (!(await canLoad())) return false;
  dispatchEvent(new Event(leaving));
  location.reload();
  return true;
}
