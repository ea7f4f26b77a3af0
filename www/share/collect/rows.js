// What can be done with the hand-ins that are there: sort, pin, save, and open them one after the other.
/** @import { SheetTools } from '../load.js' */
/** @import { View } from './dialog.js' */
/** @import { Row } from './check.js' */
/** @import { Sheet } from '../../kit/sheet.js' */
/** @import { Column } from './words/common.js' */
import { download } from '../../kit/download.js';
import { byId } from '../../kit/elements.js';
import { noExercise } from '../../run/exercise.js';
import { isFull, pinOf, styles } from '../../run/pins.js';
import { nobody } from '../../run/variant.js';
import { handedAddress } from '../frame-text.js';
import { csvName, csvOf, mostRows, nameOf, ordered } from './table.js';
import words from './words/index.js';

/** What a pin holds. @param {Row} row */
const drivenOf = ({ checked }) => checked && { experiment: checked.run.experiment, gains: checked.gains };

/** @param {SheetTools} tools @param {Row} row */
export function isPinned({ store }, row) {
  const driven = drivenOf(row);
  return driven !== null && pinOf(store.get().pins, driven) !== undefined;
}

/** @param {SheetTools} tools @param {Sheet} sheet @param {() => View} viewNow @param {(patch: Partial<View>) => void} update */
export function createRowEvents({ store, actions, open, keepPlace }, sheet, viewNow, update) {
  return {
    /** @param {Column} column */
    sort(column) {
      const { order } = viewNow();
      update({ order: { column, isDown: column === order.column && !order.isDown }, first: 0 });
    },

    /** Or takes the pin away. @param {number} index */
    pin(index) {
      const row = viewNow().rows[index];
      const driven = drivenOf(row);
      if (!driven) return;
      const name = nameOf(row) || words.rowNumber(index);
      const { pins } = store.get();
      const hasNoRoom = isFull(pins) && !pinOf(pins, driven);
      if (!hasNoRoom) actions.togglePin(driven, name);
      const isThere = pinOf(store.get().pins, driven) !== undefined;
      const said = isThere ? words.pinned(name) : words.unpinned(name);
      update({ note: hasNoRoom ? words.notPinned(name, styles.length) : said });
    },

    /** One whole run, in which nothing is locked. Back from the first of them is what was there before. @param {number} index */
    open(index) {
      const { rows, order, opened } = viewNow();
      const { checked } = rows[index];
      if (!checked) return;
      // From one to the next the focus stays where it is pressed.
      const next = document.activeElement?.closest('#collect-strip button')?.id ?? 'strip-after';
      sheet.dialog.close();
      const focused = document.activeElement;
      const { pins, work } = store.get();
      const { run } = checked;
      if (opened?.since !== work.since) keepPlace(run);
      open({ ...run, pins, exercise: noExercise, student: nobody, parts: {} }, []);
      const place = ordered(rows, order).indexOf(index);
      update({ first: place - (place % mostRows) });
      actions.whenIdle().then(() => {
        const { experiment, work } = store.get();
        if (experiment !== run.experiment) return;
        update({ opened: { index, row: rows[index], since: work.since } });
        // Unless one has gone elsewhere meanwhile.
        if ([focused, document.body].includes(document.activeElement)) byId(next).focus();
      });
    },

    save() {
      const { rows, given } = viewNow();
      download(csvName(given), 'text/csv', csvOf(rows, handedAddress('')));
    },
  };
}
