// The fitness curve as a table.
/** @import { Experiment, Statistics } from '../core/engine.js' */
/** @import { Table } from '../kit/table.js' */
import { hasSigmas } from '../core/methods.js';
import { lab, tables as words } from '../words/index.js';

/** Points stand under each other. @param {number} value */
const pointedSigma = (value) => (value >= 0.01 ? lab.fixed(value, 3) : lab.powerText(value));

/** @param {{ history: Statistics[], experiment: Experiment }} evolved @returns {Table} */
export const fitnessTable = ({ history, experiment }) => ({
  caption: words.fitnessCaption(history.length - 1),
  columns: words.fitnessColumns,
  count: history.length,
  rowOf(row) {
    const { generation, evaluations, best, median, worst, meanSigmas } = history[row];
    return [
      String(generation),
      String(evaluations),
      ...[best.cost, median, worst].map(lab.costText),
      ...meanSigmas.map(hasSigmas(experiment.evolution.method) ? pointedSigma : () => ''),
    ];
  },
});
