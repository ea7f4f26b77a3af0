/** @type {import('../steps.js').Step} */
export const lecturers = {
  name: 'lecturers',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
