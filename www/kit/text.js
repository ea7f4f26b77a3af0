// Text that comes from others.

/** Without what is no text, ends lines or turns around what stands beside it. @param {string} text */
export const plainText = (text) =>
  text
    .replace(/\p{Cs}|[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069\ufffe\uffff]/gu, '')
    .replace(/\p{Cc}/gu, ' ');

/** The same in one line. @param {string} text */
export const tidyText = (text) => plainText(text).replace(/\s+/g, ' ').trim();

/** The same without what nobody sees. What parts or joins letters in Arabic and behind the vowel killers of India is seen. @param {string} text */
export const seenText = (text) =>
  tidyText(
    text.replace(
      /([\u094d\u09cd\u0a4d\u0acd\u0b4d\u0bcd\u0c4d\u0ccd\u0d4d\u0dca][\u200c\u200d]|\p{sc=Arab}\u200c(?=\p{sc=Arab}))|[\p{DI}\u2800\ufff9-\ufffb]/gu,
      '$1',
    ),
  );

/** The beginning of what somebody has given, which may be very long. @param {string} text @param {number} [most] */
export const beginningOf = (text, most = 40) =>
  text.length > most ? `${text.slice(0, most).replace(/[\ud800-\udbff]$/, '')}…` : text;
