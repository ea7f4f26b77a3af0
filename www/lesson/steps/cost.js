/** @type {import('../steps.js').Step} */
export const cost = {
  name: 'cost',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
