// The table: one row for each set of gains, with how they fare.
import { write } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { lab, training as words } from '../../words/index.js';

/** @typedef {import('./request.js').Result} Result */
/** @typedef {import('./request.js').RowName} RowName */
/** What a row shows; `result` is null before there is one. @typedef {{ name: RowName, text: string, result: Result | null, old: boolean }} Row */

const rowNames = /** @type {const} */ (['one', 'circle', 'grid', 'paper-ep', 'paper-arbitrary', 'hand']);

/** @param {HTMLElement} root @param {(name: RowName) => void} onChoose */
export function createTable(root, onChoose) {
  const heads = words.columns.map((text) => {
    const head = document.createElement('th');
    head.scope = 'col';
    head.textContent = text;
    return head;
  });
  const rows = new Map(rowNames.map((name) => [name, createRow(name, onChoose)]));
  const head = document.createElement('thead');
  const body = document.createElement('tbody');
  const line = document.createElement('tr');
  line.append(...heads);
  head.append(line);
  body.append(...[...rows.values()].map(({ row }) => row));
  root.replaceChildren(head, body);

  return {
    /** @param {readonly Row[]} shown @param {RowName} chosen @param {number} unseen How many starts are never seen. */
    draw(shown, chosen, unseen) {
      heads[2].textContent = words.unseenColumn(unseen);
      for (const [name, row] of rows) {
        const model = shown.find((one) => one.name === name);
        row.row.hidden = !model;
        if (model) row.draw(model, name === chosen);
      }
    },
  };
}

/** @param {RowName} name @param {(name: RowName) => void} onChoose */
function createRow(name, onChoose) {
  const row = document.createElement('tr');
  const head = document.createElement('th');
  const button = document.createElement('button');
  const gains = document.createElement('span');
  const numbers = lab.gains.map(({ id, name: gain }) => {
    const number = document.createElement('span');
    number.className = id;
    number.title = gain;
    return number;
  });
  const cells = ['seen', 'unseen', 'cost', 'own'].map((part) => {
    const cell = document.createElement('td');
    cell.className = `training-${part}`;
    return cell;
  });
  const [seen, unseen, cost, own] = cells;
  const bar = document.createElement('span');
  const fill = document.createElement('span');
  const share = document.createElement('strong');
  row.id = `training-${name}`;
  head.scope = 'row';
  Object.assign(button, { type: 'button', className: 'training-name' });
  gains.className = 'training-gains';
  gains.append(...numbers);
  bar.className = 'training-bar';
  bar.append(fill);
  unseen.append(bar, share);
  head.append(button, gains);
  row.append(head, ...cells);
  // The button is for the keyboard; the whole row is as good for the pointer.
  row.addEventListener('click', () => onChoose(name));
  const changed = watch();

  return {
    row,
    /** @param {Row} model @param {boolean} chosen */
    draw({ text, result, old }, chosen) {
      if (!changed(text, result, old, chosen)) return;
      write(button, text);
      button.title = words.chooseHint(text);
      button.setAttribute('aria-pressed', String(chosen));
      row.classList.toggle('chosen', chosen);
      row.classList.toggle('old', old);
      for (const [i, number] of numbers.entries())
        number.textContent = result ? words.gain(result.gains[i]) : words.none;
      fill.style.width = result ? `${(100 * result.unseen.count) / result.unseen.starts.length}%` : '0';
      share.textContent = result
        ? words.percent(result.unseen.count, result.unseen.starts.length)
        : words.none;
      const isTrained = name === 'one' || name === 'circle' || name === 'grid';
      seen.textContent =
        result && isTrained
          ? words.percent(result.training.count, result.training.starts.length)
          : words.none;
      cost.textContent = result ? words.cost(result.unseen.cost) : words.none;
      own.textContent = result ? words.cost(result.own) : words.none;
    },
  };
}
