/** @type {import('../steps.js').Step} */
export const task = {
  name: 'task',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
