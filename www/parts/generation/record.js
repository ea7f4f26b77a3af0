// A recorded generation taken apart: who stands where in the ranking, who is shown, and who drives meanwhile.
/** @import { Individual, Statistics } from '../../core/engine.js' */
/** @import { ChosenDrives } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
import { generationSlice, isOtherSearch, phases } from './state.js';
import { remember } from '../../kit/memo.js';
import words from './words/index.js';

/** @typedef {import('../../core/engine.js').GenerationRecord} GenerationRecord */
/** @typedef {import('./state.js').GenerationState} GenerationState */
/** @typedef {import('./state.js').Phase} Phase */
/** @typedef {{ survivor: number, fallen: number }} Upset One that survives though a better one fell. */

/**
 * @typedef {object} Anatomy
 * @property {GenerationRecord} record
 * @property {number} count N, as many as there are parents.
 * @property {number} columns As many as there are parents or offspring, whichever are more.
 * @property {number} staying How many survive.
 * @property {Individual[]} all The parents, then the offspring: an individual's place here is its number.
 * @property {number[]} ranking All numbers, best ranked first; the survivors are its first ones.
 * @property {number[]} ranks The place in the ranking of each number, from 0.
 * @property {Upset | null} upset
 */

/** @param {GenerationRecord} record @returns {Anatomy} */
export function dissect(record) {
  const all = [...record.parents, ...record.offspring];
  const { ranking } = record;
  const ranks = new Array(all.length);
  for (const [place, number] of ranking.entries()) ranks[number] = place;
  const [count, born] = [record.parents.length, record.offspring.length];
  const columns = Math.max(count, born);
  const staying = record.survivors.length;
  return { record, count, columns, staying, all, ranking, ranks, upset: upsetOf(record, all) };
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

/** The shown generation, taken apart once. @param {(generation: number) => GenerationRecord} recordOf @returns {(state: State) => Anatomy} */
export function createAnatomy(recordOf) {
  const of = remember((/** @type {Statistics} */ { generation }) => dissect(recordOf(generation)));
  return ({ history, generation }) => of(history[generation]);
}

/** What a generation goes through: generation 0 nothing, and each method of search only what it has. @param {GenerationRecord} record @returns {readonly Phase[]} */
export function phasesOf(record) {
  if (isInitial(record)) return ['parents', 'survivors'];
  if (isOtherSearch(record)) return ['parents', 'drive', 'survivors'];
  return record.opponents.length > 0 ? phases : phases.filter((phase) => phase !== 'tournament');
}

/** The next phase that the generation has. @param {Pick<Anatomy, 'record'>} anatomy @param {Phase} phase @returns {Phase} */
export function phaseOf({ record }, phase) {
  const there = phasesOf(record);
  if (there.includes(phase)) return phase;
  if (isInitial(record)) return 'parents';
  return phases.slice(phases.indexOf(phase)).find((one) => there.includes(one)) ?? 'survivors';
}

/** The phase before or after one, among those that the generation has. @param {Anatomy} anatomy @param {Phase} phase @param {1 | -1} step @returns {Phase | undefined} */
export function phaseAfter({ record }, phase, step) {
  const there = phasesOf(record);
  return there[there.indexOf(phase) + step];
}

/** Whom the page is about: among the parents only a parent. @param {Anatomy} anatomy @param {GenerationState} state */
export function chosenOf(anatomy, state) {
  const { count, all, record, upset } = anatomy;
  const newborn = isInitial(record) ? 0 : count;
  const chosen = state.chosen ?? upset?.survivor ?? newborn + bestOf(all.slice(newborn));
  return chosen >= all.length || phaseOf(anatomy, state.phase) === 'parents' ? chosen % count : chosen;
}

/** @param {Individual[]} individuals */
const bestOf = (individuals) =>
  individuals.reduce((best, { cost }, i) => (cost < individuals[best].cost ? i : best), 0);

/** The offspring of a parent, the parent of an offspring; where they are no pairs, the first of them. @param {Anatomy} anatomy @param {number} number */
export function partnerOf({ count, record }, number) {
  if (number < count) return count + (number < record.offspring.length ? number : 0);
  return number - count < count ? number - count : 0;
}

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
  const others = othersOf(anatomy, phase, driving).filter((number) => number !== driving);
  const name = (/** @type {number} */ number) => words.nameOf(anatomy, number);
  const partner = partnerOf(anatomy, driving);
  return {
    name: words.drivingText(name(driving), record.generation),
    population: [driving, ...others].map((number) => all[number]),
    othersText: (shown, arrived) => words.othersText(phase, shown, others.length, arrived),
    partner: undriven || isInitial(record) ? null : { gains: all[partner].gains, name: name(partner) },
  };
}

/** Who else drives on the plane. @param {Anatomy} anatomy @param {Phase} phase @param {number} driving */
function othersOf({ count, all, record, ranking }, phase, driving) {
  const numbers = all.map((_, number) => number);
  if (phase === 'tournament') return [...new Set(record.opponents[driving])];
  if (phase === 'survivors') return record.survivors;
  if (phase === 'ranking') return ranking;
  return phase === 'drive' ? numbers.slice(count) : numbers.slice(0, count);
}
