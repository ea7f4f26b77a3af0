// stability
export const stability = {
  title: '왜 도착하는가',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
