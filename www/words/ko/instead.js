// Every word of what stands in the place of the robots where they cannot drive, in Korean.

export const waits =
  '아직 로봇이 보이지 않습니까? 네트워크가 느리거나, 이 브라우저가 페이지를 실행할 수 없거나, 파일이 빠진 것입니다. 스크립트와 WebAssembly를 허용한 Chrome·Edge 109, Firefox 115, Safari 16.4 이상에서 실행됩니다. 디스크에서는 모두 들어 있는 ep-locomotion.html을 여십시오.';

/** @param {string} reason */
export const cannot = (reason) =>
  `이곳에서는 로봇이 주행할 수 없습니다. ${reason} 이 페이지는 WebAssembly를 허용한 Chrome·Edge 109, Firefox 115, Safari 16.4 이상에서 실행됩니다. 수업 내용은 여기에서도 읽을 수 있습니다.`;

export const reasons = {
  absent: '이 브라우저에는 WebAssembly가 없거나 꺼져 있습니다.',
  old: '이 브라우저의 WebAssembly는 오래되어 SIMD를 지원하지 않습니다.',
  forbidden:
    '이 페이지를 보내는 서버가 WebAssembly를 금지하고 있습니다(콘텐츠 보안 정책에 wasm-unsafe-eval이 없습니다).',
  full: '이 브라우저에 남은 메모리가 없습니다. 다른 탭을 닫고 페이지를 새로 고치십시오.',
};
/** @param {string} message */
export const notLoaded = (message) =>
  `페이지의 일부를 불러오지 못했습니다(${message}). 네트워크와 로그인을 확인하고 페이지를 새로 고치십시오.`;

/** Before a link to the page. */
export const copy =
  '브라우저가 저장한 사본이라 작동하지 않습니다. ep-locomotion.html을 내려받거나 페이지를 여십시오:';

export const stopped =
  '프로그램 내부 오류로 실행이 멈추었습니다. 페이지를 새로 고치십시오. 주소에 화면의 내용이 담겨 있어 그대로 돌아옵니다.';

/** @param {number} robots @param {number} generation @param {string} first @param {string} best */
export const caption = (robots, generation, first, best) =>
  `이득이 무작위인 로봇 ${robots}대가 목표로 주행합니다. 그중 가장 좋은 로봇의 J는 ${first}입니다. 굵은 선은 ${generation}세대의 진화를 거친 최우수 로봇이며 J는 ${best}입니다.`;

export const article = '글로 읽는 수업';
export const articleNote =
  '슬라이더와 질문, 해 볼 것을 뺀 수업의 글이어서, 여기 없는 것을 가리킬 때가 있습니다. 글 속의 수는 이 페이지를 만들 때 같은 프로그램이 계산한 값입니다.';
