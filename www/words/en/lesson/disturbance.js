// disturbance
export const disturbance = {
  title: 'When the ground pushes',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
