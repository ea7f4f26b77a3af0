// What Park says once something has been tried.
/** @import { Bred } from '../../state.js' */
/** @import { Model } from '../../sight.js' */
/** @import { Missed } from '../told.js' */
import { fixed, grouped } from '../../../../words/en/numbers.js';

/** @param {Pick<Model, 'best' | 'count'>} model @param {Pick<Bred, 'parked' | 'generation'>} found @param {boolean} isDone Else somebody has stopped it. @param {boolean} [isFurther] The best by hand was on no slider before. */
export function ending({ best, count }, { parked, generation }, isDone, isFurther = false) {
  if (!isDone) return `You stopped evolution at generation ${generation}: ${parked} of ${count}.`;
  if (best && parked <= best.parked && isFurther)
    return `Evolution parks ${parked} of ${count}; you park ${best.parked}, now that your slider goes as far.`;
  if (best && parked <= best.parked)
    return `Evolution ended at ${parked} of ${count}; you had ${best.parked}. That was luck, good or bad: try another seed.`;
  const after = `After ${generation} ${generation === 1 ? 'generation' : 'generations'}`;
  return parked === count
    ? `${after} one robot parks from all ${count} starts. Nobody told evolution how: all it knew of a robot was its mean cost J.`
    : `${after} evolution parks ${parked} of ${count}.`;
}

/** Where evolution has gone beyond the slider, and where that ends now. @param {number} before @param {number} ky @param {number} now */
export const beyond = (before, ky, now) =>
  `Your slider for ky ended at ${before}, evolution went to ${fixed(ky, 0)}. Now yours goes to ${now}: try.`;

/** @param {Bred} newest */
export const climb = ({ generation, parked, drives }) =>
  `Best of generation ${generation}: ${parked} parked · ${grouped(drives)} drives`;
/** At its upper end. @param {number} count */
export const climbAxis = (count) => `${count} parked`;
/** @param {number} parked */
export const yoursParked = (parked) => `yours ${parked}`;

/** @param {number} parked */
export const youParked = (parked) => `You parked ${parked}.`;

export const parkedColumn = 'parked';
export const bestByHand = 'yours';
export const evolved = 'evolution’s';
export const sliders = 'the sliders: yours';
/** What moves along the sliders. @param {boolean} isWalking */
export const marks = (isWalking) => (isWalking ? 'in between' : 'evolution’s best');
/** @param {number} value */
export const gain = (value) => fixed(value, 1);
/** @param {number} parked @param {number} count */
export const share = (parked, count) => `${parked} of ${count}`;

export const walk = 'From your numbers to evolution’s';
/** @param {number} percent */
export const walked = (percent) => `${percent} % of the way to evolution’s`;
/** @param {readonly string[]} gains @param {number} parked @param {number} count */
export const walkedTo = (gains, parked, count) => `${gains.join(', ')}: ${parked} of ${count} parked`;

/** @param {number} robot @param {number} count @param {number} seconds */
export const parkedAfter = (robot, count, seconds) =>
  `Robot ${robot} of ${count} parked after ${fixed(seconds, 1)} s.`;
/** @param {number} robot @param {number} count @param {Missed} missed */
export function missed(robot, count, { seconds, ahead, aside, degrees, gain: name, asks }) {
  const off = [
    ahead && `${fixed(Math.abs(ahead), 2)} m ${ahead > 0 ? 'short' : 'too far'}`,
    aside && `${fixed(Math.abs(aside), 2)} m to the side`,
    degrees && `turned by ${fixed(Math.abs(degrees), 1)}°`,
  ];
  const asked = asks.map(({ value, unit }) => `${fixed(value, 3)} ${unit}`).join(' and ');
  return `Robot ${robot} of ${count} missed. After ${fixed(seconds, 0)} s it is ${off.filter(Boolean).join(', ')}; against that, ${name} asks for ${asked} there.`;
}
export const watchThis = 'Watch this one in the lab';
export const previous = 'The robot before';
export const next = 'The next robot';
export const close = 'Close';
