// A Vite plugin by which no file of the site awaits its words: they are there when it is loaded (www/words/pick.js). In Node, and
// in the one file, which has all words in it, each awaits its own.

const awaited = 'await load()';

/** @returns {import('vite').Plugin} */
export const wordsFirst = () => ({
  name: 'words-first',
  transform(code, id) {
    if (!/[\\/]words[\\/]index\.js$/.test(id)) return;
    if (!code.includes(awaited)) this.error(`the words are not there by ${awaited}`);
    return code.replace(awaited, 'load.there()');
  },
});
