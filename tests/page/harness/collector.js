// Runs in the page before its own scripts and keeps what goes wrong, for engines have no common way to ask for it.
(() => {
  /** @type {string[]} */
  const problems = [];
  Object.defineProperty(window, 'collectedProblems', { value: problems });

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
      else problems.push(`uncaught: ${event.message} (${event.filename}:${event.lineno})`);
    },
    true,
  );
  addEventListener('unhandledrejection', (event) => {
    problems.push(`unhandled rejection: ${event.reason}\n${event.reason?.stack ?? ''}`);
  });
  addEventListener('securitypolicyviolation', (event) => {
    problems.push(`policy: ${event.violatedDirective} refuses ${event.blockedURI} ${event.sample}`);
  });
})();
