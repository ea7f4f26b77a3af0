// A context that draws nothing and writes down as marks what it is told to draw.
/** @import { Clip, Look, Mark, Paint } from './marks.js' */
import { outlineOf } from '../kit/canvas.js';
import { Outline } from './marks.js';

/** What save() keeps. */
const settings = /** @type {const} */ ([
  ...['matrix', 'clips', 'dash', 'fillStyle', 'strokeStyle', 'globalAlpha', 'imageSmoothingEnabled'],
  ...['lineWidth', 'lineCap', 'lineJoin', 'font', 'textAlign', 'textBaseline'],
]);

/** What is drawn, as marks. @param {import('../kit/canvas.js').Paint} paint @returns {Mark[]} */
export function drawnMarks(paint) {
  const recorder = new Recorder();
  paint(/** @type {CanvasRenderingContext2D} */ (/** @type {unknown} */ (recorder)));
  return recorder.marks;
}

/** As much of a canvas's context as views use: an outline that is being drawn, and what is made of it. */
class Recorder extends Outline {
  /** @type {Mark[]} */
  marks = [];
  matrix = new DOMMatrix();
  /** @type {readonly Clip[]} */
  clips = [];
  /** @type {number[]} */
  dash = [];
  /** @type {Paint} */
  fillStyle = '#000000';
  /** @type {Paint} */
  strokeStyle = '#000000';
  globalAlpha = 1;
  imageSmoothingEnabled = true;
  lineWidth = 1;
  lineCap = 'butt';
  lineJoin = 'miter';
  font = '10px sans-serif';
  /** @type {keyof typeof anchors} */
  textAlign = 'start';
  /** @type {CanvasTextBaseline} */
  textBaseline = 'alphabetic';

  /** @type {Partial<Recorder>[]} */
  #saved = [];

  constructor() {
    super(2);
  }

