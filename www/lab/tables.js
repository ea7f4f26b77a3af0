// Pictures as tables, for those who cannot see them or want the numbers: one dialog for all.
import { gainNames, landscapeSlice } from '../parts/landscape/state.js';
import { robustnessSlice } from '../parts/robustness/state.js';
import { byId, create } from '../kit/elements.js';
import { gainOn, thirdOf } from '../parts/landscape/request.js';
import { startOf } from '../parts/robustness/grid.js';
import { lab, tables as words } from '../words/index.js';

/** @typedef {import('../parts/landscape/request.js').Landscape} Landscape */
/** @typedef {import('../parts/robustness/request.js').Survey} Survey */
/** @typedef {import('../core/engine.js').Statistics} Statistics */
/** @typedef {import('../run/store.js').Store} Store */
/** @typedef {{ caption: string, columns: readonly string[], rows: readonly (readonly string[])[] }} Table Each row begins with its name. */

/** A map has too many cells to read: so many rows and columns of it. */
const mostOfMap = 13;

/** A button that opens a table, if there is one. @param {string} id @param {() => Table | null} tableOf */
export function offer(id, tableOf) {
  byId(id).addEventListener('click', () => {
    const table = tableOf();
    if (!table) return;
    fill(byId('table-rows'), table);
    /** @type {HTMLDialogElement} */ (byId('table')).showModal();
  });
}

/** @param {Store} store */
export function createTables(store) {
  byId('table-close').addEventListener('click', () =>
    /** @type {HTMLDialogElement} */ (byId('table')).close(),
  );
  offer('fitness-table', () => fitnessTable(store.get().history));
  offer('landscape-table', () => {
    const { result } = landscapeSlice.of(store.get());
    return result && landscapeTable(result);
  });
  offer('robustness-table', () => {
    const { survey } = robustnessSlice.of(store.get());
    return survey && robustnessTable(survey);
  });
}

/** @param {HTMLElement} root @param {Table} table */
function fill(root, { caption, columns, rows }) {
  const head = (/** @type {string} */ text, /** @type {'col' | 'row'} */ scope) => {
    const cell = create('th', '', text);
    cell.setAttribute('scope', scope);
    return cell;
  };
  root.replaceChildren(
    create('caption', '', caption),
    create('thead', '', create('tr', '', ...columns.map((text) => head(text, 'col')))),
    create(
      'tbody',
      '',
      ...rows.map(([name, ...cells]) =>
        create('tr', '', head(name, 'row'), ...cells.map((text) => create('td', '', text))),
      ),
    ),
  );
}

/** @param {Statistics[]} history @returns {Table} */
export const fitnessTable = (history) => ({
  caption: words.fitnessCaption(history.length - 1),
  columns: words.fitnessColumns,
  rows: history.map(({ generation, evaluations, best, median, worst, meanSigmas }) => [
    String(generation),
    String(evaluations),
    ...[best.cost, median, worst].map(lab.costText),
    ...meanSigmas.map(lab.threeDigits),
  ]),
});

/** Evenly chosen indices, first and last among them. @param {number} count */
const some = (count) =>
  Array.from({ length: Math.min(mostOfMap, count) }, (_, i) =>
    Math.round((i * (count - 1)) / (Math.min(mostOfMap, count) - 1)),
  );

/** @param {Landscape} landscape @returns {Table} */
export function landscapeTable({ spec, count, costs }) {
  const name = (/** @type {number} */ index) => lab.gains[index].name;
  const [across, up] = [spec.x, spec.y].map(({ gain }) => name(gainNames.indexOf(gain)));
  const columns = some(count);
  /** @param {'x' | 'y'} axis @param {number} index */
  const gain = (axis, index) => lab.threeDigits(gainOn(spec[axis], spec.range, index / (count - 1)));
  return {
    caption: words.landscapeCaption(across, up, name(thirdOf(spec)), Number(spec.third.toPrecision(3))),
    columns: [words.corner(up, across), ...columns.map((column) => gain('x', column))],
    // The highest row first, as in the picture.
    rows: some(count)
      .reverse()
      .map((row) => [gain('y', row), ...columns.map((column) => lab.costText(costs[row * count + column]))]),
  };
}

/** @param {Survey} survey @returns {Table} */
export function robustnessTable({ grid, tally }) {
  const columns = some(grid.x.count);
  return {
    caption: words.robustnessCaption(grid.headings),
    columns: [words.corner('y', 'x'), ...columns.map((column) => lab.fixed(startOf(grid, column, 0).x, 2))],
    rows: some(grid.y.count)
      .reverse()
      .map((row) => [
        lab.fixed(startOf(grid, row * grid.x.count, 0).y, 2),
        ...columns.map((column) => String(tally.count[row * grid.x.count + column])),
      ]),
  };
}
