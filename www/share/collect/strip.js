// Whose run is on the page, once a hand-in was opened there: what came of it, the way to the next one, and back.
/** @import { Row } from './check.js' */
/** @import { View } from './dialog.js' */
import { html, nothing, render } from 'lit-html';
import { byId, create } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { judgedText, nameOf, ordered, remarksOf } from './table.js';
import words from './words/index.js';

const { texts } = words;

/** @param {{ open: (index: number) => void, back: () => void }} on `back`: to the table. */
export function createStrip(on) {
  const attributes = {
    id: 'collect-strip',
    class: 'collect-strip row',
    hidden: '',
    'aria-label': texts.strip,
  };
  const root = create('section', attributes);
  byId('exercise').before(root);
  const changed = watch();
  return {
    /** @param {View} view @param {number} since When what is on the page was opened. */
    draw(view, since) {
      if (!changed(view, since)) return;
      const { rows, order, opened } = view;
      // Once they are checked again its row is another.
      root.hidden = opened === null || opened.since !== since || rows[opened.index] !== opened.row;
      if (!opened || root.hidden) return;
      const readable = ordered(rows, order).filter((index) => rows[index].checked);
      render(contentOf(rows, readable, opened.index, on), root);
    },
  };
}

/** @param {readonly Row[]} rows @param {readonly number[]} readable In the order of the table. @param {number} index @param {{ open: (index: number) => void, back: () => void }} on */
function contentOf(rows, readable, index, on) {
  const place = readable.indexOf(index);
  const row = rows[index];
  const remarks = remarksOf(row, rows);
  /** @param {string} id @param {string} text @param {number | undefined} to */
  const button = (id, text, to) =>
    html`<button id=${id} type="button" aria-describedby="strip-said" aria-disabled=${String(to === undefined)} @click=${() => to !== undefined && on.open(to)}>${text}</button>`;
  return html`
    <p id="strip-said" role="status"><b><bdi>${nameOf(row) || words.rowNumber(index)}</bdi></b> · ${saidOf(row).join(' · ')}
      ${remarks.length > 0 ? html`<span class="muted">${remarks.join('; ')}</span>` : nothing}
      <span class="muted">${texts.stripBack}</span></p>
    <div class="bar">
      ${button('strip-before', texts.before, readable[place - 1])}
      ${button('strip-after', texts.after, readable[place + 1])}
      <span class="muted">${words.placeText(place + 1, readable.length)}</span>
      <button id="strip-back" type="button" @click=${on.back}>${texts.strip}</button>
    </div>`;
}

/** @param {Row} row */
function saidOf({ checked }) {
  if (!checked) return [];
  const { cost, judged } = checked;
  return [
    words.costText(words.numberText(cost)),
    ...(judged ? [words.aimText(judgedText(checked))] : []),
    ...(judged?.points == null ? [] : [words.pointsText(judged.points)]),
  ];
}
