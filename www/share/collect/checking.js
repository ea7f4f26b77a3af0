// The check that runs: of what was pasted and chosen, by the exercise that is asked for. Another one ends it.
/** @import { Given } from './check.js' */
/** @import { SheetTools } from '../load.js' */
/** @import { View } from './dialog.js' */
import { byId } from '../../kit/elements.js';
import { messageOf } from '../../words/errors.js';
import { createChecker } from './check.js';
import { createReader, mostEntries, mostOfAll } from './entries.js';
import { readAll } from './files.js';
import { remarksOf } from './table.js';
import words from './words/index.js';

/** What is not known before a check is over. @type {Pick<View, 'share' | 'status' | 'isBad' | 'note' | 'rows' | 'given' | 'first'>} */
export const unchecked = { share: null, status: '', isBad: false, note: '', rows: [], given: null, first: 0 };

/** @param {SheetTools} tools @param {() => View} viewNow @param {(patch: Partial<View>) => void} update */
export function createChecking({ engine, links }, viewNow, update) {
  const reader = createReader(links.pages);
  const checker = createChecker(engine, links);
  let control = new AbortController();
  const field = (/** @type {string} */ id) => /** @type {HTMLTextAreaElement} */ (byId(id)).value;

  /** The exercise that is asked for, if one is. */
  const asked = () => {
    const link = field('collect-exercise').trim();
    return link === '' ? null : checker.exerciseIn(reader.exerciseIn(link));
  };

  /** @param {Given | null} exercise @param {AbortSignal} signal */
  const run = async (exercise, signal) => {
    const began = performance.now();
    update({ share: 0 });
    const pasted = field('collect-text');
    const typed = pasted.slice(0, mostOfAll);
    const entries = [
      ...(typed.trim() ? await reader.read(typed) : []),
      ...(await readAll(viewNow().files, reader)),
    ];
    signal.throwIfAborted();
    if (entries.length === 0) return update({ share: null, status: words.nothing });
    const onProgress = (/** @type {number} */ share) => {
      if (!signal.aborted && share - (viewNow().share ?? 0) >= 0.01) update({ share });
    };
    const { rows, given } = await checker.check(entries.slice(0, mostEntries), exercise, {
      signal,
      onProgress,
    });
    const met = rows.filter(({ checked }) => checked?.judged?.isMet).length;
    const unread = rows.filter(({ checked }) => !checked).length;
    const marked = rows.filter((row) => row.checked && remarksOf(row, rows).length > 0).length;
    const said = [
      words.summary(rows.length, met, unread, marked, performance.now() - began),
      ...(entries.length > rows.length ? [words.onlyFirst(rows.length, entries.length)] : []),
      ...(pasted.length > typed.length ? [words.cutText(typed.length, pasted.length)] : []),
    ];
    update({ share: null, rows, given, status: said.join(' ') });
  };

  return {
    stop: () => control.abort(),

    async check() {
      control.abort();
      control = new AbortController();
      const { signal } = control;
      // Nothing that is there was judged by what is asked for now.
      update(unchecked);
      let exercise = null;
      try {
        exercise = asked();
      } catch (error) {
        return update({ status: words.noExercise(messageOf(error)), isBad: true });
      }
      try {
        await run(exercise, signal);
      } catch (error) {
        if (!signal.aborted) update({ share: null, status: words.failed(messageOf(error)), isBad: true });
      }
    },
  };
}
