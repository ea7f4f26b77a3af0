// disturbance
export const disturbance = {
  title: '바닥이 밀 때',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
