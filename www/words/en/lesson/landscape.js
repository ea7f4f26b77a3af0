// landscape
export const landscape = {
  title: 'The landscape it climbed',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
