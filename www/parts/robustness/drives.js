// The drives from one place in all headings, which the map shows where one points. Each is the only one of its experiment: its draw of a
// random disturbance is not the one that the map has there.
/** @import { Engine, Experiment, Run } from '../../core/engine.js' */
/** @import { Grid } from './grid.js' */
/** @import { Spec } from './request.js' */
import { isLongDrive } from '../../core/bounds.js';
import { remember } from '../../kit/memo.js';
import { headings, startOf } from './grid.js';

/** To draw a run takes about twice as long as to drive it. */
const drivesInOne = 3;

/** Whether all headings of a place are shown: not where to draw them would hold the page. @param {Experiment} experiment */
export const areShown = (experiment) => !isLongDrive(experiment, drivesInOne * headings);

/** Milliseconds of a frame. */
const share = 10;

/** Those from the place that is asked for, some more in each frame until all are there. @param {Engine} engine @param {() => void} redraw */
export function createDrives(engine, redraw) {
  const begin = remember(
    (/** @type {Spec} */ _spec, /** @type {Grid} */ _grid, /** @type {number} */ _cell) => ({
      runs: /** @type {readonly Run[]} */ ([]),
    }),
  );
  /** @param {Spec} spec @param {Grid} grid @param {number} cell */
  return (spec, grid, cell) => {
    const begun = begin(spec, grid, cell);
    const end = performance.now() + share;
    const { experiment, gains } = spec;
    while (begun.runs.length < headings && performance.now() < end) {
      const starts = [startOf(grid, cell, begun.runs.length)];
      begun.runs = [...begun.runs, ...engine.drive({ ...experiment, starts }, [gains])];
    }
    if (begun.runs.length < headings) redraw();
    return begun.runs;
  };
}
