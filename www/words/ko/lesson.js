// What is said of the lesson before it is loaded.

export const texts = { lesson: '수업' };

export const nav = '수업';
export const tagline =
  '예측하고, 해 보고, 확인하고, 설명합니다. 실험실의 화면으로 방법을 한 단계씩 익힙니다.';
/** Of its steps, in their order. */
export const titles = {
  drive: '직접 몰아 보기',
  error: '목표는 어디에 있는가?',
  law: '제어 법칙을 한 항씩',
  stability: '왜 도착하는가',
  limits: '바퀴가 할 수 없는 것',
  cost: '좋은 주행이란 무엇인가?',
  generation: '한 세대 따라가 보기',
  sigma: '스스로 적응하는 변이 폭',
  duel: '나와 진화의 대결',
  landscape: '진화가 탐색한 비용 지형',
  contest: '어느 부분이 효과를 내는가?',
  task: '주차를 배운 것인가?',
  disturbance: '바닥이 밀 때',
  paper: '논문의 수치와 이 페이지의 수치',
  build: '직접 만들어 보기',
  lecturers: '강의하는 분께',
};
