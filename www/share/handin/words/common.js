// Of what is handed in, what is the same in every language.
import { costText, sixDigits } from '../../../words/numbers.js';
import { mark } from '../mark.js';

/** @param {string} program @param {string} exercise */
export const head = (program, exercise) => `${mark} · ${program} · ${exercise}`;

/** All digits. @param {readonly number[]} gains */
export const gainsLine = (gains) => `kx = ${gains[0]}, ky = ${gains[1]}, kθ = ${gains[2]}`;

/** J beside the one that it has to be below, with as many digits as show on which side it is. @param {number} cost @param {number} limit */
export const costBeside = (cost, limit) =>
  [costText, sixDigits].map((write) => write(cost)).find((text) => Number(text) < limit === cost < limit) ??
  String(cost);

/** @param {number} cost */
export const costLine = (cost) => `J = ${Number.isFinite(cost) ? cost : '∞'}`;

/** @param {string} who */
export const fileName = (who) =>
  `hand-in-${who.replace(/[^\p{L}\p{N}_-]+/gu, '-').slice(0, 40) || 'nobody'}.txt`;
