// stability
export const stability = {
  title: 'Why it gets there',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
