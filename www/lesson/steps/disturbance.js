/** @type {import('../steps.js').Step} */
export const disturbance = {
  name: 'disturbance',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
