// A recorded generation taken apart: who stands where in the ranking, who is shown, and who drives meanwhile.
/** @import { Engine, Experiment, Individual, Statistics } from '../../core/engine.js' */
/** @import { ChosenDrives } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
import { forgets, methods } from '../../core/methods.js';
import { expectedWins } from '../../core/rules.js';
import { remember } from '../../kit/memo.js';
import words from './words/index.js';
import { phasesOf } from './phases.js';
import { generationSlice, phases } from './state.js';

/** @typedef {import('../../core/engine.js').GenerationRecord} GenerationRecord */
/** What must be known of a search besides its record; `initialRange` is that of the first gains. @typedef {Pick<Experiment['evolution'], 'method' | 'initialRange' | 'step' | 'belowZero' | 'sigmaFloor'>} Settings */
/** @typedef {import('../../core/methods.js').Method} Method */
/** @typedef {import('./state.js').Phase} Phase */
/** @typedef {import('./state.js').GenerationState} GenerationState */
/** @typedef {{ survivor: number, fallen: number }} Upset One that survives though a better one fell. */

/** @typedef {Readonly<Settings> & Ranked} Anatomy */
/**
 * @typedef {object} Ranked
 * @property {GenerationRecord} record
 * @property {number} count N, as many as there are parents.
 * @property {number} columns As many as there are parents or offspring, whichever are more.
 * @property {number} staying How many survive.
 * @property {number} ranked How many are ranked: where all that was before is forgotten, only those that stay.
 * @property {number} counting How many of these count for what follows.
 * @property {Individual[]} all The parents, then the offspring: an individual's place here is its number.
 * @property {number[]} ranking All numbers, best ranked first; the survivors are its first ones.
 * @property {number[]} ranks The place in the ranking of each number, from 0.
 * @property {Upset | null} upset
 * @property {readonly number[]} expected The wins that each number had to expect; none without a tournament.
 */

/** @type {Settings} */
const papers = { method: 'ep', initialRange: [0, 1], step: 'gaussian', belowZero: 'penalty', sigmaFloor: 0 };

/** @param {GenerationRecord} record @param {Settings} [settings] @returns {Anatomy} */
export function dissect(record, settings = papers) {
  const { method } = settings;
  const all = [...record.parents, ...record.offspring];
  const costs = all.map(({ cost }) => cost);
  const { ranking, plan, opponents } = record;
  const ranks = new Array(all.length);
  for (const [place, number] of ranking.entries()) ranks[number] = place;
  const [count, born] = [record.parents.length, record.offspring.length];
  const columns = Math.max(count, born);
  const staying = record.survivors.length;
  return {
    ...settings,
    record,
    count,
    columns,
    staying,
    ranked: forgets(method) ? staying : all.length,
    counting: plan.weights.length || staying,
    all,
    ranking,
    ranks,
    upset: methods[method].upsets ? upsetOf(record, all) : null,
    expected: opponents.length > 0 ? expectedWins(costs, opponents[0].length) : [],
  };
}

/** Generation 0 has no offspring and no tournament. @param {GenerationRecord} record */
export const isInitial = (record) => record.offspring.length === 0;

/** The worst that survives and the best that falls, if the wrong way round. @param {GenerationRecord} record @param {Individual[]} all @returns {Upset | null} */
function upsetOf({ survivors }, all) {
  const stays = new Set(survivors);
  const fallen = all.map((_, number) => number).filter((number) => !stays.has(number));
  if (fallen.length === 0) return null;
  const cost = (/** @type {number} */ number) => all[number].cost;
  const worst = survivors.reduce((a, b) => (cost(b) > cost(a) ? b : a));
  const best = fallen.reduce((a, b) => (cost(b) < cost(a) ? b : a));
  return cost(worst) > cost(best) ? { survivor: worst, fallen: best } : null;
}

/**
 * The shown generation, taken apart once. While the drives of another run are on their way, both are asked for in turn.
 * @param {Engine['record']} recordOf @returns {(state: State) => Anatomy}
 */
