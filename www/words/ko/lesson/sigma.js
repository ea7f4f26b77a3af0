// sigma
export const sigma = {
  title: '스스로 바뀌는 걸음 크기',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
