// The picture of a contest: J over the drives and the share at the target, the share of many targets, or where the runs end.
/** @import { Frame, Scale, Size } from '../../kit/chart.js' */
/** @import { Contest } from './contest-request.js' */
/** @import { Standings } from './contest-summary.js' */
/** @import { Grip } from './contest-handles.js' */
/** @import { LuckState } from './state.js' */
import { scaleLinear, scaleLog } from 'd3-scale';
import {
  createChart,
  drawCurve,
  drawGrid,
  drawNumbersBelow,
  drawUpright,
  frameIn,
  pointsOf,
} from '../../kit/chart.js';
import { canScroll } from '../../kit/finger.js';
import { pointIn } from '../../kit/map.js';
import { remember } from '../../kit/memo.js';
import { drawAxisNames, drawName, isNarrow } from '../../kit/names.js';
import { styles } from '../../run/pins.js';
import { drawCosts } from './contest-costs.js';
import { drivesOn, manySharesOf, sharesOf } from './contest-courses.js';
import { drawEnds } from './contest-ends.js';
import { createHandle } from './contest-handles.js';
import { drawNamesAt, gutterFor, powersIn } from './contest-marks.js';
import words from './words/index.js';

/** @typedef {{ contest: Contest | null, standings: Standings | null, budget: number, reading: LuckState['reading'], theme: number }} ContestChartModel */
/** Where its lines can be held. @typedef {{ target: Grip | null, until: Grip | null }} Grips */

/** Where there is less height, the shares have no room. */
const roomForBoth = 180;
const between = 14;
/** So near a line a press on the picture means that line. */
const near = 14;

/** @param {HTMLElement} root @param {{ onTarget: (target: number) => void, onUntil: (drives: number) => void }} on */
export function createContestChart(root, { onTarget, onUntil }) {
  const chart = createChart(root, (context, size, /** @type {ContestChartModel} */ model) => {
    const grips = draw(context, size, model);
    target.place(grips.target);
    until.place(grips.until);
  });
  // Beside the picture, in which nothing can be worked.
  const frame = root.parentElement ?? root;
  const target = createHandle(frame, 'contest-target-line', words.contestTexts.target, onTarget);
  const until = createHandle(frame, 'contest-until-line', words.contestTexts.until, onUntil);
  const { canvas } = chart;
  let held = target;
  canvas.addEventListener('pointerdown', (event) => {
    // A finger that moves over it scrolls the page; it can hold the lines themselves.
    if (event.button !== 0 || canScroll(event)) return;
    held = until.distanceTo(pointIn(root, event)) < near ? until : target;
    canvas.setPointerCapture(event.pointerId);
    held.follow(event);
  });
  canvas.addEventListener('pointermove', (event) => {
    // A finger is captured by itself.
    if (!canScroll(event) && canvas.hasPointerCapture(event.pointerId)) held.follow(event);
  });
  return chart;
}

const drivesUpTo = remember(drivesOn);

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {ContestChartModel} model @returns {Grips} */
function draw(context, size, { contest, standings, budget, reading }) {
  const whole = {
    ...frameIn(size, { top: 20, right: gutterFor(context, size, standings) }),
    hasNames: !isNarrow(size),
  };
  const there = contest && standings?.lowest ? { contest, standings, lowest: standings.lowest.cost } : null;
  if (reading === 'ends' && there) return { target: drawEnds(context, whole, there), until: null };
  const drives = drivesUpTo(contest?.budget ?? budget);
  const x = scaleLog([1, drives[drives.length - 1]], [whole.left, whole.right]);
  const ticks = powersIn([1, drives[drives.length - 1]]);
  drawNumbersBelow(context, x, whole.bottom, ticks, ticks.map(words.wholeNumber));
  drawAxisNames(context, whole, { x: words.drivesAxis });
  if (reading === 'targets') {
    const shares = there ? manyShares(there.standings, drives) : [];
    drawShares(context, whole, { x, ticks, drives, shares }, words.targetsAxis);
    if (there) {
      const ends = shares.map((share) => share?.at(-1) ?? Number.NaN);
      const y = scaleLinear([0, 1], [whole.bottom, whole.top]);
      drawNamesAt(context, whole, there.standings, ends.map(y));
    }
    return { target: null, until: there && drawUntil(context, whole, x, there) };
  }
  const hasBoth = size.height >= roomForBoth;
  const middle = Math.round(whole.top + 0.62 * (whole.bottom - whole.top));
  const upper = hasBoth ? { ...whole, bottom: middle } : whole;
  const target = drawCosts(context, upper, { x, ticks, drives }, there);
  if (hasBoth) {
    const shares = there ? sharesAt(there.standings, drives) : [];
    drawShares(context, { ...whole, top: middle + between }, { x, ticks, drives, shares }, words.shareAxis);
  }
  return { target, until: there && drawUntil(context, whole, x, there) };
}

const manyShares = remember(manySharesOf);
const sharesAt = remember(sharesOf);

/** @typedef {{ x: Scale, ticks: number[], drives: readonly number[] }} Panel */

/** @param {CanvasRenderingContext2D} context @param {Frame} frame @param {Panel & { shares: readonly (number[] | null)[] }} panel @param {string} name */
function drawShares(context, frame, { x, ticks, drives, shares }, name) {
  const y = scaleLinear([0, 1], [frame.bottom, frame.top]);
  const parts = [0, 0.5, 1];
  drawGrid(context, { x, y, frame }, { x: ticks, y: parts }, parts.map(words.percent));
  for (const [i, share] of shares.entries())
    if (share) {
      const points = pointsOf({ x, y, frame }, drives, share);
      drawCurve(context, points, { ...styles[i], width: 2 });
    }
  context.setLineDash([]);
  drawName(context, { text: name, x: frame.left + 4, y: frame.top + 8 });
}

/** The line up to which it is read. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {Scale} x @param {{ contest: Contest, standings: Standings }} there @returns {Grip} */
function drawUntil(context, frame, x, { contest, standings: { budget } }) {
  const at = x(budget);
  drawUpright(context, at, frame, { token: '--ink', width: 1, dash: [3, 3] });
  return {
    x: at,
    y: frame.top - 8,
    along: 'x',
    from: frame.left,
    to: frame.right,
    valueAt: (px) => Math.min(contest.budget, Math.max(1, Math.round(x.invert(px)))),
    range: [1, contest.budget],
    value: budget,
    text: words.drivesChoice(budget),
  };
}
