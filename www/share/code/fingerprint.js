// A name for a drive: eight digits, others for other drives.
/** @import { Experiment, Triple } from '../../core/engine.js' */
import { digitsOf } from '../../kit/hash.js';

/** Of all that a drive follows from; how the gains were found is no part of it. @param {Experiment} experiment @param {Triple} gains */
export function fingerprintOf({ evolution: _, ...driven }, gains) {
  return digitsOf(JSON.stringify([driven, [...gains]]));
}
