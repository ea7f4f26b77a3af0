// generation
export const generation = {
  title: '한 세대를 손으로',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
