// The step size that adapts itself, and its collapse.
import words from '../../parts/generation/words/index.js';
import { fixed } from '../../words/numbers.js';
import { sigmaFormula } from '../formulas/formulas.js';
import { createLineage } from '../views/lineage.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Written } from '../steps.js' */

/** What counts as the same J in the answers: nothing that one sees of a drive. */
const same = 0.01;
const usualSigma = 1;

/** @type {Written} */
export const sigma = {
  figure: 'evolve',
  stage: { place: 'instead', pages: ['lab'], create: createLineage },
  blocks: [
    { kind: 'text', name: 'begin' },
    { kind: 'formula', formula: sigmaFormula },
    { kind: 'text', name: 'rates' },
    quiz('small', {
      shows: 'lab&evolution.initialSigma=0.01&generation=60&curve=sigmas',
      async answer({ engine, state }) {
        const { experiment, generation, history } = state;
        const usual = {
          ...experiment,
          evolution: { ...experiment.evolution, initialSigma: usualSigma },
        };
        const { cost } = await engine.surveys.evolve(usual, generation);
        const own = history[generation].best.cost;
        const right = Math.abs(own - cost) < same ? 1 : own < cost ? 0 : 2;
        const sigma = experiment.evolution.initialSigma;
        const falls = history[generation].meanSigmas.every((mean) => mean < sigma);
        return { right, own, usual: cost, generation, sigma, falls };
      },
    }),
    quiz('further', {
      shows: 'lab&generation=300&curve=sigmas',
      order: [0, 2, 1],
      answer({ state }) {
        const { history, generation } = state;
        const half = Math.floor(generation / 2);
        const [first, middle, last] = [0, half, generation].map((g) => history[g].best.cost);
        const [before, after] = [first - middle, middle - last];
        const right = after < same ? 2 : after < before / 2 ? 1 : 0;
        const sigmas = history[generation].meanSigmas.map(words.sigmaText);
        return { right, before, after, half, generation, sigmas };
      },
    }),
    { kind: 'text', name: 'collapse', after: 'further' },
    tries([
      ['stuck', 'lab&seed=7&generation=300&curve=sigmas'],
      ['none', 'lab&evolution.initialSigma=0&generation=60'],
      ['large', 'lab&evolution.initialSigma=100&generation=100&curve=sigmas'],
      ['late', 'generation&generation=300&phase=mutation&individual=0'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values: ({ engine, state }) => {
    const { own, common } = engine.learningRates();
    const { meanSigmas } = state.history[state.generation];
    const [sx, sy, st] = meanSigmas.map(words.sigmaText);
    return {
      own: fixed(own, 3),
      common: fixed(common, 3),
      generation: String(state.generation),
      sx,
      sy,
      st,
    };
  },
};
