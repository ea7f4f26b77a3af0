// What is written into the fitness curve of many seeds: names at its lines, each where it covers no other, and what will stand there.
/** @import { Axes } from '../../kit/chart.js' */
/** @import { Line, SeedCurveModel } from './curve.js' */
/** @import { SeedSurvey } from './request.js' */
import { textFont } from '../../kit/lettering.js';
import { drawAxisNames, drawName, labelHeight, spreadBeside } from '../../kit/names.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';

/** @typedef {{ left: number, right: number, y: number }} Box Of a name, and the height of its middle. */
/** @typedef {{ x: number, y: number, apart: number }} Candidate Where a name may begin, and how far its line is from the other there. */

/** @param {CanvasRenderingContext2D} context @param {string} text */
function widthOf(context, text) {
  context.font = textFont;
  return context.measureText(text).width + 6;
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {SeedCurveModel} model @param {(cost: number) => number} y The place of a cost. */
export function drawLineNames(context, axes, model, y) {
  const { survey, lab, seed, log } = model;
  const { x, frame } = axes;
  const token = '--ink';
  if (survey) {
    const places = namesOf(survey, y, frame);
    spreadBeside(places, frame);
    for (const place of places) drawName(context, { ...place, x: frame.right - 4, align: 'right' });
    const taken = places.map(({ text, y: middle }) => ({
      left: frame.right - 4 - widthOf(context, text),
      right: frame.right - 4,
      y: middle,
    }));
    for (const line of [lab, seed])
      if (line) {
        const width = widthOf(context, line.name);
        const place = placeWhereAlone(candidatesOf(x, y, line, survey), width, taken);
        taken.push({ left: place.x, right: place.x + width, y: place.y });
        drawName(context, { text: line.name, x: place.x, y: place.y, token });
      }
  } else {
    const last = Math.min((lab?.costs.length ?? 0) - 1, model.generations);
    drawExpected(context, axes, besideEnd(y(lab?.costs[last] ?? 0), frame));
    if (lab) drawName(context, { text: lab.name, x: x(last) + 8, y: y(lab.costs[last]), token });
    // Beside the dots there is no room for it, and the title says it.
    drawAxisNames(context, frame, { x: words.generationAxis });
  }
  const text = log && survey ? words.distanceAxis(survey.summary.lowest) : words.costSymbol;
  drawName(context, { text, x: frame.left - 50, y: 8 });
}

/** Names at the ends of the lines, also of one that lies above the plot. @param {Pick<SeedSurvey, 'experiment' | 'generations' | 'paper'> & { summary: Pick<SeedSurvey['summary'], 'evolution' | 'random'> }} survey @param {(cost: number) => number} y @param {Pick<Axes['frame'], 'top'>} frame */
export function namesOf({ experiment, summary, generations: last, paper: { cost } }, y, { top }) {
  const { evolution, random } = summary;
  const own = words.isRandom(experiment) ? words.randomLine : words.evolutionLine;
  const nameAt = (/** @type {string} */ name, /** @type {number} */ at, /** @type {number} */ aside) => ({
    text: y(at) > top ? name : lab.above(name),
    y: y(at) + aside,
  });
  return [
    ...(own === words.randomLine ? [] : [nameAt(words.randomLine, random.high[last], -11)]),
    { ...nameAt(own, evolution.high[last], -11), token: '--ink', isStrong: true },
    ...(Number.isFinite(cost) ? [nameAt(words.paperLine, cost, cost > random.high[last] ? -11 : 10)] : []),
  ];
}

/** Above or below a line, on the side away from the median. @param {Axes['x']} x @param {(cost: number) => number} y @param {Line} line @param {SeedSurvey} survey @returns {Candidate[]} */
function candidatesOf(x, y, { costs }, survey) {
  const medians = survey.summary.evolution.median;
  const last = Math.min(costs.length, medians.length) - 1;
  const from = Math.ceil(0.08 * last);
  return Array.from({ length: Math.max(1, Math.floor(0.6 * last) - from + 1) }, (_, i) => {
    const at = Math.min(last, from + i);
    const [own, median] = [y(costs[at]), y(medians[at])];
    return { x: x(at) + 4, y: own + (own < median ? -11 : 11), apart: Math.abs(own - median) };
  });
}

/** Where a line is farthest from the median, of the places where its name lies on no other. @param {readonly Candidate[]} candidates @param {number} width @param {readonly Box[]} taken @returns {Candidate} */
export function placeWhereAlone(candidates, width, taken) {
  const isFree = (/** @type {Candidate} */ { x, y }) =>
    taken.every((box) => x + width < box.left || x > box.right || Math.abs(y - box.y) >= labelHeight - 2);
  const free = candidates.filter(isFree);
  return (free.length > 0 ? free : candidates).reduce((best, one) => (one.apart > best.apart ? one : best));
}

/** Below where the lab's own curve ends, or above it: how far down, as a part of the height. @param {number} end @param {Pick<Axes['frame'], 'top' | 'bottom'>} frame */
export const besideEnd = (end, { top, bottom }) => (end > (top + bottom) / 2 ? 0.2 : 0.55);

/** What will stand there, line by line. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {number} down From the top, as a part of the height. */
function drawExpected(context, { frame }, down) {
  const room = frame.right - frame.left - 16;
  /** @type {string[]} */
  const lines = [];
  for (const word of words.expectedText.split(' ')) {
    const longer = `${lines.at(-1)} ${word}`;
    if (lines.length > 0 && widthOf(context, longer) <= room) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  const top = frame.top + down * (frame.bottom - frame.top) - (lines.length / 2) * labelHeight;
  for (const [i, text] of lines.entries()) {
    const x = (frame.left + frame.right - widthOf(context, text)) / 2;
    drawName(context, { text, x, y: top + (i + 0.5) * labelHeight });
  }
}
