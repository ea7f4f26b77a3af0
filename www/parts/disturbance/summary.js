// What is told of a measurement: for each part of the error, how much remains and whether that lies in its set.
/** @import { Measured } from './request.js' */
import { median } from 'd3-array';
import { typed } from '../../words/numbers.js';

/** @typedef {typeof parts[number]} PartName */
/** The largest of the last seconds: of the drive, and of the other starts. @typedef {{ drive: number, median: number, largest: number }} Sizes */
/** How far the set of the drive reaches, and how many others stay within that of their own: the set of y changes with θ. @typedef {Sizes & { set: number, isInside: boolean, inside: number }} Row */
/**
 * @typedef {object} Summary
 * @property {Record<PartName, Row>} rows
 * @property {Record<PartName, Sizes>} calm The same without the disturbance.
 * @property {PartName} worst Of which part most remains then, in metres.
 * @property {number} starts How many others there are.
 * @property {number} allInside How many of them stay inside all three sets.
 * @property {boolean} disturbed
 * @property {number} seconds
 * @property {number} horizon
 * @property {string} law
 * @property {boolean} isPositive Whether the theorem speaks of these gains.
 * @property {number} ky
 */

export const parts = /** @type {const} */ (['x', 'y', 'theta']);

/** Judged to the digits that are shown, so that nobody reads 0.031 outside of 0.031. @param {number} error @param {number} set */
export const isInside = (error, set) => Number(typed(error, 3)) <= Number(typed(set, 3));

/** The first start is that of the drive. @param {Float64Array} errors @returns {Sizes} */
const sizesOf = (errors) => {
  const others = errors.subarray(1);
  return { drive: errors[0], median: median(others) ?? 0, largest: Math.max(...others) };
};

/** Whether Theorem 2 speaks of them. @param {readonly number[]} gains */
export const arePositive = (gains) => gains.every((gain) => gain > 0);

/** @param {Measured} measured @returns {Summary} */
export function summarize({ spec, disturbed, calm }) {
  const others = Array.from({ length: disturbed.error.x.length - 1 }, (_, i) => i + 1);
  /** @param {PartName} part @param {number} start */
  const staysInside = (part, start) => isInside(disturbed.error[part][start], disturbed.sets[part][start]);
  /** @param {PartName} part @returns {Row} */
  const rowOf = (part) => ({
    ...sizesOf(disturbed.error[part]),
    set: disturbed.sets[part][0],
    isInside: staysInside(part, 0),
    inside: others.filter((start) => staysInside(part, start)).length,
  });
  const calmSizes = ofEach((part) => sizesOf(calm.error[part]));
  return {
    rows: ofEach(rowOf),
    calm: calmSizes,
    worst: calmSizes.y.largest >= calmSizes.x.largest ? 'y' : 'x',
    starts: others.length,
    allInside: others.filter((start) => parts.every((part) => staysInside(part, start))).length,
    disturbed: spec.experiment.disturbance.kind !== 'none',
    seconds: spec.seconds,
    horizon: spec.experiment.horizon,
    law: spec.experiment.law,
    isPositive: arePositive(spec.gains),
    ky: spec.gains[1],
  };
}

/** @template T @param {(part: PartName) => T} give @returns {Record<PartName, T>} */
const ofEach = (give) => ({ x: give('x'), y: give('y'), theta: give('theta') });
