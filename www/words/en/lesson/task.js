// task
export const task = {
  title: 'Did it learn the task?',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
