// How programs are written down, in whatever language: numbers, comments, lines that are there or not.

/** What a line holds that is not to be there. */
const absent = '\0';

/**
 * A piece of a program. A line that holds nothing but a value that is null is left out; a value of several lines is indented as
 * its first. Backslashes are the program's own.
 * @param {{ raw: readonly string[] }} strings @param {(string | number | null)[]} values
 */
export function code({ raw }, ...values) {
  let text = raw[0];
  for (const [i, value] of values.entries()) {
    const margin = /(?:^|\n)([ \t]*)$/.exec(text)?.[1] ?? '';
    text += (value === null ? absent : String(value)).replaceAll('\n', `\n${margin}`) + raw[i + 1];
  }
  return text.replace(/^\n/, '').replace(/^[ \t]*\0\n/gm, '');
}

/** A line that is there in some drives. @param {boolean} isThere @param {string} line */
export const when = (isThere, line) => (isThere ? line : null);

/** C has no whole number of more than 18 digits. @param {number} value */
const shortest = (value) => {
  const size = Math.abs(value);
  return (size < 1e-4 && size > 0) || size >= 1e18 ? value.toExponential() : String(value);
};

/** A number with all its digits, as every language here reads it. @param {number} value @param {string} infinity */
export const literal = (value, infinity) =>
  Object.is(value, -0)
    ? '-0.0'
    : Number.isFinite(value)
      ? shortest(value)
      : `${value < 0 ? '-' : ''}${infinity}`;

/** Korean letters are twice as wide. @param {string} text */
const widthOf = (text) => Array.from(text).reduce((sum, letter) => sum + (letter >= '\u1100' ? 2 : 1), 0);

/** So many letters fit in a line of a comment. */
const mostInLine = 88;

/** Sentences as lines of a comment, each with its mark. @param {string} text @param {string} mark */
export function comment(text, mark) {
  /** @type {string[]} */
  const lines = [];
  let line = '';
  for (const word of text.split(' ')) {
    const longer = line === '' ? word : `${line} ${word}`;
    if (line !== '' && widthOf(longer) + widthOf(mark) > mostInLine) {
      lines.push(line);
      line = word;
    } else line = longer;
  }
  return [...lines, line].map((one) => mark + one).join('\n');
}

/** Texts, each with its comment beside it, and the comments below each other. @param {readonly (readonly [text: string, comment: string])[]} rows @param {string} mark */
export function beside(rows, mark) {
  const width = Math.max(...rows.map(([text]) => text.length));
  return rows.map(([text, about]) => `${text.padEnd(width)}${mark}${about}`).join('\n');
}
