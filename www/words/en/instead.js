// Every word of what stands in the place of the robots where they cannot drive.

export const waits =
  'No robots yet? The network is slow, this browser cannot run the page, or a file of it is missing. Chrome and Edge from 109, Firefox from 115 and Safari from 16.4 run it, with scripts and WebAssembly allowed. From a disk open ep-locomotion.html, which is all of it.';

/** @param {string} reason */
export const cannot = (reason) =>
  `The robots cannot drive here: ${reason} Chrome and Edge from 109, Firefox from 115 and Safari from 16.4 run this page, with WebAssembly allowed; the lesson can be read here all the same.`;

export const reasons = {
  absent: 'this browser has no WebAssembly, or it is switched off.',
  old: 'the WebAssembly of this browser is too old, it has no SIMD.',
  forbidden:
    'the server that sends this page forbids WebAssembly (its content security policy lacks wasm-unsafe-eval).',
  full: 'this browser has no memory left for them. Close other tabs, then load the page again.',
};
/** @param {string} message */
export const notLoaded = (message) =>
  `a part of the page could not be loaded (${message}). See that there is a network and that you are logged in, then load the page again.`;

/** Before a link to the page. */
export const copy =
  'A browser saved this copy: nothing in it works. Download ep-locomotion.html, or open the page:';

export const stopped =
  'An error within the program has stopped it. Please reload the page: its address brings back what was on screen.';

/** @param {number} robots @param {number} generation @param {string} first @param {string} best */
export const caption = (robots, generation, first, best) =>
  `${robots} robots with random gains drive to the goal, the best of them with J ${first}. The thick line is the best after ${generation} generations of evolution, with J ${best}.`;

export const article = 'The lesson, to read';
export const articleNote =
  'The words of the lesson without its sliders, questions and things to try, of which they speak at times. The same program worked out the numbers when this page was made.';
