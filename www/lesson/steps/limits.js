/** @type {import('../steps.js').Step} */
export const limits = {
  name: 'limits',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
