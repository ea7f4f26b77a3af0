// Code in colours: its comments, and the symbols that have a colour everywhere on the page.

/** A piece of code, and the class of its colour. @typedef {readonly [kind: string, text: string]} Token */

const symbols = { x: 'KX|xe', y: 'KY|ye', theta: 'KTHETA|te', linear: 'v', angular: 'w' };
const kinds = Object.keys(symbols);

/** @param {string} text @param {string} mark of comments @returns {Token[]} */
export function tokensOf(text, mark) {
  const groups = Object.entries(symbols).map(([kind, names]) => `(?<${kind}>\\b(?:${names})\\b)`);
  const pattern = new RegExp(
    `(?<comment>"""[^"]*"""|${mark}[^\\n]*)|(?<string>"[^"\\n]*")|${groups.join('|')}`,
    'g',
  );
  /** @type {Token[]} */
  const tokens = [];
  let from = 0;
  for (const match of text.matchAll(pattern)) {
    const groups = match.groups ?? {};
    const kind = ['comment', ...kinds].find((one) => groups[one] !== undefined) ?? '';
    tokens.push(['', text.slice(from, match.index)], [kind, match[0]]);
    from = match.index + match[0].length;
  }
  return [...tokens, ['', text.slice(from)]];
}
