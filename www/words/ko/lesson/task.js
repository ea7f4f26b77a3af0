// task
export const task = {
  title: '과제를 배웠는가?',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
