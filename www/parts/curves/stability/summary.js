// What a run makes of V, as facts for whole sentences.
/** @import { Experiment, Stability, Triple } from '../../../core/engine.js' */
import { largest } from '../../../kit/extent.js';

/** @typedef {'limits' | 'disturbance' | 'sampling'} Cause Why V rises though its promised rate is not above zero. */
/**
 * @typedef {object} Summary
 * @property {Experiment['law']} law
 * @property {boolean} isPromised
 * @property {number} referenceSpeed v_r
 * @property {number} from V at the start.
 * @property {number} to V in the end.
 * @property {number} rising Seconds.
 * @property {number} limited Seconds.
 * @property {boolean} isLaw Whether without limits and disturbances V changes as the law promises: where it would divide by 0 it is guarded, and promises nothing.
 * @property {number} seconds All of them.
 * @property {boolean} disturbed
 * @property {number[]} raised The parts that are above zero: 0, 1, 2 for x_e, y_e, θ_e.
 * @property {number[]} negative The gains that are below zero.
 * @property {Cause[]} causes Those of a good part of the rises.
 * @property {number} sampleTime
 */

/** Rounding is no rise. */
const least = 1e-9;
/** What is as near is the same. */
const close = 1e-6;
/** Of the seconds that V rises; less is not worth a sentence. */
const goodPart = 0.1;

/** Whether V is higher at the next sample. @param {Stability} stability @returns {(i: number) => boolean} */
export function risesOf({ lyapunov }) {
  const most = lyapunov.reduce((a, b) => (b > a ? b : a), 0);
  const step = Number.isFinite(most) ? least * most : 0;
  return (i) => lyapunov[i + 1] - lyapunov[i] > step;
}

const causes = /** @type {const} */ (['limits', 'disturbance', 'sampling']);

/** @param {Stability} stability @param {Experiment} experiment @param {Triple} gains @returns {Summary} */
export function summaryOf(stability, { law, referenceVelocity, disturbance, sampleTime }, gains) {
  const { time, lyapunov, rate, limited, headingWeight } = stability;
  const parts = [stability.promisedX, stability.promisedY, stability.promisedTheta];
  const isRising = risesOf(stability);
  const disturbed = disturbance.kind !== 'none';
  /** Seconds. @type {Record<Cause, number>} */
  const risingBy = { limits: 0, disturbance: 0, sampling: 0 };
  let [rising, cut, isLaw] = [0, 0, true];
  for (let i = 0; i + 1 < time.length; i += 1) {
    const seconds = time[i + 1] - time[i];
    const promised = parts.reduce((sum, values) => sum + values[i], 0);
    if (limited[i]) cut += seconds;
    else if (Math.abs(rate[i] - promised) > close * (1 + Math.abs(promised))) isLaw = false;
    if (!isRising(i)) continue;
    rising += seconds;
    if (promised > 0) continue;
    if (rate[i] <= 0) risingBy.sampling += seconds;
    else {
      if (limited[i]) risingBy.limits += seconds;
      if (disturbed) risingBy.disturbance += seconds;
    }
  }
  const last = time.length - 1;
  return {
    law,
    isPromised: headingWeight !== null,
    referenceSpeed: referenceVelocity.linear,
    from: lyapunov[0],
    to: lyapunov[last],
    rising,
    limited: cut,
    isLaw,
    seconds: time[last],
    disturbed,
    raised: [0, 1, 2].filter((part) => largest(parts[part]) > 0),
    negative: [0, 1, 2].filter((gain) => gains[gain] < 0),
    causes: causes.filter((cause) => risingBy[cause] > goodPart * rising),
    sampleTime,
  };
}
