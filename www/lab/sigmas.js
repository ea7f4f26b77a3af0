// The mean step size σ of each gain over the generations, on a logarithmic axis.
import uPlot from 'uplot';
import { drawShown, lastTick } from './fitness.js';
import { axis, gutterOf, isNarrow, lineLabel, placeName, sizeOf, spread, wholeSteps } from '../kit/plot.js';
import { colour } from '../kit/palette.js';
import { watch } from '../kit/memo.js';
import { curves as words, lab } from '../words/index.js';

/** @typedef {import('../core/engine.js').Statistics} Statistics */
/** @typedef {{ history: Statistics[], generation: number, theme: number }} SigmasModel */

const tokens = ['--x', '--y', '--theta'];

/** @param {HTMLElement} root */
export function createSigmas(root) {
  /** @type {SigmasModel} */
  let model = { history: [], generation: 0, theme: 0 };
  const changed = watch();
  const labels = createLabels();
  const points = { show: () => model.history.length === 1, size: 7 };
  const plot = new uPlot(
    {
      ...sizeOf(root),
      padding: [8, gutterOf, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: () => [0, lastTick(model.history.length - 1)] },
        y: { distr: 3, range: () => decades(model.history) },
      },
      axes: [
        { ...axis(), size: 28, space: 56, incrs: wholeSteps },
        {
          ...axis(),
          size: 52,
          splits: () => powers(decades(model.history)),
          // Left to itself, uPlot names only some of the powers.
          filter: (_, powersOfTen) => powersOfTen,
          values: (_, ticks) => ticks.map(powerText),
        },
      ],
      series: [
        {},
        ...tokens.map((token) => ({
          stroke: () => colour(token),
          width: 2,
          points: { ...points, fill: () => colour(token) },
        })),
      ],
      hooks: {
        draw: [
          (drawn) => {
            labels.draw(drawn, model.history[model.history.length - 1]);
            drawShown(drawn, model);
          },
        ],
      },
    },
    [[], [], [], []],
    root,
  );
  plot.over.append(...labels.elements);
  new ResizeObserver(() => plot.setSize(sizeOf(root))).observe(root);

  return {
    /** @param {SigmasModel} next */
    draw(next) {
      if (!changed(next.history, next.generation, next.theme)) return;
      model = next;
      root.setAttribute(
        'aria-label',
        words.sigmaLabel(next.history[0], next.history[next.generation], lab.gains),
      );
      plot.setData(columns(next.history));
    },
  };
}

/** @param {Statistics[]} history @returns {uPlot.AlignedData} */
const columns = (history) => [
  history.map(({ generation }) => generation),
  // A σ that has underflowed has no place on this axis.
  ...[0, 1, 2].map((i) => history.map(({ meanSigmas }) => meanSigmas[i] || null)),
];

/** Whole powers of ten around all σ. @param {Statistics[]} history @returns {[number, number]} */
function decades(history) {
  const exponents = history
    .flatMap(({ meanSigmas }) => meanSigmas)
    .filter((sigma) => sigma > 0 && Number.isFinite(sigma))
    .map(Math.log10);
  // σ = 1 of the beginning has a decade above and below.
  return [10 ** Math.floor(Math.min(-1, ...exponents)), 10 ** Math.ceil(Math.max(1, ...exponents))];
}

/** At most some seven of the powers of ten between. @param {[number, number]} range */
function powers([low, high]) {
  const [from, to] = [Math.round(Math.log10(low)), Math.round(Math.log10(high))];
  const step = Math.ceil((to - from) / 6);
  return Array.from(
    { length: Math.floor((to - from) / step) + 1 },
    (_, i) => 10 ** (to - i * step),
  ).reverse();
}

const powerText = (/** @type {number} */ power) => words.powerOfTen(Math.round(Math.log10(power)));

function createLabels() {
  const names = lab.gains.map(({ id, letter, index }) => {
    const [before, after] = words.sigmaOf;
    const label = lineLabel(`sigma ${id}`, before);
    const subscript = document.createElement('sub');
    subscript.textContent = index;
    label.append(letter, subscript, after);
    return label;
  });
  const axisName = lineLabel('axis-name', lab.generationAxis);
  /** @param {uPlot} plot @param {Statistics | undefined} newest */
  const draw = (plot, newest) => {
    const height = plot.over.clientHeight;
    const right = plot.over.clientWidth + 6;
    axisName.style.transform = `translate(${right + 6}px, ${height + 6}px)`;
    if (!newest) return;
    const end = plot.valToPos(newest.generation, 'x') + 10;
    const places = names.map((element, i) => ({
      element,
      y: Math.min(Math.max(plot.valToPos(newest.meanSigmas[i], 'y') || height, 0), height - 8),
    }));
    spread(places, height);
    for (const { element, y } of places) placeName(plot, element, Math.min(end, right), y);
    axisName.hidden = isNarrow(plot);
  };
  return { elements: [...names, axisName], draw };
}
