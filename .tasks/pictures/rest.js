// Runs in the page before its own scripts and knows whether the page is at rest: no frame asked for, no worker at
// work, and neither a message to or from one nor a file for a while.
(() => {
  const { now } = performance;
  const time = now.bind(performance);
  // What the page tells of its own speed would be another number each time.
  performance.now = () => 0;

  let parts = 0;
  let heard = time();
  window.Worker = class extends Worker {
    #parts = 0;

    /** @param {ConstructorParameters<typeof Worker>} args */
    constructor(...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        heard = time();
        if (data && ('result' in data || 'error' in data)) this.#count(-1);
      });
    }

    /** @param {number} more */
    #count(more) {
      this.#parts += more;
      parts += more;
    }

    /** @param {any} message @param {any} [options] */
    postMessage(message, options) {
      heard = time();
      if (message && 'call' in message) this.#count(1);
      super.postMessage(message, options);
    }

    terminate() {
      this.#count(-this.#parts);
      super.terminate();
    }
  };

  // A module that came, as *Hand in* does after the page is ready, has still to be drawn.
  new PerformanceObserver(() => {
    heard = time();
  }).observe({ type: 'resource' });

  const own = /** @type {{ pageFrames: { areNone: () => boolean } }} */ (/** @type {unknown} */ (window));
  const quiet = 150;
  Object.defineProperty(window, 'isAtRest', {
    value: () =>
      document.documentElement.dataset.ready === 'true' &&
      own.pageFrames.areNone() &&
      !document.querySelector('.part-waits') &&
      parts === 0 &&
      time() - heard > quiet,
  });
})();
