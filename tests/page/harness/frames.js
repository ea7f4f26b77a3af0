// Runs in the page before its own scripts: knows when the page has drawn what happened, and can let every frame, and every answer
// of a worker, come late.
(() => {
  const ask = window.requestAnimationFrame.bind(window);
  /** By how many milliseconds they come late. */
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
        setTimeout(tell);
      }
    };
    // Out of sight there is no late frame either.
    if (late > 0) setTimeout(() => ask(run), late);
    else ask(run);
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    asked.delete(id);
    setTimeout(tell);
  };

  /** Who waits for the next frame. @type {Set<(came: boolean) => void>} */
  const waiting = new Set();

  /** After a frame, and what the page hears of its new sizes after it. */
  function tell() {
    for (const resolve of waiting) resolve(true);
    waiting.clear();
  }

  /** The next frame that somebody asks for: one that is asked for only to wait costs every engine its work. @returns {Promise<boolean>} whether it came */
  const frame = () =>
    new Promise((resolve) => {
      waiting.add(resolve);
      setTimeout(() => waiting.delete(resolve) && resolve(false), patience);
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

  /** A frame of the engine, however late those of the page come, and all that comes of what the page hears in it. */
  async function settled() {
    await new Promise((resolve) => ask(() => setTimeout(resolve)));
    await drawn();
  }

  /** Whether nothing is to be drawn. */
  const areNone = () => asked.size === 0;

  /** @param {number} times */
  const setPace = (times) => {
    pace = times;
  };

  if (late > 0) {
    /** What was held back and is on its way again. @type {WeakSet<Event>} */
    const held = new WeakSet();
    window.Worker = class extends Worker {
      /** @param {ConstructorParameters<typeof Worker>} args */
      constructor(...args) {
        super(...args);
        // Before whoever made it listens.
        this.addEventListener('message', (event) => {
          if (held.has(event)) return;
          event.stopImmediatePropagation();
          const again = new MessageEvent('message', { data: event.data, ports: [...event.ports] });
          held.add(again);
          setTimeout(() => this.#isEnded || this.dispatchEvent(again), late);
        });
      }

      #isEnded = false;

      /** @override */
      terminate() {
        this.#isEnded = true;
        super.terminate();
      }
    };
  }

  Object.defineProperty(window, 'pageFrames', { value: { drawn, settled, areNone, setPace } });
})();
