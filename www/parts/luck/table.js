// All seeds as a table, and as a file for other programs.
/** @import { SeedSurvey } from './request.js' */
import { download } from '../../kit/download.js';
import { costText, fixed } from '../../words/numbers.js';
import words from './words/index.js';
import { csvOf, quartilesOf } from './statistics.js';

const quartileNames = /** @type {const} */ (['least', 'low', 'median', 'high', 'most']);

/** The generations that the table shows; the file has all. @param {number} generations */
const shownGenerations = (generations) => [
  ...new Set([0, 0.05, 0.25, 0.5, 1].map((part) => Math.round(part * generations))),
];

/** @param {SeedSurvey} survey @returns {import('../../kit/table.js').Table} */
export function seedTable(survey) {
  const { experiment, first, generations, runs, summary } = survey;
  const shown = shownGenerations(generations);
  const gainText = (/** @type {number} */ gain) => fixed(gain, 3);
  const costs = shown.map((generation) => quartilesOf(runs.map(({ best }) => best[generation])));
  return {
    caption: words.tableCaption(runs.length, generations),
    columns: [
      words.seedColumn,
      ...shown.map(words.costColumn),
      ...words.gainColumns[experiment.law],
      words.randomColumn,
    ],
    summary: quartileNames.map((name) => [
      words.quartiles[name],
      ...costs.map((one) => costText(one[name])),
      ...summary.gains.map((one) => gainText(one[name])),
      costText(summary.finalRandom[name]),
    ]),
    count: runs.length,
    rowOf(row) {
      const { best, champion, random } = runs[row];
      return [
        String(first + row),
        ...shown.map((generation) => costText(best[generation])),
        ...champion.gains.map(gainText),
        costText(random[generations]),
      ];
    },
    save: () => download(words.fileName(survey), 'text/csv', csvOf(survey)),
  };
}
