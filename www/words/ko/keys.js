// Every word about the keyboard, in Korean.

export const texts = {
  keysButton: '단축키',
  keysTitle: '키보드',
  keysSingle: '한 글자 단축키 사용(입력 중에는 작동하지 않음)',
  keysEverywhere: '모든 버튼과 슬라이더, 그림에는 Tab 키로도 갈 수 있습니다.',
};

/** Single keys: what they press. Those of a presenter’s clicker do where nothing has the focus. @type {readonly (readonly [key: string, meaning: string, id: string])[]} */
export const single = [
  ['r', '진화 시작 또는 멈춤', 'run'],
  ['n', '한 세대 진행', 'one-generation'],
  ['b', '한 세대 뒤로. 일부 발표용 리모컨에서는 화면을 끄는 버튼', 'one-back'],
  ['p', '로봇 주행 또는 멈춤', 'play'],
  ['PageDown', '세대의 다음 단계(페이지가 더 내려가지 않을 때)', 'generation-next'],
  ['PageUp', '이전 단계', 'generation-back'],
  ['s', '설정', 'settings-button'],
];

/** Keys of what has the focus. @type {readonly (readonly [keys: string, meaning: string])[]} */
export const focused = [
  ['← → ↑ ↓', '선택한 것을 움직임: 슬라이더, 출발, 목표, 지도의 커서. 식에서는 항에서 항으로'],
  ['Shift + 화살표', '출발이나 목표를 5°씩 돌리거나, 지도의 커서를 크게 옮김'],
  ['Alt + 화살표', '출발이나 목표를 조금씩 옮기거나 돌림'],
  ['Enter', '버튼 누르기. 지도에서는 커서가 가리키는 값으로 주행'],
  ['Esc', '열린 창 닫기, 끌던 출발이나 목표를 제자리로'],
  ['Ctrl + Z, Ctrl + Shift + Z', '실험의 변경을 되돌리거나 다시 적용. 다른 이득으로 바뀐 내 이득도 되찾음'],
  ['?', '이 안내'],
];
