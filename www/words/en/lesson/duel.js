// duel
export const duel = {
  title: 'You against evolution',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
