/** @type {import('../steps.js').Step} */
export const duel = {
  name: 'duel',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
