// Runs in the page before its own scripts: knows when the page has drawn what happened, and can let every frame come late.
(() => {
  const ask = window.requestAnimationFrame.bind(window);
  /** By how many milliseconds every frame comes late. */
  const late = Number(document.currentScript?.dataset.late);
  /** While a frame that changes something is waited for, how long at most: what nobody sees gets no frames. */
  const patience = 10_000;

  /**
   * The frames that are asked for, each with how many frames it comes of: none, or one where a frame has measured what is to be
   * drawn, or ever more of them in motion. @type {Map<number, number>}
   */
  const asked = new Map();
  let depth = 0;
  /** How many times as fast the time of the frames runs. */
  let pace = 1;

  let latest = 0;

  window.requestAnimationFrame = (callback) => {
    latest += 1;
    const id = latest;
    const depthOfThis = depth;
    asked.set(id, depthOfThis);
    const run = (/** @type {number} */ now) => {
      if (!asked.delete(id)) return;
      depth = depthOfThis + 1;
      try {
        callback(pace * now);
      } finally {
        depth = 0;
      }
    };
    // Out of sight there is no late frame either.
    if (late > 0) setTimeout(() => ask(run), late);
    else ask(run);
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    asked.delete(id);
  };

  /** The next frame, with what the page hears of its new sizes after it; whether it came. */
  const frame = () =>
    new Promise((resolve) => {
      ask(() => setTimeout(() => resolve(true)));
      setTimeout(() => resolve(false), patience);
    });

  /** So many frames in vain are no busy machine. */
  const endless = 100;

  /** Waits for every frame that is asked for, and for those that come of what these changed; motion goes on. */
  async function drawn() {
    const end = performance.now() + patience;
    let frames = 0;
    const before = [...asked.keys()];
    const isDrawn = () =>
      !before.some((id) => asked.has(id)) && [...asked.values()].every((count) => count > 1);
    while (!isDrawn() && performance.now() < end) if (await frame()) frames += 1;
    if (frames > endless && !isDrawn()) throw new Error('drawing without end: each asks for the next');
  }

  /** Whether nothing is to be drawn. */
  const areNone = () => asked.size === 0;

  /** @param {number} times */
  const setPace = (times) => {
    pace = times;
  };

  Object.defineProperty(window, 'pageFrames', { value: { drawn, areNone, setPace } });
})();
