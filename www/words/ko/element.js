// What the element <ep-locomotion> says to the author of a page that has it wrong; in Korean.

export const label = '진화로 찾는 로봇 제어기';

/** @param {string} src */
export const noAddress = (src) => `src는 페이지의 주소여야 하며, 받은 값은 “${src}”입니다`;

/** @param {string} address */
export const silent = (address) =>
  `${address}에서 그림이 응답하지 않습니다. dist/의 파일이 그곳에 있어야 하고, 이 페이지의 정책(frame-src, Cross-Origin-Embedder-Policy)이 프레임을 허용해야 합니다`;

/** @param {number} found @param {number} own */
export const otherVersion = (found, own) =>
  `그림의 메시지 형식은 버전 ${found}이고 이 요소는 버전 ${own}입니다. embed.js와 페이지를 같은 dist/에서 가져오십시오`;

/** @param {number} least @param {number} most @param {string} found */
export const noHeight = (least, most, found) =>
  `height는 ${least} 이상 ${most} 이하의 정수(픽셀)여야 하며, 받은 값은 “${found}”입니다`;

export const gone = '그림이 페이지에서 제거되었습니다';
export const replaced = 'src가 설정되어, 요청을 받은 그림이 새 그림으로 바뀌었습니다';
