// The whole generation as a table.
/** @import { Anatomy } from './record.js' */
import words from './words/index.js';
import { isInitial } from './record.js';
import { isOtherSearch } from './state.js';

/** @param {Anatomy} anatomy @returns {import('../../kit/table.js').Table} */
export function generationTable(anatomy) {
  const { all, staying, ranks, ranking, record, count } = anatomy;
  const initial = isInitial(record);
  const costText = words.costWriter(anatomy);
  return {
    caption: words.tableCaption(anatomy),
    columns: words.columns,
    count: ranking.length,
    rowOf(row) {
      const number = ranking[row];
      return [
        String(ranks[number] + 1),
        words.nameOf(anatomy, number),
        String(number),
        initial || number < count || isOtherSearch(record) ? '' : words.nameOf(anatomy, number - count),
        ...all[number].gains.map((gain) => words.gainText(gain)),
        ...all[number].sigmas.map(words.sigmaText),
        costText(all[number].cost),
        String(record.wins[number] ?? ''),
        ranks[number] < staying ? words.yes : words.no,
      ];
    },
    classOf: (row) => (ranks[ranking[row]] >= staying ? 'falls' : ''),
  };
}
