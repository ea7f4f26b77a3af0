// What is said of its own accord to who cannot see it, by the lab and by the open part.
import { byId } from '../kit/elements.js';

const pauseMilliseconds = 2000;
/** After the last step of a slider. */
export const settlingMilliseconds = 1000;

/** What is still to be said: the newest of each. @type {Map<string, string>} */
const waiting = new Map();
/** @type {ReturnType<typeof setTimeout> | undefined} */
let timer;

function speak() {
  timer = undefined;
  const region = byId('announcer');
  const text = [...waiting.values()].join('. ');
  waiting.clear();
  if (text === '' || region.textContent === text) return;
  region.textContent = text;
  timer = setTimeout(speak, pauseMilliseconds);
}

/** Speaks the newest sentence, at most every two seconds, or once no other has come for as long as it is to wait. @param {string} who @param {string} sentence */
export function announce(who, sentence, wait = 0) {
  waiting.delete(who);
  waiting.set(who, sentence);
  if (wait > 0) {
    clearTimeout(timer);
    timer = setTimeout(speak, wait);
  } else if (timer === undefined) speak();
}

/** Says what stands in words under a picture when it has become another: once the hand rests, and nothing while it is to be quiet. @param {string} who */
export function createTeller(who) {
  /** @type {string | null} */
  let last = null;
  return (/** @type {string} */ text, /** @type {boolean} */ isQuiet) => {
    const before = last;
    if (text === (before ?? '') || (isQuiet && before !== null)) return;
    last = text;
    // What is there from the beginning, once it has words, is read in its place.
    if (before !== null && text !== '') announce(who, text, settlingMilliseconds);
  };
}
