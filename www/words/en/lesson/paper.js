// paper
export const paper = {
  title: 'The paper’s numbers and ours',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
