// Of the settings, what is the same in every language.

/** A number with its unit. @param {string} number @param {string} unit */
export const quantity = (number, unit) =>
  `${number.replace('-', '−')}${unit.startsWith('°') || unit === '' ? '' : ' '}${unit}`;

/** @typedef {{ name: string, help: string, choices?: Readonly<Record<string, string>> }} SettingWords */

/**
 * Makes of the paths that a message of the core names the names on screen: the longer ones first, for they may begin with
 * a shorter one. The law's is a word that also stands for itself.
 * @param {Readonly<Record<string, { name: string }>>} settings
 */
export function namer(settings) {
  const names = Object.entries(settings)
    .filter(([path]) => path !== 'law')
    .sort(([a], [b]) => b.length - a.length);
  return (/** @type {string} */ message) =>
    names.reduce((text, [path, { name }]) => text.replaceAll(path, name), message);
}
