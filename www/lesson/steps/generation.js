/** @type {import('../steps.js').Step} */
export const generation = {
  name: 'generation',
  link: 'lab',
  figure: 'drive',
  blocks: [{ kind: 'text', name: 'begin' }],
};
