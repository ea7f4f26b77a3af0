// The language of the page: chosen once, when it loads.

/** @typedef {keyof typeof languages} Language */

/** What each language calls itself. */
export const languages = { en: 'English', ko: '한국어' };

export const languageNames = /** @type {readonly Language[]} */ (Object.keys(languages));

/** From each to the next, so that one comes to all. @param {Language} name */
export const languageAfter = (name) =>
  languageNames[(languageNames.indexOf(name) + 1) % languageNames.length];

/** The language of a link without one. */
export const usualLanguage = 'en';

/** @param {string} name @returns {name is Language} */
const isLanguage = (name) => Object.hasOwn(languages, name);

/**
 * A link is shown as it was written. Where there is none, in the language of the browser.
 * @param {string} link the text after # @param {readonly string[]} preferred by the reader, as a browser tells it
 * @returns {Language}
 */
export function languageOf(link, preferred) {
  const named = /[&?](?:amp;)?lang=(\w+)/.exec(link)?.[1] ?? '';
  if (isLanguage(named)) return named;
  if (link !== '') return usualLanguage;
  return preferred.map((tag) => tag.split('-')[0].toLowerCase()).find(isLanguage) ?? usualLanguage;
}

/** The language of the address as it is now. */
export const languageOfAddress = () => languageOf(location.hash.slice(1), navigator.languages ?? []);

/** Outside of a page there is no address. */
export const language = globalThis.location ? languageOfAddress() : usualLanguage;
