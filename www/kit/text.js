// Text that comes from others.

/** Without what is no text, ends lines or turns around what stands beside it. @param {string} text */
export const plainText = (text) =>
  text
    .replace(/\p{Cs}|[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069\ufffe\uffff]/gu, '')
    .replace(/\p{Cc}/gu, ' ');

/** The same in one line. @param {string} text */
export const tidyText = (text) => plainText(text).replace(/\s+/g, ' ').trim();

/** The same without what nobody sees. Behind a letter of many scripts, or a picture, what joins, parts or varies it is seen. @param {string} text */
export const seenText = (text) =>
  tidyText(
    text.replace(
      /((?<=[\p{L}\p{M}\p{ExtPict}\p{EMod}]|\p{ExtPict}\ufe0f)(?<![\p{scx=Latn}\p{scx=Grek}\p{scx=Cyrl}\p{scx=Hang}]|(?<!\p{ExtPict})[\p{scx=Zinh}\p{DI}])[\p{Join_C}\p{VS}])|[\p{DI}\u2800\ufff9-\ufffb]/gu,
      '$1',
    ),
  );

/** The beginning of what somebody has given, which may be very long. @param {string} text @param {number} [most] */
export const beginningOf = (text, most = 40) =>
  text.length > most ? `${text.slice(0, most).replace(/[\ud800-\udbff]$/, '')}…` : text;
