/** @type {import('../steps.js').Step} */
export const law = {
  name: 'law',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
