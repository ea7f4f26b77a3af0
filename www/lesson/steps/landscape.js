/** @type {import('../steps.js').Step} */
export const landscape = {
  name: 'landscape',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
