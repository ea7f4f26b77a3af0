// In the page: texts on canvases that begin or end outside of them.

/** From now on they are kept. */
export function keepCut() {
  const { fillText } = CanvasRenderingContext2D.prototype;
  /** @type {Set<string>} */
  const cut = new Set();
  Object.assign(window, { cut });
  CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
    const { actualBoundingBoxLeft: left, actualBoundingBoxRight: right } = this.measureText(text);
    const [from, to] = [-left, right].map((side) => this.getTransform().transformPoint({ x: x + side, y }).x);
    const { width } = this.canvas;
    // What is wholly outside is not seen.
    if ((from < -1 && to > 0) || (to > width + 1 && from < width)) cut.add(`“${text}” is cut`);
    fillText.call(this, text, x, y);
  };
}

/** Those that were found since one asked last. */
export function takeCut() {
  const { cut } = /** @type {{ cut: Set<string> }} */ (/** @type {unknown} */ (window));
  const all = [...cut];
  cut.clear();
  return all;
}
