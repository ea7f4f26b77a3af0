// One generation by hand.
import { remember } from '../../kit/memo.js';
import { chosenOf, dissect } from '../../parts/generation/record.js';
import { generationSlice } from '../../parts/generation/state.js';
import words from '../../parts/generation/words/index.js';
import lesson from '../words/index.js';
import { anatomyOf, placeByCost } from '../anatomy.js';
import { isSame } from '../aside.js';
import { gainFormula } from '../formulas/formulas.js';
import { createNewborn } from '../views/newborn.js';
import { quiz, tries } from '../questions/asks.js';

/** @import { Engine, Experiment } from '../../core/engine.js' */
/** @import { Anatomy } from '../../parts/generation/record.js' */
/** @import { Written } from '../steps.js' */

/** The two whose fates the first question is about: offspring 11 and 9 of generation 1. The figure names another such pair. */
export const question = { better: 30, worse: 28 };

/** @type {Written} */
export const generation = {
  figure: 'evolve',
  stage: { place: 'instead', pages: ['generation'], create: createNewborn },
  blocks: [
    { kind: 'text', name: 'begin' },
    { kind: 'text', name: 'mutate' },
    { kind: 'formula', formula: gainFormula },
    { kind: 'text', name: 'drive' },
    { kind: 'text', name: 'rule' },
    quiz('luck', {
      shows: 'generation&generation=1&phase=ranking&individual=30',
      sight: 'part',
      order: [1, 0, 3, 2],
      answer(live) {
        const anatomy = anatomyOf(live);
        const fate = (/** @type {number} */ number) => ({
          stays: anatomy.record.survivors.includes(number),
          cost: anatomy.all[number].cost,
          wins: anatomy.record.wins[number],
          place: placeByCost(anatomy, number),
        });
        const [better, worse] = [fate(question.better), fate(question.worse)];
        const right = better.stays ? (worse.stays ? 2 : 0) : worse.stays ? 1 : 3;
        return { right, better, worse, bouts: anatomy.record.opponents[0].length };
      },
    }),
    { kind: 'text', name: 'select', after: 'luck' },
    quiz('best', {
      shows: 'lab&generation=60',
      order: [0, 2, 1],
      answer({ state }) {
        const costs = state.history.slice(0, state.generation + 1).map(({ best }) => best.cost);
        const steps = costs.slice(1).map((cost, i) => cost - costs[i]);
        const rose = steps.filter((step) => step > 0).length;
        const fell = steps.filter((step) => step < 0).length;
        return { right: rose > 0 ? 0 : 2, rose, fell, generations: state.generation };
      },
    }),
    tries([
      ['lucky', 'generation&seed=3&generation=1&phase=tournament&individual=12', 'part'],
      ['below', 'generation&generation=1&phase=drive&individual=34', 'part'],
      ['bouts', 'generation&opponents=200&generation=1&phase=survivors', 'part'],
      ['late', 'generation&generation=60&phase=drive'],
    ]),
    { kind: 'notice' },
    { kind: 'text', name: 'next' },
  ],
  values: (live) => {
    const { engine, state } = live;
    const shown = anatomyOf(live);
    const papers = () => papersGeneration(engine, state.experiment);
    const born = shown.record.mutations.length > 0 ? shown : papers();
    const met = shown.record.opponents.length > 0 ? shown : papers();
    const chosenOfAll = (/** @type {Anatomy} */ anatomy) =>
      chosenOf(anatomy, { ...generationSlice.of(state), phase: 'survivors' });
    const pair = chosenOfAll(born) % born.count;
    const chosen = chosenOfAll(met);
    const nameIn = (/** @type {Anatomy} */ anatomy, /** @type {number} */ number) =>
      words.capital(words.nameOf(anatomy, number));
    const cost = words.costWriter(born);
    const { parents, offspring } = born.record;
    const [low, high] = state.experiment.evolution.initialRange;
    return {
      count: String(state.experiment.evolution.population),
      low: String(low),
      high: String(high),
      child: nameIn(born, pair + born.count),
      childCost: cost(offspring[pair].cost),
      parentCost: cost(parents[pair].cost),
      better: String(offspring.filter((one, i) => one.cost < parents[i].cost).length),
      all: String(met.all.length),
      bouts: String(met.record.opponents[chosen].length),
      chosen: nameIn(met, chosen),
      wins: String(met.record.wins[chosen]),
      fate: lesson.steps.generation.fate(words.nameOf(met, chosen), words.fateText(met, chosen)),
    };
  },
};

/** Generation 1 of the same run made as in the paper, of which is told what the figure does not have: births, or bouts. */
const papersGeneration = remember((/** @type {Engine} */ engine, /** @type {Experiment} */ experiment) => {
  const { method, selection } = engine.experiment('velocity-limits').evolution;
  const papers = { ...experiment, evolution: { ...experiment.evolution, method, selection } };
  const own = isSame(papers, experiment) ? experiment : papers;
  return dissect(engine.record(1, own), own.evolution);
});
