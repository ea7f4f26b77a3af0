/** @type {import('../steps.js').Step} */
export const sigma = {
  name: 'sigma',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
