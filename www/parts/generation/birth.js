// How an offspring of evolutionary programming came to be: what its mutation began with, and what that came to before it was
// held at 0, mirrored there, or kept from falling too low.
/** @import { GenerationRecord, Individual } from '../../core/engine.js' */

/** @typedef {GenerationRecord['mutations'][number]} Mutation */
/** @typedef {{ own: number, common: number }} Rates */
/** `other`: the number of the parent with which it was crossed; `base`: what came of that, else the parent. @typedef {{ parent: Individual, other: number | null, base: Individual, child: Individual, draws: Mutation }} Birth */

/** τ and τ′ as an experiment has them: the paper's, times its factor. @param {Rates} rates @param {number} adaptation @returns {Rates} */
export const ratesOf = ({ own, common }, adaptation) => ({
  own: adaptation * own,
  common: adaptation * common,
});

/** Null in generation 0, which has no births, and in other searches, which draw in other ways. @param {{ record: GenerationRecord }} anatomy @param {number} pair @returns {Birth | null} */
export function birthOf({ record: { parents, offspring, mutations, donors, bases } }, pair) {
  if (mutations.length === 0) return null;
  const [parent, child, draws] = [parents[pair], offspring[pair], mutations[pair]];
  return { parent, other: donors[pair]?.[0] ?? null, base: bases[pair] ?? parent, child, draws };
}

/** kᵢ + σᵢ Nᵢ @param {Birth} birth @param {number} i */
export const movedGain = ({ base, draws }, i) => base.gains[i] + base.sigmas[i] * draws.gains[i];

/** σᵢ e^(τ′N + τNᵢ′): the offspring's own unless that was raised, for no two exponentials have the same last bit. @param {Birth} birth @param {number} i @param {Rates} rates */
export function grownSigma({ base, child, draws }, i, { own, common }) {
  const grown = base.sigmas[i] * Math.exp(common * draws.common + own * draws.sigmas[i]);
  return child.sigmas[i] > grown * (1 + 1e-9) ? grown : child.sigmas[i];
}
