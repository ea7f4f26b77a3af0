// limits
export const limits = {
  title: 'What the wheels cannot do',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
