// What stands in the place of the robots until they drive, and stays where they cannot: why, a picture, the lesson to read.
import { byId, create } from './kit/elements.js';
import { watch } from './kit/memo.js';
import { isLost, messageOf } from './words/errors.js';
import { instead as words } from './words/index.js';
import { language } from './words/language.js';

/** The shortest module that needs SIMD. */
const simd = Uint8Array.of(
  ...[0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123],
  ...[3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11],
);

/** @param {unknown} error */
function reasonOf(error) {
  if (typeof WebAssembly === 'undefined') return words.reasons.absent;
  if (/content security policy|\bcsp\b|unsafe-eval/i.test(String(error))) return words.reasons.forbidden;
  if (!WebAssembly.validate(simd)) return words.reasons.old;
  if (/out of memory|cannot allocate/i.test(String(error))) return words.reasons.full;
  return words.notLoaded(messageOf(error));
}

/** Out of the document, for an exercise may hide what it tells; should the page fail on its last steps, it is wanted again. */
const taken = document.createDocumentFragment();

/** From a copy that a browser has saved to the page. */
const original = /** @type {HTMLAnchorElement} */ (create('a', {}));

const isOther = watch();

/** It leads to what is on screen when the page is saved. */
export function followAddress() {
  if (!isOther(location.href, document.title)) return;
  original.href = location.href;
  original.textContent = document.title;
}

/** The robots drive. In its place stands, for a browser that saves the page, what its copy is: a shadow that is not saved covers it. */
export function takeInstead() {
  const copy = create('div', { id: 'copy' }, create('p', 'message', words.copy, ' ', original));
  followAddress();
  copy.attachShadow({ mode: 'open' });
  byId('instead').before(copy);
  taken.append(byId('instead'));
}

/** Says why they do not, and keeps what there is to read. @param {unknown} error @returns {string} what it says */
export function showInstead(error) {
  byId('instrument').hidden = true;
  // A figure would have its title in its foot.
  document.body.removeAttribute('data-embed');
  byId('instrument').before(taken);
  const instead = byId('instead');
  const why = words.cannot(reasonOf(error));
  sayBefore(instead, why);
  instead.className = 'instead';
  for (const element of instead.querySelectorAll('.instead-why, [lang]'))
    if (element.getAttribute('lang') !== language) element.remove();
  for (const details of instead.querySelectorAll('details')) details.open = true;
  return why;
}

/** In a place of its own, for the page may still draw. @param {HTMLElement} place @param {string} text */
function sayBefore(place, text) {
  place.before(create('p', { class: 'message', role: 'alert' }, text));
}

/** After a panic or a trap the core must not be used again: whatever is pressed then might be answered wrongly. @param {(why: string) => void} onFailure */
export function watchCore(onFailure) {
  /** @param {unknown} error */
  const stop = (error) => {
    const instrument = byId('instrument');
    if (!isLost(error) || instrument.inert) return;
    /** @type {NodeListOf<HTMLElement>} */
    const all = document.querySelectorAll('#instrument, .masthead');
    for (const part of all) part.inert = true;
    sayBefore(instrument, words.stopped);
    onFailure(words.stopped);
  };
  addEventListener('error', (event) => stop(event.error));
  addEventListener('unhandledrejection', (event) => stop(event.reason));
}
