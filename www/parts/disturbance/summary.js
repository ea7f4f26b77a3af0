// What is told of a measurement: for each part of the error, how much remains and where that lies beside its set.
/** @import { Experiment } from '../../core/engine.js' */
/** @import { Measured } from './request.js' */
import { median } from 'd3-array';
import { edgePercent } from './numbers.js';

/** @typedef {typeof parts[number]} PartName */
/** The largest of the last seconds: of the drive, and of the other starts. @typedef {{ drive: number, median: number, largest: number }} Sizes */
/** @typedef {'inside' | 'edge' | 'outside'} Place */
/**
 * How far the set of the drive reaches, where the drive lies beside it (null: nothing pushes against it), and how many others
 * lie inside and on the edge of their own: the set of y changes with θ.
 * @typedef {Sizes & { set: number, place: Place | null, inside: number, edge: number }} Row
 */
/**
 * @typedef {object} Summary
 * @property {Record<PartName, Row>} rows
 * @property {Record<PartName, Sizes>} calm The same without the disturbance.
 * @property {PartName} worst Of which part most remains then, in metres.
 * @property {number} starts How many others there are.
 * @property {PartName[]} pushed Against which parts something pushes: only of these there is a set that is more than 0.
 * @property {number} allInside How many of the others stay inside all of these sets.
 * @property {number} allEdge How many come to the edge of one or more, and leave none.
 * @property {boolean} disturbed
 * @property {number} seconds
 * @property {number} horizon
 * @property {number} samples Of each drive.
 * @property {string} law
 * @property {boolean} isPositive Whether the theorem speaks of these gains.
 * @property {number} ky
 */

export const parts = /** @type {const} */ (['x', 'y', 'theta']);

/** @param {number} error @param {number} set @returns {Place} */
export function placeOf(error, set) {
  // What is no number is nowhere inside.
  if (!(error <= set * (1 + edgePercent / 100))) return 'outside';
  return error > set * (1 - edgePercent / 100) ? 'edge' : 'inside';
}

/** The first start is that of the drive. @param {Float64Array} errors @returns {Sizes} */
const sizesOf = (errors) => {
  const others = errors.subarray(1);
  return { drive: errors[0], median: median(others) ?? 0, largest: Math.max(...others) };
};

/** Whether Theorem 2 speaks of them. @param {readonly number[]} gains */
export const arePositive = (gains) => gains.every((gain) => gain > 0);

/** The bound on the speed stands in (6) and (7), that on the turn rate in (8). @param {Experiment['disturbance']} disturbance @returns {PartName[]} */
const pushedOf = ({ kind, linear, angular }) =>
  parts.filter((part) => kind !== 'none' && (part === 'theta' ? angular : linear) !== 0);

/** Whether the experiment has a disturbance of its own, of another kind or size than what is tried. @param {Experiment['disturbance']} own @param {Experiment['disturbance']} tried */
export const hasAnother = (own, tried) =>
  pushedOf(own).length > 0 &&
  (own.kind !== tried.kind || own.linear !== tried.linear || own.angular !== tried.angular);

/** @param {Measured} measured @returns {Summary} */
export function summarize({ spec, disturbed, calm }) {
  const others = Array.from({ length: disturbed.error.x.length - 1 }, (_, i) => i + 1);
  const { disturbance, horizon, sampleTime, law } = spec.experiment;
  const pushed = pushedOf(disturbance);
  const places = ofEach((part) =>
    Array.from(disturbed.error[part], (error, start) => placeOf(error, disturbed.sets[part][start])),
  );
  /** @param {PartName} part @param {Place} place */
  const countOf = (part, place) => others.filter((start) => places[part][start] === place).length;
  /** @param {PartName} part @returns {Row} */
  const rowOf = (part) => ({
    ...sizesOf(disturbed.error[part]),
    set: disturbed.sets[part][0],
    place: pushed.includes(part) ? places[part][0] : null,
    inside: countOf(part, 'inside'),
    edge: countOf(part, 'edge'),
  });
  const leavesNone = others.filter((start) => pushed.every((part) => places[part][start] !== 'outside'));
  const allInside = leavesNone.filter((start) => pushed.every((part) => places[part][start] === 'inside'));
  const calmSizes = ofEach((part) => sizesOf(calm.error[part]));
  return {
    rows: ofEach(rowOf),
    calm: calmSizes,
    worst: calmSizes.y.largest >= calmSizes.x.largest ? 'y' : 'x',
    starts: others.length,
    pushed,
    allInside: allInside.length,
    allEdge: leavesNone.length - allInside.length,
    disturbed: pushed.length > 0,
    seconds: spec.seconds,
    horizon,
    samples: Math.round(horizon / sampleTime),
    law,
    isPositive: arePositive(spec.gains),
    ky: spec.gains[1],
  };
}

/** @template T @param {(part: PartName) => T} give @returns {Record<PartName, T>} */
const ofEach = (give) => ({ x: give('x'), y: give('y'), theta: give('theta') });
