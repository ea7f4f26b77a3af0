// law
export const law = {
  title: '제어 법칙',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
