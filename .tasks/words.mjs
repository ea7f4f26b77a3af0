// A Vite plugin by which no file of the site awaits its words: they are there when it is loaded (www/words/pick.js). In Node, and
// in the one file, which has all words in it, each awaits its own.

/** @returns {import('vite').Plugin} */
export const wordsFirst = () => ({
  name: 'words-first',
  transform: (code, id) =>
    /[\\/]words[\\/]index\.js$/.test(id) ? code.replace('await load()', 'load.there()') : undefined,
});
