// J over the drives: the median of each contestant, its quartiles, and the target.
/** @import { Frame } from '../../kit/chart.js' */
/** @import { NamedFrame } from './contest-marks.js' */
/** @import { Panel } from './contest-chart.js' */
/** @import { Grip } from './contest-handles.js' */
/** @import { Contest } from './contest-request.js' */
/** @import { Standings } from './contest-summary.js' */
import { scaleLinear, scaleLog } from 'd3-scale';
import { drawBand, drawCurve, drawGrid, drawLevel, pointsOf, within } from '../../kit/chart.js';
import { remember } from '../../kit/memo.js';
import { drawName } from '../../kit/names.js';
import { styles } from '../../run/pins.js';
import { coursesOf, distanceFrom, rangeIn } from './contest-courses.js';
import { drawNamesAt, powerNames, powersIn } from './contest-marks.js';
import words from './words/index.js';

/** @typedef {{ contest: Contest, standings: Standings, lowest: number }} There */

/** With few of the seeds. */
const courses = remember(coursesOf);

/** @param {CanvasRenderingContext2D} context @param {NamedFrame} frame @param {Panel} panel @param {There | null} there @returns {Grip | null} */
export function drawCosts(context, frame, { x, ticks, drives }, there) {
  if (!there) {
    const y = scaleLinear([0, 1], [frame.bottom, frame.top]);
    drawGrid(context, { x, y, frame }, { x: ticks, y: [] }, []);
    drawName(context, { text: words.costSymbol, x: frame.left - 50, y: 8 });
    drawName(context, { text: words.emptyCosts, x: frame.left + 4, y: frame.top + 8 });
    return null;
  }
  const { contest, standings, lowest } = there;
  const found = courses(standings.drawn, drives);
  const distance = distanceFrom(lowest);
  const range = rangeIn(contest, lowest);
  const y = scaleLog(range, [frame.bottom, frame.top]);
  const powers = powersIn(range, frame.bottom - frame.top);
  drawGrid(context, { x, y, frame }, { x: ticks, y: powers }, powerNames(powers));
  const points = (/** @type {number[]} */ costs) =>
    pointsOf(
      { x, y, frame },
      drives,
      costs.map((cost) => (Number.isFinite(cost) ? distance(cost) : Number.NaN)),
    );
  within(context, frame, () => {
    for (const [i, course] of found.entries())
      if (course) drawBand(context, points(course.high), points(course.low), styles[i].token, 0.13);
    for (const [i, course] of found.entries())
      if (course) drawCurve(context, points(course.median), { ...styles[i], width: 2.5 });
  });
  context.setLineDash([]);
  const at = Math.min(Math.max(y(distance(standings.target)), frame.top), frame.bottom);
  drawTarget(context, frame, at, standings.target);
  const ends = found.map((course) => y(distance(course?.median.at(-1) ?? Infinity)));
  drawNamesAt(context, frame, standings, ends);
  drawName(context, { text: words.distanceAxis(lowest), x: frame.left - 50, y: 8 });
  return {
    x: frame.left,
    y: at,
    along: 'y',
    from: frame.top,
    to: frame.bottom,
    valueAt: (py) => lowest + y.invert(py),
    range: [lowest + range[0], lowest + range[1]],
    value: standings.target,
    text: words.targetLine(standings.target),
  };
}

/** @param {CanvasRenderingContext2D} context @param {Frame} frame @param {number} at @param {number} target */
function drawTarget(context, frame, at, target) {
  drawLevel(context, frame, at, { token: '--ink', width: 1, dash: [3, 3] });
  const y = at - 9 < frame.top ? at + 9 : at - 9;
  drawName(context, { text: words.targetLine(target), x: frame.left + 12, y, token: '--ink' });
}
