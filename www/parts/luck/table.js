// All seeds as a table, and as a file for other programs.
import { download } from '../../kit/download.js';
import { byId } from '../../kit/elements.js';
import { costText, fixed } from '../../words/numbers.js';
import { luck as words } from '../../words/index.js';
import { csvOf, quartilesOf } from './statistics.js';

/** @typedef {import('./request.js').SeedSurvey} SeedSurvey */

const quartileNames = /** @type {const} */ (['least', 'low', 'median', 'high', 'most']);

/** @param {() => SeedSurvey | null} surveyOf */
export function createTable(surveyOf) {
  /** @type {HTMLDialogElement} */
  const dialog = byId('luck-dialog');
  byId('luck-close').addEventListener('click', () => dialog.close());
  byId('luck-csv').addEventListener('click', () => {
    const survey = surveyOf();
    if (survey) download(words.fileName(survey), 'text/csv', csvOf(survey));
  });
  return {
    show() {
      const survey = surveyOf();
      if (!survey) return;
      fill(byId('luck-rows'), survey);
      dialog.showModal();
    },
  };
}

/** The generations that the table shows; the file has all. @param {number} generations */
const shownGenerations = (generations) => [
  ...new Set([0, 0.05, 0.25, 0.5, 1].map((part) => Math.round(part * generations))),
];

/** @param {HTMLElement} table @param {SeedSurvey} survey */
function fill(table, { first, generations, runs, summary }) {
  const shown = shownGenerations(generations);
  const cell = (/** @type {string} */ tag, /** @type {string} */ text, scope = '') => {
    const element = document.createElement(tag);
    element.textContent = text;
    if (scope) element.setAttribute('scope', scope);
    return element;
  };
  const row = (/** @type {HTMLElement[]} */ ...cells) => {
    const element = document.createElement('tr');
    element.append(...cells);
    return element;
  };
  const section = (/** @type {string} */ tag, /** @type {HTMLElement[]} */ rows) => {
    const element = document.createElement(tag);
    element.append(...rows);
    return element;
  };
  const gainText = (/** @type {number} */ gain) => fixed(gain, 3);

  const head = [words.seedColumn, ...shown.map(words.costColumn), ...words.gainColumns, words.randomColumn];
  const costs = shown.map((generation) => quartilesOf(runs.map(({ best }) => best[generation])));
  const quartiles = quartileNames.map((name) =>
    row(
      cell('th', words.quartiles[name], 'row'),
      ...costs.map((one) => cell('td', costText(one[name]))),
      ...summary.gains.map((one) => cell('td', gainText(one[name]))),
      cell('td', costText(summary.finalRandom[name])),
    ),
  );
  const seeds = runs.map(({ best, champion, random }, i) =>
    row(
      cell('th', String(first + i), 'row'),
      ...shown.map((generation) => cell('td', costText(best[generation]))),
      ...champion.gains.map((gain) => cell('td', gainText(gain))),
      cell('td', costText(random[generations])),
    ),
  );
  table.replaceChildren(
    cell('caption', words.tableCaption(runs.length, generations)),
    section('thead', [row(...head.map((text) => cell('th', text, 'col')))]),
    section('tbody', quartiles),
    section('tbody', seeds),
  );
}
