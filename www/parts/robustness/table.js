// Some places of the map as a table.
/** @import { Table } from '../../kit/table.js' */
/** @import { Survey } from './request.js' */
import { someOf } from '../../kit/table.js';
import { lab, tables as words } from '../../words/index.js';
import { startOf } from './grid.js';

/** @param {Survey} survey @returns {Table} */
export function robustnessTable({ grid, tally }) {
  const columns = someOf(grid.x.count);
  const rows = someOf(grid.y.count).reverse();
  return {
    caption: words.robustnessCaption(grid.headings),
    columns: [words.corner('y', 'x'), ...columns.map((column) => lab.fixed(startOf(grid, column, 0).x, 2))],
    count: rows.length,
    rowOf: (i) => [
      lab.fixed(startOf(grid, rows[i] * grid.x.count, 0).y, 2),
      ...columns.map((column) => String(tally.count[rows[i] * grid.x.count + column])),
    ],
  };
}
