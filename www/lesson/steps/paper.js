// The paper's numbers beside ours, and what lies between them.
import { largest } from '../../kit/extent.js';
import { lab } from '../../words/index.js';
import { fixed } from '../../words/numbers.js';
import { asPrinted } from '../printed.js';
import { createChoicesTable, createPaperTable } from '../views/paper-table.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Live } from '../page.js' */
/** @import { Written } from '../steps.js' */

/** The run of one row of the paper, in its own preset. @param {Live} live @param {number} row */
function runOf({ engine, paper }, row) {
  const { preset, gains } = paper[row];
  return engine.drive(engine.experiment(preset), [gains])[0];
}

/** @param {Live} live */
const costsOf = (live) => live.paper.map((_, row) => runOf(live, row).cost.total);

/** With the commanded velocity in the energy. @param {Live} live */
const printedOf = (live) => live.paper.map((_, row) => asPrinted(live, row));

/** @type {Written} */
export const paper = {
  figure: 'drive',
  blocks: [
    { kind: 'text', name: 'same' },
    quiz('literal', {
      shows: 'curves&drives=paper-arbitrary',
      watch: true,
      order: [1, 0, 2],
      answer(live) {
        const [here, literal] = [runOf(live, 1).cost.total, asPrinted(live, 1)];
        const ratio = literal / here;
        return { right: ratio < 1.5 ? 0 : ratio < 5 ? 1 : 2, here, literal, there: live.paper[1].cost };
      },
    }),
    { kind: 'view', create: createPaperTable, isText: true },
    { kind: 'text', name: 'order' },
    { kind: 'view', create: createChoicesTable, isText: true },
    { kind: 'text', name: 'printed', after: 'literal' },
    tries([
      ['speed', 'curves&preset=acceleration-limits&drives=paper-ep&tolerance.speed=0.05'],
      ['horizon', 'lab&horizon=3&tolerance.position=0&tolerance.heading=0&generation=100'],
      [
        'shortCheap',
        'lab&horizon=3&tolerance.position=0&tolerance.heading=0&generation=100&weights.velocity=0.1,0.1',
      ],
      ['weights', 'lab&drives=paper-ep&weights.velocity=2,2'],
      ['figure7', 'curves&preset=acceleration-limits&drives=paper-arbitrary'],
    ]),
    { kind: 'text', name: 'figure7' },
    { kind: 'notice' },
  ],
  values(live) {
    const costs = costsOf(live);
    const swing = largest(runOf(live, 3).theta) * (180 / Math.PI);
    return {
      velocity: fixed(costs[1] / costs[0], 2),
      paperVelocity: fixed(live.paper[1].cost / live.paper[0].cost, 2),
      acceleration: fixed(costs[3] / costs[2], 2),
      paperAcceleration: fixed(live.paper[3].cost / live.paper[2].cost, 2),
      swing: `${fixed(swing, 0)}°`,
      printed: printedOf(live).map(lab.costText).join('; '),
    };
  },
};
