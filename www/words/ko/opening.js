// Every word about what is loaded on demand, in Korean.

export const waits = '이 부분을 불러오는 중입니다…';
export const failed =
  '페이지의 이 부분을 불러오지 못했습니다. 네트워크가 끊겼거나, 새 버전이 나와 파일이 바뀌었거나, 다시 로그인해야 할 수 있습니다. 나머지는 그대로 쓸 수 있습니다.';
export const anew = '다시 시도하면 페이지를 새로 불러오며, 지금 있는 것은 그대로 돌아옵니다.';
/** Of a run of which another has taken the place. */
export const back = '브라우저의 뒤로 버튼을 누르면 이전에 열려 있던 실험으로 돌아갑니다.';
export const still = '아직 불러올 수 없습니다.';
export const again = '다시 시도';

export const texts = {
  keepButton: '공유',
  keepTitle: '이 실험의 공유와 저장',
  checksButton: '계산 검사',
  checksTitle: '계산이 맞습니까?',
  codeTitle: '제어기 코드',
  collectTitle: '제출물 확인',
  close: '닫기',
};
