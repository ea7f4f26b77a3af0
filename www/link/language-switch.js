// The link to the same page in another language.
/** @import { Language } from '../words/language.js' */
import { byId } from '../kit/elements.js';
import { language, languageAfter, languages } from '../words/language.js';

/** @param {(language: Language) => string} linkIn The link of what is on screen. */
export function createLanguageSwitch(linkIn) {
  const other = languageAfter(language);
  /** @type {HTMLAnchorElement} */
  const link = byId('language');
  Object.assign(link, { textContent: languages[other], lang: other, hreflang: other, hidden: false });
  /** @type {string | null} */
  let pressed = null;
  const follow = () => {
    const there = linkIn(other);
    link.setAttribute('href', `#${there}`);
    return there;
  };
  // What moves is written into no address: only a press takes it along as it is now.
  link.addEventListener('click', () => {
    pressed = follow();
  });
  return {
    follow,
    /** The link that was pressed: the run may have gone on when it is opened. */
    pressed: () => pressed,
  };
}
