/** @type {import('../steps.js').Step} */
export const stability = {
  name: 'stability',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
