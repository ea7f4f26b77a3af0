/** @type {import('../steps.js').Step} */
export const paper = {
  name: 'paper',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