export function createAnatomy(recordOf) {
  const of = remember(
    (/** @type {Statistics} */ { generation }, /** @type {State['experiment']} */ experiment) =>
      dissect(recordOf(generation, experiment), experiment.evolution),
    3,
  );
  return ({ history, generation, experiment }) => of(history[generation], experiment);
}

/** The next phase that the generation has. @param {Anatomy} anatomy @param {Phase} phase @returns {Phase} */
export function phaseOf(anatomy, phase) {
  const there = phasesOf(anatomy);
  return phases.slice(phases.indexOf(phase)).find((one) => there.includes(one)) ?? 'survivors';
}

/** The phase before or after one, among those that the generation has. @param {Anatomy} anatomy @param {Phase} phase @param {1 | -1} step @returns {Phase | undefined} */
export function phaseAfter(anatomy, phase, step) {
  const there = phasesOf(anatomy);
  return there[there.indexOf(phase) + step];
}

/** Whom the page is about: among the parents only a parent. @param {Anatomy} anatomy @param {GenerationState} state */
export function chosenOf(anatomy, state) {
  const { count, all, record, upset, method } = anatomy;
  const newborn = isInitial(record) ? 0 : count;
  const chosen = state.chosen ?? upset?.survivor ?? newborn + bestOf(all.slice(newborn));
  if (chosen >= all.length || phaseOf(anatomy, state.phase) === 'parents') return chosen % count;
  return forgets(method) && chosen < newborn ? chosen + count : chosen;
}

/** @param {Individual[]} individuals */
const bestOf = (individuals) =>
  individuals.reduce((best, { cost }, i) => (cost < individuals[best].cost ? i : best), 0);

/** The offspring of a parent, the parent of an offspring; where they are no pairs, the first of them. @param {Anatomy} anatomy @param {number} number */
export function partnerOf({ count, record }, number) {
  if (number < count) return count + (number < record.offspring.length ? number : 0);
  return number - count < count ? number - count : 0;
}

/** Which of the offspring it is, or which is its own. @param {Anatomy} anatomy @param {number} number */
export const trialOf = (anatomy, number) =>
  (number < anatomy.count ? partnerOf(anatomy, number) : number) - anatomy.count;

/** What drives while the page is open; null on the other pages. @param {(state: State) => Anatomy} anatomyOf */
export function createChosenDrives(anatomyOf) {
  const drives = remember(drivesOf);
  return (/** @type {State} */ state) =>
    state.page === 'generation' ? drives(anatomyOf(state), generationSlice.of(state)) : null;
}

/** @param {Anatomy} anatomy @param {GenerationState} state @returns {ChosenDrives} */
function drivesOf(anatomy, state) {
  const { all, count, record } = anatomy;
  const phase = phaseOf(anatomy, state.phase);
  const chosen = chosenOf(anatomy, state);
  // An offspring has not driven before its phase: until then it is its parent that drives.
  const undriven = phase === 'parents' || phase === 'mutation';
  const driving = undriven ? chosen % count : chosen;
  const shown = othersOf(anatomy, phase, driving);
  const others = shown.filter((number) => number !== driving);
  const isAmong = others.length < shown.length;
  const name = (/** @type {number} */ number) => words.nameOf(anatomy, number);
  const partner = partnerOf(anatomy, driving);
  return {
    name: words.drivingText(name(driving), record.generation),
    population: [driving, ...others].map((number) => all[number]),
    othersText: (drawn, arrived) =>
      words.othersText(anatomy, phase, { drawn, all: others.length, isAmong, arrived }),
    partner:
      undriven || isInitial(record) || forgets(anatomy.method)
        ? null
        : { gains: all[partner].gains, name: name(partner) },
  };
}

/** Who else drives on the plane. @param {Anatomy} anatomy @param {Phase} phase @param {number} driving */
function othersOf({ count, all, record, ranking, ranked }, phase, driving) {
  const numbers = all.map((_, number) => number);
  if (phase === 'tournament') return [...new Set(record.opponents[driving])];
  if (phase === 'survivors') return record.survivors;
  if (phase === 'ranking') return ranking.slice(0, ranked);
  return phase === 'drive' ? numbers.slice(count) : numbers.slice(0, count);
}
