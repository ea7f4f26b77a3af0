// The controllers of examples/mujoco, as the page exports them.
//
//   node .tasks/controllers.mjs   writes them anew, after npm run build core
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createEngine, Evolution, experiment, paperGains, version } from '../www/core/headless.js';
import { controllerOf } from '../www/share/code/controller.js';
import { python } from '../www/share/code/python.js';
import { comments } from '../www/share/code/words/en.js';
import { isProgram, top } from './run.mjs';

/** @typedef {import('../www/core/engine.js').Triple} Triple */

export const folder = join(top, 'examples/mujoco/controllers');

/** The best of a generation. @param {number} generations @returns {Triple} */
function evolved(generations) {
  const evolution = new Evolution(experiment('velocity-limits'));
  for (let i = 0; i < generations; i++) evolution.step();
  return evolution.statistics().best.gains;
}

/** The files by their names. */
export function controllerFiles() {
  const { drive } = createEngine();
  const paper = (/** @type {Parameters<typeof paperGains>} */ ...which) =>
    /** @type {Triple} */ ([...paperGains(...which)]);
  const rows = /** @type {const} */ ([
    ['paper', 'velocity-limits', paper('velocity-limits', 'ep'), '&drives=paper-ep'],
    ['evolved', 'velocity-limits', evolved(100), '&generation=100'],
    ['ten', 'velocity-limits', [10, 10, 10], '&drives=paper-arbitrary'],
    ['ten_accelerating', 'acceleration-limits', [10, 10, 10], '&drives=hand&gains=10,10,10'],
  ]);
  return rows.map(([name, preset, gains, rest]) => {
    const limits = preset === 'velocity-limits' ? '' : `&preset=${preset}`;
    const link = `index.html#lab&v=1${limits}${rest}`;
    const controller = controllerOf(drive, experiment(preset), gains, { version: version(), link });
    return {
      file: `${name}.py`,
      link,
      gains,
      experiment: controller.experiment,
      text: python({ ...controller, name }, comments),
    };
  });
}

if (isProgram(import.meta.url))
  for (const { file, text } of controllerFiles()) writeFileSync(join(folder, file), text);
