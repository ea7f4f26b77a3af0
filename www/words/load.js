// The words of the page itself, in its language, which alone is loaded.
/** @import { Language } from './language.js' */
import { picked } from './pick.js';

/** @template T @typedef {import('./pick.js').Words<T>} Words */
/** @template T @typedef {{ [Part in keyof T]: Words<T[Part]> }} Parts */

/** @typedef {{ en: typeof import('./en/index.js'), ko: typeof import('./ko/index.js') }} Spoken */
/** No language has a word that another lacks. @typedef {import('./pick.js').Each<{ [L in Language]: Parts<Spoken[L]> }[Language]>} All */

/** @type {{ [L in Language]: () => Promise<All> }} */
const languages = { en: () => import('./en/index.js'), ko: () => import('./ko/index.js') };

export const load = picked(/** @type {{ [L in Language]: () => Promise<any> }} */ (languages));
