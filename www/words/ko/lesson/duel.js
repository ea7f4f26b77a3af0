// duel
export const duel = {
  title: '나와 진화의 대결',
  texts: { begin: '' },
  quizzes: {},
  tries: {},
  notice: [],
};
