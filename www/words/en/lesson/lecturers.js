// lecturers
export const lecturers = {
  title: 'For lecturers',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
