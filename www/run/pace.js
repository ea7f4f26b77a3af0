// How fast evolution goes on, and where it pauses.
/** @import { Statistics } from '../core/engine.js' */
/** @import { State } from './state.js' */

/** Where evolution pauses by itself. By default at every so many generations, so that a forgotten page comes to rest. @typedef {{ kind: 'every' | 'generation' | 'cost', value: number }} Until */

/** @type {Until} */
export const usualUntil = { kind: 'every', value: 100 };
/** The last generation that a link can say. */
export const lastGeneration = 100_000;
/** The pace at which each phase of a generation is shown. */
const phaseByPhase = 0;
export const paces = [phaseByPhase, 1, 8, 60, Number.POSITIVE_INFINITY];

/** Whether evolution runs as a play of phases. @param {State} state */
export const playsPhases = ({ evolving, catchingUp, pace }) =>
  evolving && !catchingUp && pace === phaseByPhase;

/** The next generation at which it usually pauses. @param {number} generation */
export const nextRest = (generation) => usualUntil.value * (Math.floor(generation / usualUntil.value) + 1);

/** Whether what it is to go on to is there. @param {Until} until @param {Statistics} statistics */
export const isReached = ({ kind, value }, { generation, best }) =>
  kind === 'cost' ? best.cost < value : kind === 'generation' && generation >= value;

/** Whether evolution is to pause at this generation; what has no end pauses where a link and a file can still say it. @param {Until} until @param {Statistics} statistics */
export const pausesAt = ({ kind, value }, { generation, best }) =>
  kind === 'cost'
    ? best.cost < value || generation % lastGeneration === 0
    : kind === 'generation'
      ? generation === value
      : generation % value === 0;

/** What has been reached is no end: from there on evolution pauses as it usually does. @param {Pick<State, 'until' | 'computing' | 'history' | 'generation'>} state */
export const untilAhead = ({ until, computing, history, generation }) =>
  !computing?.next && isReached(until, history[generation]) ? { until: usualUntil, untilError: '' } : {};