  save() {
    this.#saved.push(Object.fromEntries(settings.map((name) => [name, this[/** @type {'font'} */ (name)]])));
  }
  restore() {
    Object.assign(this, this.#saved.pop());
  }
  /** @param {number[]} numbers */
  transform(...numbers) {
    this.matrix = this.matrix.multiply(new DOMMatrix(numbers));
  }
  /** @param {number} x @param {number} y */
  translate(x, y) {
    this.matrix = this.matrix.translate(x, y);
  }
  /** @param {number} angle In radians. */
  rotate(angle) {
    this.matrix = this.matrix.rotate((180 * angle) / Math.PI);
  }
  /** @param {number} x @param {number} y */
  scale(x, y) {
    this.matrix = this.matrix.scale(x, y);
  }
  /** @param {number[]} dash */
  setLineDash(dash) {
    this.dash = dash;
  }

  beginPath() {
    this.d = '';
    this.digits = this.#digits();
  }
  clip() {
    this.clips = [...this.clips, { d: this.d, matrix: this.matrix }];
  }
  /** @param {Path2D} [path] */
  fill(path) {
    this.#shape(path ? outlineOf(path) : this.d, this.#fill());
  }
  /** @param {Path2D} [path] */
  stroke(path) {
    this.#shape(path ? outlineOf(path) : this.d, this.#stroke());
  }
  /** @param {Parameters<Outline['rect']>} box */
  fillRect(...box) {
    this.#shape(this.#rect(box), this.#fill());
  }
  /** @param {Parameters<Outline['rect']>} box */
  strokeRect(...box) {
    this.#shape(this.#rect(box), this.#stroke());
  }
  /** @param {string} text @param {number} x @param {number} y */
  strokeText(text, x, y) {
    this.marks.push({ ...this.#look(), ...this.#text(text, x, y), ...this.#stroke() });
  }
  /** @param {string} text @param {number} x @param {number} y */
  fillText(text, x, y) {
    const mark = this.#text(text, x, y);
    const last = this.marks[this.marks.length - 1];
    const isHalo =
      last?.kind === 'text' && !last.fill && last.text === text && last.x === x && last.y === mark.y;
    if (isHalo) Object.assign(last, this.#fill());
    else this.marks.push({ ...this.#look(), ...mark, ...this.#fill() });
  }
  /** @param {string} text */
  measureText(text) {
    return measured(this.font, this.textBaseline, text);
  }
  /** @param {HTMLCanvasElement} source @param {number} x @param {number} y @param {number} width @param {number} height */
  drawImage(source, x, y, width, height) {
    this.marks.push({
      ...this.#look(),
      kind: 'image',
      source: copyOf(source),
      box: [x, y, width, height],
      smooth: this.imageSmoothingEnabled,
    });
  }
  /** @param {number} x0 @param {number} y0 @param {number} x1 @param {number} y1 */
  createLinearGradient(x0, y0, x1, y1) {
    /** @type {[number, string][]} */
    const stops = [];
    const addColorStop = (/** @type {number} */ at, /** @type {string} */ colour) => stops.push([at, colour]);
    return { from: [x0, y0], to: [x1, y1], stops, addColorStop };
  }
  /** @param {HTMLCanvasElement} tile */
  createPattern(tile) {
    const pattern = { tile: copyOf(tile), scale: 1 };
    const setTransform = (/** @type {DOMMatrix} */ matrix) => {
      pattern.scale = matrix.a;
    };
    return Object.assign(pattern, { setTransform });
  }

  /** For an outline as exact as a hundredth of a pixel, in whatever it is drawn. */
  #digits() {
    const { a, b } = this.matrix;
    return Math.max(0, 2 + Math.ceil(Math.log10(Math.hypot(a, b))));
  }
  /** @param {Parameters<Outline['rect']>} box */
  #rect(box) {
    const outline = new Outline(this.#digits());
    outline.rect(...box);
    return outline.d;
  }
  /** @returns {Look} */
  #look() {
    return { matrix: this.matrix, clips: this.clips, alpha: this.globalAlpha, fill: null, stroke: null };
  }
  #fill() {
    return { fill: this.fillStyle };
  }
  #stroke() {
    const { strokeStyle: paint, lineWidth: width, dash, lineCap: cap, lineJoin: join } = this;
    return { stroke: { paint, width, dash, cap, join } };
  }
  /** @param {string} d @param {Partial<Look>} paint */
  #shape(d, paint) {
    this.marks.push({ kind: 'shape', d, ...this.#look(), ...paint });
  }
  /** @param {string} text @param {number} x @param {number} y */
  #text(text, x, y) {
    const ascent = this.measureText(text).actualBoundingBoxAscent;
    const shift = measured(this.font, 'alphabetic', text).actualBoundingBoxAscent - ascent;
    return {
      kind: /** @type {const} */ ('text'),
      text,
      x,
      y: y + shift,
      anchor: anchors[this.textAlign],
      font: fontOf(this.font),
    };
  }
}

const anchors = /** @type {const} */ ({
  center: 'middle',
  right: 'end',
  end: 'end',
  left: 'start',
  start: 'start',
});

/** @param {string} font As CSS writes it. @returns {import('./marks.js').Font} */
function fontOf(font) {
  const [, before, size, family] = /^(.*?)([\d.]+)px\s+(.*)$/.exec(font) ?? ['', '', '10', 'sans-serif'];
  return {
    style: before.includes('italic') ? 'italic' : 'normal',
    weight: /\d+/.exec(before)?.[0] ?? (before.includes('bold') ? '700' : '400'),
    size: Number(size),
    family,
  };
}

const ruler = /** @type {CanvasRenderingContext2D} */ (document.createElement('canvas').getContext('2d'));

/** @param {string} font @param {CanvasTextBaseline} baseline @param {string} text */
export function measured(font, baseline, text) {
  ruler.font = font;
  ruler.textBaseline = baseline;
  return ruler.measureText(text);
}

/** @param {HTMLCanvasElement} canvas */
function copyOf(canvas) {
  const copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  copy.getContext('2d')?.drawImage(canvas, 0, 0);
  return copy;
}
