// landscape
export const landscape = {
  title: '진화가 지나온 지형',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
