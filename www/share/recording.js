// Writes down what is drawn on canvases, as marks. The views draw as ever and know nothing of it.
import { Outline, steps } from './marks.js';

/** @typedef {import('./marks.js').Clip} Clip */
/** @typedef {import('./marks.js').Mark} Mark */
/** @typedef {import('./marks.js').Paint} Paint */
/** @typedef {Record<string, (...args: any[]) => any>} Methods */

const originalPath = globalThis.Path2D;

/** A path that knows its outline. Canvases cannot tell what a path is made of. */
class RecordedPath extends originalPath {
  outline = new Outline(2);

  /** @param {Path2D | string} [from] */
  constructor(from) {
    super(from);
    if (from !== undefined) this.outline.d = typeof from === 'string' ? from : outlineOf(from);
    for (const step of steps)
      before(this, step, (...args) =>
        /** @type {Methods} */ (/** @type {unknown} */ (this.outline))[step](...args),
      );
  }
}

/** @param {Path2D} path */
function outlineOf(path) {
  if (path instanceof RecordedPath) return path.outline.d;
  throw new Error('a path was made before the recording began');
}

/**
 * Redraws, and returns what came onto each of the canvases. What was not redrawn is not in the map.
 * @param {HTMLCanvasElement[]} canvases @param {() => void} redraw
 * @returns {Promise<Map<HTMLCanvasElement, Mark[]>>}
 */
export async function recorded(canvases, redraw) {
  const recordings = canvases.map((canvas) => ({ canvas, ...record(canvas) }));
  globalThis.Path2D = RecordedPath;
  try {
    redraw();
    // uPlot draws in a microtask that the redrawing has asked for.
    await null;
  } finally {
    globalThis.Path2D = originalPath;
    for (const { stop } of recordings) stop();
  }
  return new Map(
    recordings.filter(({ marks }) => marks.length > 0).map(({ canvas, marks }) => [canvas, marks]),
  );
}

/** Calls a function before a method of an object. @param {object} object @param {string} name @param {(...args: any[]) => void} act */
function before(object, name, act) {
  const methods = /** @type {Methods} */ (object);
  const own = methods[name].bind(object);
  methods[name] = (...args) => {
    act(...args);
    return own(...args);
  };
}

/** Calls a function with what a method of an object has made. @param {object} object @param {string} name @param {(made: any, ...args: any[]) => void} act */
function after(object, name, act) {
  const methods = /** @type {Methods} */ (object);
  const own = methods[name].bind(object);
  methods[name] = (...args) => {
    const made = own(...args);
    act(made, ...args);
    return made;
  };
}

