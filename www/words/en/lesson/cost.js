// cost
export const cost = {
  title: 'What is a good drive?',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
