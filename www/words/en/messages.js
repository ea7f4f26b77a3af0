// What the core, the workers and the browser say when something is refused or fails: it is English already.

/** @param {string} message */
export const said = (message) => message;
