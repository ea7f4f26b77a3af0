// limits
export const limits = {
  title: '바퀴의 한계',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
