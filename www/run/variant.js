// An exercise of one's own: what differs from student to student is drawn from the student's number, and is the same for who
// checks. docs/exercises.md tells the rule.
/** @import { Experiment, Posture } from '../core/engine.js' */
/** @import { Prepared } from './prepared.js' */
/** @import { State } from './state.js' */
import { fnv1a, spread } from '../kit/hash.js';

/** @typedef {typeof variedNames[number]} Varied */
/** Who works on an exercise: the name or number; the exercise's own experiment, before anything is drawn for that name, and what drives in it, null where nothing is asked; the receipt that was opened, if one was, and a digest of the link beside it; what the link says that was driven before; and `begun` and `made`, since when and how many drives, where the page was loaded again. @typedef {{ who: string, base: (Pick<State, 'experiment' | 'preset'> & { prepared: Prepared }) | null, handin: string, of: string, spent: number, begun?: number, made?: number }} Student */

export const variedNames = /** @type {const} */ (['goal', 'starts', 'seed']);

/** @type {Student} */
export const nobody = Object.freeze({ who: '', base: null, handin: '', of: '', spent: 0 });

export const mostOfWho = 80;

/** How far a posture is moved at most: in centimetres along x and y, and in degrees. */
const farthest = { place: 25, heading: 15 };

/** As two people would write the same number. @param {string} who */
const plain = (who) => who.normalize('NFKC').replace(/\s+/g, ' ').trim().toLowerCase();

/** 32 random bits for one thing. @param {string} what @param {string} who */
const bits = (what, who) => spread(fnv1a(`${what}/${plain(who)}`));

/** A whole number from −most to most. @param {string} what @param {string} who @param {number} most */
const whole = (what, who, most) => (bits(what, who) % (2 * most + 1)) - most;

/** Moved, to whole centimetres. @param {number} metres @param {number} by */
const moved = (metres, by) => Math.round(100 * metres + by) / 100;

/** @param {Posture} posture @param {string} what @param {string} who @param {number} turn Degrees at most. @returns {Posture} */
function around({ x, y, theta }, what, who, turn) {
  const by = (/** @type {string} */ field, /** @type {number} */ most) =>
    whole(`${what}.${field}`, who, most);
  return {
    x: moved(x, by('x', farthest.place)),
    y: moved(y, by('y', farthest.place)),
    theta: turn > 0 ? theta + (by('theta', turn) * Math.PI) / 180 : theta,
  };
}

/** The experiment of one student; of nobody's nothing is drawn. @param {Experiment} experiment @param {readonly Varied[]} vary @param {string} who @returns {Experiment} */
export function drawnFor(experiment, vary, who) {
  if (vary.length === 0 || who === '') return experiment;
  const { goal, starts, evolution } = experiment;
  return {
    ...experiment,
    ...(vary.includes('goal') && { goal: around(goal, 'goal', who, 0) }),
    ...(vary.includes('starts') && {
      starts: starts.map((start, i) => around(start, `start ${i + 1}`, who, farthest.heading)),
    }),
    ...(vary.includes('seed') && { evolution: { ...evolution, seed: bits('seed', who) } }),
  };
}

/** What a variant may differ in. @param {Experiment} experiment @param {readonly Varied[]} vary */
const variedOf = ({ goal, starts, evolution }, vary) =>
  JSON.stringify(vary.map((name) => ({ goal, starts, seed: evolution.seed })[name]));

/** The experiment before anything was drawn, if it still has what was; else null. @param {Experiment} experiment @param {readonly Varied[]} vary @param {Student} student @returns {Experiment | null} */
export function undrawn(experiment, vary, { who, base }) {
  if (vary.length === 0 || who === '' || !base) return experiment;
  if (variedOf(drawnFor(base.experiment, vary, who), vary) !== variedOf(experiment, vary)) return null;
  const { goal, starts, evolution } = base.experiment;
  return {
    ...experiment,
    ...(vary.includes('goal') && { goal }),
    ...(vary.includes('starts') && { starts }),
    ...(vary.includes('seed') && { evolution: { ...experiment.evolution, seed: evolution.seed } }),
  };
}
