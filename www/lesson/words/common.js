// What the words of the lesson are told of, in every language.

/** @import { Triple } from '../../core/engine.js' */

/** Drives by hand with different gains, and the best that arrived. @typedef {{ drives: number, best: { gains: Triple, cost: number } | null }} Drives */
/** Gains that one can beat by hand, and their J. @typedef {{ name: 'fives' | 'arbitrary' | 'ep', cost: number }} Mark */
/** How many of so many starts arrive. @typedef {{ count: number, starts: number, share: number }} Share */
/** The lowest point of a landscape, with the gain at which its axes end. @typedef {{ gains: Triple, cost: number, most: number }} Lowest */
/** How many questions there are on the path, how many have been answered, and how many of those as predicted. @typedef {{ all: number, answered: number, right: number }} Counts */
/** @typedef {'you' | 'evolution' | 'random'} Duellist */
/**
 * Who is ahead in a duel.
 * @typedef {object} Verdict
 * @property {number} seed
 * @property {number} drives Your trials.
 * @property {number} generation The one that evolution is judged by.
 * @property {number} given What each of the other two has tried by then.
 * @property {Record<Duellist, number>} costs
 * @property {Duellist | 'both'} winner
 * @property {number} longest How many trials the others go on to.
 * @property {{ evolution: number, random: number }} later What they have by then.
 * @property {number | null} passed With so many trials evolution is below your best; null: not so far.
 */
/** What the paper leaves open, as it is chosen here. @typedef {Record<'start' | 'goal' | 'speed' | 'turnRate' | 'acceleration' | 'turnAcceleration' | 'weights' | 'velocityWeights' | 'penalty' | 'position' | 'heading' | 'horizon' | 'population' | 'opponents' | 'sigma' | 'sampleTime', string> & { range: string[] }} Choices */

export {};
