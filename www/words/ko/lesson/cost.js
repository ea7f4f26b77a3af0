// cost
export const cost = {
  title: '좋은 주행이란?',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
