// The whole generation as a table.
/** @import { Anatomy } from './record.js' */
import words from './words/index.js';
import { isInitial } from './record.js';

/** @param {Anatomy} anatomy @returns {import('../../kit/table.js').Table} */
export function generationTable(anatomy) {
  const { all, ranks, ranking, record, count } = anatomy;
  const initial = isInitial(record);
  return {
    caption: words.tableCaption(anatomy),
    columns: words.columns,
    rows: ranking.map((number) => [
      String(ranks[number] + 1),
      words.nameOf(anatomy, number),
      String(number),
      initial || number < count ? '' : words.nameOf(anatomy, number - count),
      ...all[number].gains.map((gain) => words.gainText(gain)),
      ...all[number].sigmas.map(words.sigmaText),
      words.costWriter(anatomy)(all[number].cost),
      initial ? '' : String(record.wins[number]),
      ranks[number] < count ? words.yes : words.no,
    ]),
    classOf: (row) => (ranks[ranking[row]] >= count ? 'falls' : ''),
  };
}
