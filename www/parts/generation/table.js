// The whole generation as a table.
import { byId, create } from '../../kit/elements.js';
import { generation as words } from '../../words/index.js';
import { isInitial } from './record.js';

/** @typedef {import('./record.js').Anatomy} Anatomy */

/** @param {() => Anatomy} anatomyOf */
export function createTable(anatomyOf) {
  /** @type {HTMLDialogElement} */
  const dialog = byId('generation-dialog');
  byId('generation-close').addEventListener('click', () => dialog.close());
  return {
    show() {
      fill(byId('generation-rows'), anatomyOf());
      dialog.showModal();
    },
  };
}

/** @param {HTMLElement} table @param {Anatomy} anatomy */
function fill(table, anatomy) {
  const head = create('tr', '', ...words.columns.map((text) => headCell(text, 'col')));
  const rows = anatomy.ranking.map((number) => rowOf(anatomy, number));
  table.replaceChildren(
    create('caption', '', words.tableCaption(anatomy)),
    create('thead', '', head),
    create('tbody', '', ...rows),
  );
}

/** @param {Anatomy} anatomy @param {number} number */
function rowOf(anatomy, number) {
  const { all, ranks, record, count } = anatomy;
  const { gains, sigmas, cost } = all[number];
  const initial = isInitial(record);
  const texts = [
    words.nameOf(anatomy, number),
    String(number),
    initial || number < count ? '' : words.nameOf(anatomy, number - count),
    ...gains.map((gain) => words.gainText(gain)),
    ...sigmas.map(words.sigmaText),
    words.costWriter(anatomy)(cost),
    initial ? '' : String(record.wins[number]),
    ranks[number] < count ? words.yes : words.no,
  ];
  const row = create('tr', '', headCell(String(ranks[number] + 1), 'row'));
  row.append(...texts.map((text) => create('td', '', text)));
  if (ranks[number] >= count) row.className = 'falls';
  return row;
}

/** @param {string} text @param {'col' | 'row'} scope */
function headCell(text, scope) {
  const cell = create('th', '', text);
  cell.setAttribute('scope', scope);
  return cell;
}
