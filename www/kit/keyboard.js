// What keys mean where something is moved with them.

/** @type {Record<string, readonly [right: number, up: number]>} */
const arrows = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** The direction of an arrow key, null for others. @param {string} key */
export const arrowOf = (key) => arrows[key] ?? null;

/** The name of a key in lower case; what writes another script is known by its place. @param {KeyboardEvent} event */
export const letterOf = ({ key, code }) =>
  // What an input method takes for itself is called so, whatever it writes.
  (/^(?!Process$)[\p{sc=Latin}\p{sc=Common}\p{sc=Inherited}]/u.test(key)
    ? key
    : code.replace(/^Key/, '')
  ).toLowerCase();

/** With these keys it means something to the browser. @param {KeyboardEvent} event */
export const isChord = ({ ctrlKey, metaKey, altKey }) => ctrlKey || metaKey || altKey;

/** Whether Escape takes back what is being typed, and then nothing else. @param {KeyboardEvent} event @param {boolean} isTyping */
export function takesBack(event, isTyping) {
  if (event.key !== 'Escape' || event.isComposing || !isTyping) return false;
  event.preventDefault();
  return true;
}
