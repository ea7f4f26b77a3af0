// Runs in the page before its own scripts and keeps what goes wrong, for engines have no common way to ask for it.
(() => {
  /** @type {string[]} */
  const problems = [];
  Object.defineProperty(window, 'collectedProblems', { value: problems });

  /** What nobody has caught is told after the page is left, too. @param {string} problem */
  const keep = (problem) => {
    problems.push(problem);
    try {
      const before = sessionStorage.getItem('uncaught') ?? '';
      sessionStorage.setItem('uncaught', `${before}${problem}\n`);
    } catch {
      // A frame without an origin has no storage.
    }
  };

  // Firefox breaks off what is still loaded when a page is left, and tells the page.
  let isLeft = false;
  addEventListener('beforeunload', () => {
    isLeft = true;
  });
  const isBrokenOff = (/** @type {string} */ message) =>
    isLeft && message.includes('error loading dynamically imported module');

  const consoleError = console.error;
  console.error = (...values) => {
    problems.push(`console.error: ${values.map(String).join(' ')}`);
    consoleError.apply(console, values);
  };
  // Errors in workers arrive here too, unless the page takes them as dealt with.
  addEventListener(
    'error',
    (event) => {
      if (event.target instanceof Element) problems.push(`not loaded: ${event.target.outerHTML}`);
      else if (!isBrokenOff(event.message))
        keep(`uncaught: ${event.message} (${event.filename}:${event.lineno})`);
    },
    true,
  );
  addEventListener('unhandledrejection', (event) => {
    keep(`unhandled rejection: ${event.reason}\n${event.reason?.stack ?? ''}`);
  });
  addEventListener('securitypolicyviolation', (event) => {
    problems.push(`policy: ${event.violatedDirective} refuses ${event.blockedURI} ${event.sample}`);
  });
})();
