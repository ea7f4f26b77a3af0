// Where the runs end: a row for each contestant, a dot for each seed, and the median.
/** @import { NamedFrame } from './contest-marks.js' */
/** @import { There } from './contest-costs.js' */
/** @import { Grip } from './contest-handles.js' */
import { scaleLog } from 'd3-scale';
import { drawLevel, drawNumbersBelow, drawUpright } from '../../kit/chart.js';
import { drawName } from '../../kit/names.js';
import { styles } from '../../run/pins.js';
import { distanceFrom, rangeIn } from './contest-courses.js';
import { drawNamesAt, powerNames, powersIn } from './contest-marks.js';
import { costAt } from './contest-statistics.js';
import { diameterOf, drawDots, stackDots } from './dots.js';
import words from './words/index.js';

/** @param {CanvasRenderingContext2D} context @param {NamedFrame} whole @param {There} there @returns {Grip} */
export function drawEnds(context, whole, { contest, standings, lowest }) {
  const { drawn, lines, target, budget } = standings;
  // The target and its grip stand between the name of the axis and the dots.
  const frame = { ...whole, top: whole.top + 14 };
  const distance = distanceFrom(lowest);
  const [low, high] = rangeIn(contest, lowest);
  // The lowest of all stands within it.
  const x = scaleLog([low / 10, high], [frame.left, frame.right]).clamp(true);
  const ticks = powersIn([low / 10, high]);
  for (const tick of ticks) drawUpright(context, x(tick), frame, { token: '--hairline', width: 1 });
  drawNumbersBelow(context, x, frame.bottom, ticks, powerNames(ticks));
  drawName(context, { text: words.distanceAxis(lowest), x: frame.left - 50, y: 8 });
  const row = (frame.bottom - frame.top) / lines.length;
  const heights = lines.map((_, i) => frame.top + (i + 0.85) * row);
  for (const [i, { trials }] of drawn.entries()) {
    const { token } = styles[i];
    drawLevel(context, frame, heights[i], { token: '--hairline', width: 1 });
    if (trials.length === 0) continue;
    const diameter = diameterOf(trials.length);
    const places = trials.map((trial) => x(distance(costAt(trial, budget))));
    const dots = stackDots(places, diameter, 0.7 * row);
    drawDots(context, dots, diameter, token, (along, away) => [along, heights[i] - away]);
    const median = x(distance(lines[i].median));
    const between = { top: heights[i] - 0.75 * row, bottom: heights[i] };
    drawUpright(context, median, between, { token, width: 2 });
  }
  drawNamesAt(
    context,
    frame,
    standings,
    heights.map((height, i) => (drawn[i].trials.length > 0 ? height - 0.3 * row : Number.NaN)),
  );
  const at = x(distance(target));
  drawUpright(context, at, frame, { token: '--ink', width: 1, dash: [3, 3] });
  const isFar = at > (frame.left + frame.right) / 2;
  drawName(context, {
    text: words.targetLine(target),
    x: at + (isFar ? -10 : 10),
    y: frame.top - 7,
    align: isFar ? 'right' : 'left',
    token: '--ink',
  });
  return {
    x: at,
    y: frame.top - 7,
    along: 'x',
    from: frame.left,
    to: frame.right,
    valueAt: (px) => lowest + x.invert(px),
    range: [lowest + low / 10, lowest + high],
    value: target,
    text: words.targetLine(target),
  };
}