/** @param {HTMLCanvasElement} canvas */
function record(canvas) {
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const known = new Set(Object.keys(context));
  /** @type {Mark[]} */
  const marks = [];
  /** @type {readonly Clip[]} */
  let clips = [];
  /** @type {(readonly Clip[])[]} */
  const saved = [];
  let path = new Outline(2);
  const paintOf = recordPaints(context);

  const look = () => ({
    matrix: context.getTransform(),
    clips,
    alpha: context.globalAlpha,
    fill: null,
    stroke: null,
  });
  const fill = () => ({ fill: paintOf(context.fillStyle) });
  const stroke = () => ({
    stroke: {
      paint: paintOf(context.strokeStyle),
      width: context.lineWidth,
      dash: context.getLineDash(),
      cap: context.lineCap,
      join: context.lineJoin,
    },
  });
  const given = (/** @type {unknown} */ one) => (one instanceof originalPath ? outlineOf(one) : path.d);
  const shape = (/** @type {string} */ d, /** @type {object} */ paint) =>
    marks.push({ kind: 'shape', d, ...look(), ...paint });
  const rect = (/** @type {number[]} */ ...box) => {
    const outline = outlineIn(context);
    outline.rect(box[0], box[1], box[2], box[3]);
    return outline.d;
  };

  for (const step of steps)
    before(context, step, (...args) => /** @type {Methods} */ (/** @type {unknown} */ (path))[step](...args));
  before(context, 'beginPath', () => (path = outlineIn(context)));
  before(context, 'fill', (one) => shape(given(one), fill()));
  before(context, 'stroke', (one) => shape(given(one), stroke()));
  before(context, 'fillRect', (...box) => shape(rect(...box), fill()));
  before(context, 'strokeRect', (...box) => shape(rect(...box), stroke()));
  before(context, 'clip', (one) => (clips = [...clips, { d: given(one), matrix: context.getTransform() }]));
  before(context, 'save', () => saved.push(clips));
  before(context, 'restore', () => (clips = saved.pop() ?? []));
  // Views clear the whole canvas, or nothing.
  before(context, 'clearRect', () => (marks.length = 0));
  before(context, 'strokeText', (text, x, y) =>
    marks.push({ ...look(), ...textIn(context, text, x, y), ...stroke() }),
  );
  before(context, 'fillText', (text, x, y) => {
    const mark = textIn(context, text, x, y);
    const last = marks[marks.length - 1];
    const isHalo =
      last?.kind === 'text' && !last.fill && last.text === text && last.x === x && last.y === mark.y;
    if (isHalo) Object.assign(last, fill());
    else marks.push({ ...look(), ...mark, ...fill() });
  });
  before(context, 'drawImage', (source, x, y, width, height) =>
    marks.push({
      kind: 'image',
      source: copyOf(source),
      box: [x, y, width, height],
      smooth: context.imageSmoothingEnabled,
      ...look(),
    }),
  );
  const stop = () => {
    for (const name of Object.keys(context))
      if (!known.has(name)) delete (/** @type {Partial<Methods>} */ (/** @type {unknown} */ (context))[name]);
  };
  return { marks, stop };
}

/** An outline as exact as a hundredth of a pixel, in whatever it is drawn. @param {CanvasRenderingContext2D} context */
function outlineIn(context) {
  const { a, b } = context.getTransform();
  return new Outline(Math.max(0, 2 + Math.ceil(Math.log10(Math.hypot(a, b)))));
}

/** Gradients and patterns do not tell what they are made of either. @param {CanvasRenderingContext2D} context */
function recordPaints(context) {
  /** @type {WeakMap<object, Paint>} */
  const paints = new WeakMap();
  after(context, 'createLinearGradient', (gradient, x0, y0, x1, y1) => {
    /** @type {import('./marks.js').Gradient} */
    const paint = { from: [x0, y0], to: [x1, y1], stops: [] };
    paints.set(gradient, paint);
    before(gradient, 'addColorStop', (offset, colour) => paint.stops.push([offset, colour]));
  });
  after(context, 'createPattern', (pattern, tile) => {
    const paint = { tile: copyOf(tile), scale: 1 };
    paints.set(pattern, paint);
    before(pattern, 'setTransform', (matrix) => (paint.scale = matrix.a));
  });
  return (/** @type {string | CanvasGradient | CanvasPattern} */ style) =>
    typeof style === 'string' ? style : (paints.get(style) ?? 'none');
}

/** @param {HTMLCanvasElement} canvas */
export function copyOf(canvas) {
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  copy.getContext('2d')?.drawImage(canvas, 0, 0);
  return copy;
}

/** @param {CanvasRenderingContext2D} context @param {string} text @param {number} x @param {number} y */
function textIn(context, text, x, y) {
  const [, before, size, family] = /^(.*?)([\d.]+)px\s+(.*)$/.exec(context.font) ?? [
    '',
    '',
    '10',
    'sans-serif',
  ];
  const { textBaseline } = context;
  const ascent = context.measureText(text).actualBoundingBoxAscent;
  context.textBaseline = 'alphabetic';
  const shift = context.measureText(text).actualBoundingBoxAscent - ascent;
  context.textBaseline = textBaseline;
  return {
    kind: /** @type {const} */ ('text'),
    text,
    x,
    y: y + shift,
    anchor: /** @type {const} */ ({
      center: 'middle',
      right: 'end',
      end: 'end',
      left: 'start',
      start: 'start',
    })[context.textAlign],
    font: {
      style: before.includes('italic') ? 'italic' : 'normal',
      weight: /\d+/.exec(before)?.[0] ?? (before.includes('bold') ? '700' : '400'),
      size: Number(size),
      family,
    },
  };
}
