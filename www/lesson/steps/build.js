// Build it yourself: what a program needs, the numbers by which one knows that it is right, and a task that is open.
import { createProgram } from '../views/program.js';
import { createPredictions } from '../views/predictions.js';
import { createDownloads, createCheckValues } from '../views/check-values.js';
import { errorRateFormula, motionFormula } from '../formulas/formulas-motion.js';
import { lawFormula } from '../formulas/formulas.js';
import { tries } from '../questions/asks.js';

/** @import { Written } from '../steps.js' */

/** @type {Written} */
export const build = {
  figure: 'evolve',
  blocks: [
    { kind: 'text', name: 'begin' },
    { kind: 'text', name: 'motion' },
    { kind: 'formula', formula: motionFormula },
    { kind: 'formula', formula: { ...lawFormula, numbers: undefined } },
    { kind: 'text', name: 'errors' },
    { kind: 'formula', formula: errorRateFormula },
    { kind: 'text', name: 'program' },
    { kind: 'view', create: createProgram, isText: true },
    { kind: 'text', name: 'check' },
    { kind: 'view', create: createCheckValues, isText: true },
    { kind: 'view', create: createDownloads },
    { kind: 'text', name: 'task' },
    tries([
      ['other', 'training&generation=100&weights.velocity=1,0.1&goal.theta=0deg'],
      ['accelerate', 'training&preset=acceleration-limits&generation=100&weights.velocity=1,0.1'],
      ['few', 'training&population=6&generation=100&weights.velocity=1,0.1'],
    ]),
    { kind: 'text', name: 'recap' },
    { kind: 'view', create: createPredictions },
    { kind: 'notice' },
  ],
};
