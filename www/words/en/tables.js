// Every word of the tables that stand beside pictures.

export const texts = {
  tableButton: 'Table',
  tableBefore: 'Rows before',
  tableAfter: 'Rows after',
  tableCsv: 'Download CSV',
};

/** @param {number} from @param {number} to @param {number} count */
export const rowsText = (from, to, count) => `Rows ${from} to ${to} of ${count}`;

/** @param {number} newest */
export const fitnessCaption = (newest) => `The fitness curve, generations 0 to ${newest}`;

export const fitnessColumns = [
  'generation',
  'drives',
  'best J',
  'median J',
  'worst J',
  'mean σx',
  'mean σy',
  'mean σθ',
];

/** @param {string} across @param {string} up @param {string} third @param {number} value */
export const landscapeCaption = (across, up, third, value) =>
  `J at some points of the landscape: ${across} from column to column, ${up} from row to row, ${third} ${value} everywhere`;

/** @param {number} headings */
export const robustnessCaption = (headings) =>
  `How many of ${headings} headings arrive at some places of the map: x in metres from column to column, y from row to row`;

/** @param {string} up @param {string} across */
export const corner = (up, across) => `${up} ↓, ${across} →`;
