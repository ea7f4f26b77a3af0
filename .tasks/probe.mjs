// What npm run heavy puts before the page.
/** Runs in the page before its scripts: `longest` is the longest call of the core on its thread so far, in milliseconds. */
export const probe = `
  window.longest = 0;
  const { get } = Object.getOwnPropertyDescriptor(WebAssembly.Instance.prototype, 'exports');
  const timed = (value) => typeof value !== 'function' ? value : (...args) => {
    const start = performance.now();
    try { return value(...args); } finally { longest = Math.max(longest, performance.now() - start); }
  };
  const known = new WeakMap();
  Object.defineProperty(WebAssembly.Instance.prototype, 'exports', {
    get() {
      let exports = known.get(this);
      if (exports === undefined) {
        exports = Object.fromEntries(Object.entries(get.call(this)).map(([name, value]) => [name, timed(value)]));
        known.set(this, exports);
      }
      return exports;
    },
  });`;
