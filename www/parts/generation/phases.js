// What a generation of each method goes through, and what its pictures show: how high each J is, or where the gains lie.
/** @import { GenerationRecord } from '../../core/engine.js' */
/** @import { Method } from '../../core/methods.js' */
/** @import { Phase } from './state.js' */
import { phases } from './state.js';

/** @typedef {'costs' | 'gains'} Shown */

/** From point to point. */
const walk = /** @type {const} */ ({
  parents: 'gains',
  mutation: 'gains',
  drive: 'costs',
  survivors: 'gains',
});

/** In the order of the phases. @type {Readonly<Record<Method, Readonly<Partial<Record<Phase, Shown>>>>>} */
const courses = {
  ep: {
    parents: 'costs',
    mutation: 'costs',
    drive: 'costs',
    tournament: 'costs',
    ranking: 'costs',
    survivors: 'costs',
  },
  random: { parents: 'gains', mutation: 'gains', drive: 'costs', survivors: 'costs' },
  de: { parents: 'costs', mutation: 'gains', drive: 'costs', survivors: 'costs' },
  'cma-es': { parents: 'gains', mutation: 'gains', drive: 'costs', ranking: 'costs', survivors: 'gains' },
  'one-plus-one-es': walk,
  'nelder-mead': walk,
  'one-at-a-time': walk,
  'finite-differences': walk,
};

/** All that a method may have. @param {Method} method */
export const phasesOfMethod = (method) => phases.filter((phase) => courses[method][phase]);

/** @param {Method} method @param {Phase} phase @returns {Shown} */
export const shownIn = (method, phase) => courses[method][phase] ?? 'costs';

/** Generation 0 goes through nothing, and without a tournament there is none. @param {{ method: Method, record: Pick<GenerationRecord, 'offspring' | 'opponents'> }} anatomy @returns {readonly Phase[]} */
export function phasesOf({ method, record }) {
  if (record.offspring.length === 0) return ['parents', 'survivors'];
  const all = phasesOfMethod(method);
  return record.opponents.length > 0 ? all : all.filter((phase) => phase !== 'tournament');
}
