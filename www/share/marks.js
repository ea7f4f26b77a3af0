// What a picture is made of, between the screen and a file: shapes, texts and images, in the order in which they lie on each other.

/** @typedef {{ d: string, matrix: DOMMatrix }} Clip An outline that cuts what is drawn, in the pixels of the picture. */
/** @typedef {{ from: readonly [number, number], to: readonly [number, number], stops: [number, string][] }} Gradient */
/** @typedef {{ tile: HTMLCanvasElement, scale: number }} Pattern */
/** @typedef {string | Gradient | Pattern} Paint */
/** @typedef {{ paint: Paint, opacity?: number, width: number, dash: number[], cap: string, join: string }} Stroke */
/** @typedef {{ style: string, weight: string, size: number, family: string }} Font */
/** @typedef {{ matrix: DOMMatrix, clips: readonly Clip[], alpha: number, fill: Paint | null, fillOpacity?: number, stroke: Stroke | null }} Look The stroke of a text lies under its fill, that of a shape over it. */
/** @typedef {Look & { kind: 'shape', d: string }} Shape */
/** @typedef {Look & { kind: 'text', text: string, x: number, y: number, anchor: 'start' | 'middle' | 'end', font: Font }} Text Its y is that of the baseline. */
/** @typedef {Look & { kind: 'image', source: HTMLCanvasElement, box: readonly [number, number, number, number], smooth: boolean }} Image */
/** @typedef {Shape | Text | Image} Mark */
/** @typedef {{ title: string, description: string, link: string, version: string }} About What a file says of itself. */
/** @typedef {{ width: number, height: number, paper: string, marks: Mark[] }} Drawing In pixels of CSS. */

/** @param {Gradient | Pattern} paint @returns {paint is Gradient} */
export const isGradient = (paint) => 'stops' in paint;

/** A path as SVG writes it, built by the methods of a canvas. */
export class Outline {
  d = '';

  /** @param {number} digits After the decimal point. */
  constructor(digits) {
    this.digits = digits;
  }

  /** @param {string} command @param {number[]} numbers */
  #add(command, ...numbers) {
    // A canvas leaves out what has no place.
    if (numbers.every(Number.isFinite))
      this.d += command + numbers.map((n) => +n.toFixed(this.digits)).join(' ');
  }

  /** @param {number} x @param {number} y */
  moveTo(x, y) {
    this.#add('M', x, y);
  }

  /** @param {number} x @param {number} y */
  lineTo(x, y) {
    this.#add(this.d ? 'L' : 'M', x, y);
  }

  closePath() {
    this.d += 'Z';
  }

  /** @param {number} x @param {number} y @param {number} width @param {number} height */
  rect(x, y, width, height) {
    this.#add('M', x, y);
    this.#add('h', width);
    this.#add('v', height);
    this.#add('h', -width);
    this.closePath();
  }

  /** From less to more, at most a turn. @param {number} x @param {number} y @param {number} r @param {number} from @param {number} to */
  arc(x, y, r, from, to) {
    const at = (/** @type {number} */ part) => {
      const direction = from + part * (to - from);
      return /** @type {const} */ ([x + r * Math.cos(direction), y + r * Math.sin(direction)]);
    };
    this.lineTo(...at(0));
    // In two halves, because an arc that ends where it begins is none.
    for (const part of [0.5, 1]) this.#add('A', r, r, 0, 0, 1, ...at(part));
  }
}
