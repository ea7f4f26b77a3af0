// Runs in the page before its own scripts and knows whether the page is at rest: no frame asked for, no worker at
// work, and no message to or from one for a while.
(() => {
  const frames = new Set();
  const { requestAnimationFrame: ask, cancelAnimationFrame: cancel } = window;
  window.requestAnimationFrame = (callback) => {
    const id = ask((now) => {
      frames.delete(id);
      callback(now);
    });
    frames.add(id);
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    frames.delete(id);
    cancel(id);
  };

  let parts = 0;
  let heard = performance.now();
  window.Worker = class extends Worker {
    #parts = 0;

    /** @param {ConstructorParameters<typeof Worker>} args */
    constructor(...args) {
      super(...args);
      this.addEventListener('message', ({ data }) => {
        heard = performance.now();
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
      heard = performance.now();
      if (message && 'call' in message) this.#count(1);
      super.postMessage(message, options);
    }

    terminate() {
      this.#count(-this.#parts);
      super.terminate();
    }
  };

  const quiet = 150;
  Object.defineProperty(window, 'isAtRest', {
    value: () =>
      document.documentElement.dataset.ready === 'true' &&
      frames.size === 0 &&
      parts === 0 &&
      performance.now() - heard > quiet,
  });
})();
