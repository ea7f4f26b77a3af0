// The whole generation as a table.
/** @import { Anatomy } from './record.js' */
import { hasPairs, hasSigmas } from '../../core/methods.js';
import words from './words/index.js';
import { isInitial } from './record.js';

/** @param {Anatomy} anatomy @returns {import('../../kit/table.js').Table} */
export function generationTable(anatomy) {
  const { all, staying, ranks, ranking, record, count, method } = anatomy;
  const { weights } = record.plan;
  const costText = words.costWriter(anatomy);
  return {
    caption: words.tableCaption(anatomy),
    columns: words.columnsOf(method),
    count: ranking.length,
    rowOf(row) {
      const number = ranking[row];
      return [
        String(ranks[number] + 1),
        words.nameOf(anatomy, number),
        String(number),
        madeOf(anatomy, number),
        ...all[number].gains.map((gain) => words.gainText(gain)),
        ...all[number].sigmas.map(hasSigmas(method) ? words.sigmaText : () => ''),
        costText(all[number].cost),
        weights.length > 0 && number >= (isInitial(record) ? 0 : count)
          ? words.weightText(weights[ranks[number]] ?? 0)
          : String(record.wins[number] ?? ''),
        ranks[number] < staying ? words.yes : words.no,
      ];
    },
    classOf: (row) => (ranks[ranking[row]] >= staying ? 'falls' : ''),
  };
}

/** The parents of an offspring. @param {Anatomy} anatomy @param {number} number */
function madeOf(anatomy, number) {
  const { count, method, record } = anatomy;
  if (isInitial(record) || number < count || !hasPairs(method)) return '';
  const others = record.donors[number - count] ?? [];
  return [words.nameOf(anatomy, number - count), ...others.map((other) => other + 1)].join(', ');
}
