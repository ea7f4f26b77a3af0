// law
export const law = {
  title: 'The control law',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
