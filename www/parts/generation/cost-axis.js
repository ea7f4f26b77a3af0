// What stands behind the marks of costs: the axis of J, and below it pairs or wins; of CMA-ES what each rank weighs.
/** @import { Size } from './places.js' */
/** @import { PictureModel } from './picture.js' */
import { tickStep, ticks as ticksOf } from 'd3-array';
import { hasPairs } from '../../core/methods.js';
import { svg } from '../../kit/elements.js';
import { roundStep, sameDigits } from '../../kit/steps.js';
import { fixed } from '../../words/numbers.js';
import words from './words/index.js';
import { columnsOf, heightOf, margin } from './places.js';
import { isInitial } from './record.js';

/** @param {Element} layer @param {PictureModel} model @param {Size} size */
export function drawCostAxis(layer, { anatomy, phase }, size) {
  const height = heightOf(anatomy, size);
  const right = size.width - margin.right;
  const [low, high] = height.scale.domain();
  const room = Math.max(2, Math.floor(size.height / 48));
  const step = tickStep(low, high, room);
  // Where evolution has nearly ended J itself would need too many digits: how far from the best, in parts of a power of ten.
  const narrow = step < 1e-4;
  const power = Math.floor(Math.log10(high - low));
  const beyond = narrow ? ticksOf(0, high - low, room) : [];
  const ticks = narrow ? beyond.map((tick) => low + tick) : ticksOf(low, high, room);
  const texts = narrow
    ? sameDigits(beyond.map((tick) => tick / 10 ** power)).map(words.beyondBest)
    : sameDigits(ticks);
  const line = (/** @type {number} */ y) => svg('line', { x1: margin.left, x2: right, y1: y, y2: y });
  const label = (/** @type {number} */ y, /** @type {string} */ text) =>
    svg('text', { x: margin.left - 8, y: y + 4, class: 'end' }, text);
  const { above } = height;
  const first = above ? above.line + 14 : 0;
  const head = margin.top + (above ? 36 : 4);
  const firstText = narrow ? head + 10 : first;
  const shown = texts.filter((_, i) => height.scale(ticks[i]) > firstText);
  /** The limit is no tick, and is not called as one. @param {number} limit */
  const limitText = (limit) => {
    const [usual, finer] = narrow
      ? [3, 4].map((digits) => fixed(limit, digits))
      : [step, step / 10].map((apart) => sameDigits([limit, limit + apart])[0]);
    return words.aboveText(shown.includes(usual) ? finer : usual);
  };
  layer.replaceChildren(
    ...ticks.flatMap((tick) =>
      height.scale(tick) > first ? [line(Math.floor(height.scale(tick)) + 0.5)] : [],
    ),
    ...ticks.flatMap((tick, i) =>
      height.scale(tick) > firstText ? [label(height.scale(tick), texts[i])] : [],
    ),
    ...(above
      ? [
          svg('line', { x1: margin.left, x2: right, y1: above.line, y2: above.line, class: 'limit' }),
          svg('text', { x: 0, y: above.y + 4 }, limitText(above.limit)),
        ]
      : []),
    svg('text', { x: 0, y: head, class: 'symbol' }, words.costAxis),
    ...(narrow ? [svg('text', { x: 14, y: head }, words.costUnit(power))] : []),
    ...across({ anatomy, phase }, size),
    ...(phase === 'ranking' ? [...weights(anatomy, size), ...lucks(anatomy, size)] : []),
  );
}

/** What the robots of each rank count for what follows, as bars. @param {PictureModel['anatomy']} anatomy @param {Size} size */
function weights({ record, ranked }, size) {
  const { x, step } = columnsOf(size, ranked);
  const base = size.height - margin.bottom;
  const [most = 1] = record.plan.weights;
  return record.plan.weights.map((weight, rank) => {
    const height = ((base - margin.top) * weight) / most / 2;
    return svg('rect', {
      x: x(rank) - 0.3 * step,
      y: base - height,
      width: 0.6 * step,
      height,
      class: 'weight',
    });
  });
}

/** Closer ones are no lines of single robots any more. */
const leastApart = 9;

/** What luck did to each: from where J alone, and so the wins that it had to expect, would have ranked it. @param {PictureModel['anatomy']} anatomy @param {Size} size */
function lucks({ expected, all, ranking, ranks }, size) {
  const { x, step } = columnsOf(size, all.length);
  if (expected.length === 0 || step < leastApart) return [];
  const { y } = heightOf({ all }, size);
  const byCost = [...ranking].sort((a, b) => all[a].cost - all[b].cost || a - b);
  return [
    ...byCost.map((number, place) => {
      const height = y(all[number].cost);
      return svg('line', { x1: x(place), x2: x(ranks[number]), y1: height, y2: height, class: 'luck' });
    }),
    svg(
      'text',
      { x: size.width - margin.right, y: size.height - margin.bottom - 6, class: 'end luck' },
      words.byCostText,
    ),
  ];
}

/** What stands below: the numbers of the pairs, the ranks, or the wins. @param {Pick<PictureModel, 'anatomy' | 'phase'>} model @param {Size} size */
function across({ anatomy, phase }, size) {
  const { columns, all, record, ranking, method } = anatomy;
  const base = size.height - 5;
  const label = (/** @type {number} */ x, /** @type {string} */ text) =>
    svg('text', { x, y: base, class: 'middle' }, text);
  const title = (/** @type {string} */ text) =>
    svg('text', { x: margin.left - 8, y: base, class: 'end' }, text);
  if (phase === 'ranking') {
    if (record.wins.length === 0) return [];
    const { x, step } = columnsOf(size, all.length);
    const groups = groupsOf(ranking.map((number) => record.wins[number]));
    return [
      title(words.winsAxis),
      ...groups.flatMap(({ wins, from, to }) => [
        svg('line', {
          x1: x(from) - 0.4 * step,
          x2: x(to) + 0.4 * step,
          y1: size.height - margin.bottom + 3,
          y2: size.height - margin.bottom + 3,
          class: 'group',
        }),
        ...((to - from + 1) * step >= 12 ? [label((x(from) + x(to)) / 2, String(wins))] : []),
      ]),
    ];
  }
  const { x, step } = columnsOf(size, columns);
  const every = Math.max(1, roundStep((8 + 6 * String(columns).length) / step));
  const shown = Array.from({ length: columns }, (_, i) => i + 1).filter((n) => n === 1 || n % every === 0);
  const name =
    phase === 'survivors'
      ? words.survivorAxis(method)
      : isInitial(record) || !hasPairs(method)
        ? words.robotAxis
        : words.pairAxis;
  return [title(name), ...shown.map((n) => label(x(n - 1), String(n)))];
}

/** Those in a row who have as many wins. @param {number[]} wins */
function groupsOf(wins) {
  /** @type {{ wins: number, from: number, to: number }[]} */
  const groups = [];
  for (const [i, own] of wins.entries()) {
    const last = groups[groups.length - 1];
    if (last?.wins === own) last.to = i;
    else groups.push({ wins: own, from: i, to: i });
  }
  return groups;
}
