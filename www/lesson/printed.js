// J as equation (9) is printed, where the page reads it otherwise.

/** @import { Live } from './page.js' */

/** J with the energy of the commanded velocity, as (9) is printed, in the place of the limited one. @param {Pick<Live, 'engine' | 'paper'>} live @param {number} row */
export function asPrinted({ engine, paper }, row) {
  const { preset, gains } = paper[row];
  const experiment = engine.experiment(preset);
  const { cost, time, commandLinear, commandAngular } = engine.drive(experiment, [gains])[0];
  const [v, w] = experiment.weights.velocity;
  const step = time[1] - time[0];
  const energy = commandLinear.reduce((sum, one, i) => sum + v * one ** 2 + w * commandAngular[i] ** 2, 0);
  return cost.total - cost.energy + 0.5 * energy * step;
}
