// lecturers
export const lecturers = {
  title: '강의하는 분께',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
