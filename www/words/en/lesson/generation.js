// generation
export const generation = {
  title: 'One generation by hand',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
