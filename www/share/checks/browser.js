// What a browser calls itself, in short.

/** The more special name first, because browsers call themselves by older ones too. */
const names = /** @type {const} */ ([
  ['Edg', 'Edge'],
  ['OPR', 'Opera'],
  ['SamsungBrowser', 'Samsung Internet'],
  ['Firefox', 'Firefox'],
  ['FxiOS', 'Firefox'],
  ['CriOS', 'Chrome'],
  ['Chrome', 'Chrome'],
  ['Version', 'Safari'],
]);

/** Name and version; the whole text if no name in it is known. @param {string} userAgent */
export function browserOf(userAgent) {
  for (const [mark, name] of names) {
    const version = new RegExp(`${mark}/(\\d+)`).exec(userAgent)?.[1];
    if (version) return `${name} ${version}`;
  }
  return userAgent;
}
