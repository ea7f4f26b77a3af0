// A name for a drive: eight digits, others for other drives.
/** @import { Experiment, Triple } from '../../core/engine.js' */

/** FNV-1a, 32 bits. @param {string} text */
function hashOf(text) {
  let hash = 0x811c9dc5;
  for (const byte of new TextEncoder().encode(text)) hash = Math.imul(hash ^ byte, 0x01000193);
  return (hash >>> 0).toString(16).padStart(8, '0');
}

/** Of all that a drive follows from; how the gains were found is no part of it. @param {Experiment} experiment @param {Triple} gains */
export function fingerprintOf({ evolution: _, ...driven }, gains) {
  return hashOf(JSON.stringify([driven, [...gains]]));
}
