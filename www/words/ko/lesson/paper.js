// paper
export const paper = {
  title: '논문의 수치와 이 페이지의 수치',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
