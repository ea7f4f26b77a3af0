// J as a landscape, and where evolution walked in it.
import { landscapeSlice } from '../../parts/landscape/state.js';
import { remember, rememberEach } from '../../kit/memo.js';
import { lab } from '../../words/index.js';
import { fixed } from '../../words/numbers.js';
import { aside, isSame } from '../aside.js';
import { lowestPoint, mapOf, specOf } from '../lowest.js';
import { quiz, tries } from '../questions/asks.js';
import { path } from '../path.js';

/** @import { Engine } from '../../core/engine.js' */
/** @import { Landscape } from '../../parts/landscape/request.js' */
/** @import { Written } from '../steps.js' */

/** The map with which the step opens, with another goal. */
const turned = `${path.landscape}&goal.theta=90deg`;

/** As dear as this times the lowest point is still the floor of the valley. */
const floor = 1.05;

/** The share of a map that is floor. */
const floorShare = remember((/** @type {Float64Array} */ costs) => {
  const least = costs.reduce((a, b) => Math.min(a, b));
  return costs.filter((cost) => cost < floor * least).length / costs.length;
});

/** As wide as it will be once the map is there: no paragraph moves then. @param {string | null} text @param {number} most */
const roomFor = (text, most) => (text ?? '…').padEnd(most, '\u2007');

/** @type {Written} */
export const landscape = {
  figure: 'evolve',
  blocks: [
    { kind: 'text', name: 'map' },
    { kind: 'text', name: 'shape' },
    quiz('turn', {
      shows: turned,
      async answer({ engine, state, gains }) {
        const { preset, experiment } = state;
        const third = landscapeSlice.of(state).third ?? gains[1];
        const [old, now] = await Promise.all(
          [engine.experiment(preset), experiment].map((one) =>
            lowestPoint(engine, { experiment: one, preset, x: 'kx', y: 'ktheta', third }),
          ),
        );
        const [left] = engine.drive(experiment, [old.gains]);
        const stays = old.gains.every((gain, i) => gain === now.gains[i]);
        const again = `${turned}&drives=hand&gains=${old.gains}`;
        return { right: !left.arrived ? 2 : stays ? 0 : 1, old, now, left, again };
      },
    }),
    quiz('ky', {
      shows: 'landscape&x=kx&y=ky&generation=100',
      async answer({ engine, state, gains }) {
        const { preset, experiment } = state;
        const third = gains[2];
        const lowest = await lowestPoint(engine, { experiment, preset, x: 'kx', y: 'ky', third });
        const { most } = lowest;
        const [kx, ky, ktheta] = lowest.gains;
        const [middle, wall] = engine.drive(experiment, [
          [kx, most / 2, ktheta],
          [kx, -0.01, ktheta],
        ]);
        return { right: ky < 0.05 * most ? 1 : ky > 0.95 * most ? 2 : 0, lowest, middle, wall };
      },
    }),
    tries([
      ['walked', 'landscape&generation=100'],
      ['smooth', 'landscape&third=0'],
      ['deep', 'landscape&x=kx&y=ky-log&generation=100'],
      ['stuck', 'landscape&generation=200&goal.theta=0deg&seed=3'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values({ engine, state }) {
    const { history, generation } = state;
    const { result } = landscapeSlice.of(state);
    return {
      drives: roomFor(result && lab.grouped(result.costs.length), 6),
      grid: roomFor(result && lab.grouped(result.count ** 3), 9),
      side: roomFor(result && String(result.count), 3),
      floor: roomFor(result && fixed(100 * floorShare(openingMap(engine)(result).costs), 0), 2),
      generation: String(generation),
      spent: lab.grouped(history[generation].evaluations),
      horizon: fixed(engine.experiment('velocity-limits').horizon, 0),
    };
  },
};

/** The map with which the step opens: the one in sight, or, while another is, the same as it was or computed aside. */
const openingMap = rememberEach((/** @type {Engine} */ engine) => {
  const preset = 'velocity-limits';
  const experiment = engine.experiment(preset);
  const spec = specOf({ experiment, preset, x: 'kx', y: 'ktheta', third: 0.05 });
  const compute = aside(() => mapOf(engine, spec));
  /** @type {Landscape | null} */
  let known = null;
  return (/** @type {Landscape} */ shown) => {
    if (isSame(shown.spec, spec)) known = shown;
    return known ?? compute();
  };
});
