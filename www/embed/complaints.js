// What the element says in sight of what its page's author has wrong, each thing on a line of its own.

/** @typedef {'height' | 'link' | 'refusal'} About What it is about, or that no figure answers. */

/** @param {(message: string) => void} tell Of each that is new. */
export function createComplaints(tell) {
  const element = document.createElement('p');
  element.setAttribute('role', 'alert');
  /** @type {Map<About, string>} */
  const said = new Map();

  /** @param {About} about @param {string} message Nothing, where it is right again. */
  const say = (about, message) => {
    if (message === (said.get(about) ?? '')) return;
    said.delete(about);
    if (message) said.set(about, message);
    element.textContent = [...said.values()].map((one) => `<ep-locomotion>: ${one}`).join('\n');
    if (message) tell(message);
  };

  return {
    element,
    say,

    /** Another run, or another figure, begins. */
    beginAnew() {
      say('link', '');
      say('refusal', '');
    },
  };
}
