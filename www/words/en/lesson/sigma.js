// sigma
export const sigma = {
  title: 'A step size that adapts itself',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
