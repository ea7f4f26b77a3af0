// Some points of the landscape as a table.
/** @import { Table } from '../../kit/table.js' */
/** @import { Landscape } from './request.js' */
import { someOf } from '../../kit/table.js';
import { lab, tables as words } from '../../words/index.js';
import { gainOn, thirdOf } from './request.js';
import { gainNames } from './state.js';

/** @param {Landscape} landscape @returns {Table} */
export function landscapeTable({ spec, count, costs }) {
  const name = (/** @type {number} */ index) => lab.gains[index].name;
  const [across, up] = [spec.x, spec.y].map(({ gain }) => name(gainNames.indexOf(gain)));
  const columns = someOf(count);
  // The highest row first, as in the picture.
  const rows = someOf(count).reverse();
  /** @param {'x' | 'y'} axis @param {number} index */
  const gain = (axis, index) => lab.threeDigits(gainOn(spec[axis], spec.range, index / (count - 1)));
  return {
    caption: words.landscapeCaption(across, up, name(thirdOf(spec)), Number(spec.third.toPrecision(3))),
    columns: [words.corner(up, across), ...columns.map((column) => gain('x', column))],
    count: rows.length,
    rowOf: (i) => [
      gain('y', rows[i]),
      ...columns.map((column) => lab.costText(costs[rows[i] * count + column])),
    ],
  };
}
