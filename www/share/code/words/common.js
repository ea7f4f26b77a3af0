// Of the controller as code, what is the same in every language.
/** @type {readonly { value: import('../languages.js').LanguageName, text: string }[]} */
export const languages = [
  { value: 'python', text: 'Python' },
  { value: 'c', text: 'C' },
  { value: 'matlab', text: 'MATLAB / Octave' },
  { value: 'javascript', text: 'JavaScript' },
];
