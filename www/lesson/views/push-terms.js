// What each term of the law (5) adds to v and to ω: at one moment, and over a whole drive.
import { lawTerms } from '../../core/rules.js';

/** @import { Experiment, Sample, Samples, Triple } from '../../core/engine.js' */
/** @typedef {'linear' | 'angular'} Side */
/** The values of a term, or of what is asked for in all, by the name that lights it up. @typedef {{ term: string, values: readonly number[] }} Curve */
/** @typedef {{ asked: Curve, terms: Curve[], limit: number | null }} Half */
/** At each of these times, in seconds. @typedef {{ times: readonly number[] } & Record<Side, Half>} Pushes */

/** How far a bar reaches to each side, m/s and rad/s, twice the paper's limits: the same for every drive, so that drives can be compared. */
export const reach = /** @type {const} */ ({ linear: 4, angular: 4 * Math.PI });

/** Each term of (5) by its gain, and what the goal's own motion adds to them. @param {Experiment} experiment @param {Triple} gains @param {Sample['error']} error */
export function pushesOf(experiment, gains, error) {
  const { kx, ky, ktheta, reference } = lawTerms(experiment, gains, error).command;
  return {
    linear: { kx: kx.linear, ky: ky.linear },
    angular: { kt: ktheta.angular, ky: ky.angular, kx: kx.angular },
    reference,
  };
}

/** How much is asked for, both velocities as shares of what the bars have room for. @param {Sample} sample */
const askedAt = ({ command: { linear, angular } }) =>
  Math.abs(linear) / reach.linear + Math.abs(angular) / reach.angular;

/** The sample at which the law asks for most; the last has decided nothing. @param {readonly Sample[]} samples */
const mostAsked = (samples) => samples.reduce((most, one) => (askedAt(one) > askedAt(most) ? one : most));

/** When the pushes are largest. @param {Samples} samples */
export const largestAt = (samples) => mostAsked(decided(samples)).time;

/** @param {Samples} samples */
const decided = (samples) => samples.map((one) => one).slice(0, Math.max(1, samples.length - 1));

/** More moments than this cannot be told apart, and would take too long. */
const mostMoments = 300;

/** All samples, or of each stretch the one in which the most is asked for: no push is lost that is soon over. @param {Samples} samples */
function momentsOf(samples) {
  const all = decided(samples);
  const stretch = Math.ceil(all.length / mostMoments);
  return Array.from({ length: Math.ceil(all.length / stretch) }, (_, i) =>
    mostAsked(all.slice(i * stretch, (i + 1) * stretch)),
  );
}

/** All that pushes in a drive; of another law only what it asks for. @param {Samples} samples @param {Experiment} experiment @param {Triple} gains @returns {Pushes} */
export function pushesOver(samples, experiment, gains) {
  const moments = momentsOf(samples);
  const isOurs = experiment.law === 'shim-kim';
  const { linear, angular } = experiment.referenceVelocity;
  const isMoving = linear !== 0 || angular !== 0;
  const pushes = isOurs ? moments.map(({ error }) => pushesOf(experiment, gains, error)) : [];
  /** @param {Side} side @param {string} term @param {number | null} limit @returns {Half} */
  const half = (side, term, limit) => ({
    asked: { term, values: moments.map(({ command }) => command[side]) },
    terms: [
      ...Object.keys(pushes[0]?.[side] ?? {}).map((name) => ({
        term: name,
        values: pushes.map((one) => /** @type {Record<string, number>} */ (one[side])[name]),
      })),
      ...(isOurs && isMoving
        ? [{ term: 'moving', values: pushes.map(({ reference }) => reference[side]) }]
        : []),
    ],
    limit,
  });
  const { speed, turnRate } = experiment.limits;
  return {
    times: moments.map(({ time }) => time),
    linear: half('linear', 'v', speed),
    angular: half('angular', 'w', turnRate),
  };
}
