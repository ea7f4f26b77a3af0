// Where a browser translates the page, each text gives way to a <font>, to which lit-html then writes the next text as it would to a
// text; a page that shows an old number is worse than one that shows it untranslated.
Object.defineProperty(HTMLFontElement.prototype, 'data', {
  configurable: true,
  set(text) {
    this.replaceWith(text);
  },
});
