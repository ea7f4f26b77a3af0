// Every word about keeping a run: links, files, tables, pictures; in Korean.

import { kindName } from '../common/keep.js';

export * from '../common/keep.js';

export const texts = {
  keepButton: '공유',
  keepTitle: '이 실험의 공유와 저장',
  keepLink: '링크',
  keepLinkHelp: '어디서나 바로 이 실행을 엽니다. 로봇도 진화도 화면도 같습니다.',
  keepCopy: '링크 복사',
  keepFile: '파일',
  keepSave: '실험 저장',
  keepOpen: '실험 열기',
  keepFileHelp: '이 페이지에서 다시 열 수 있는 파일입니다. 페이지 아무 곳에나 끌어다 놓아도 열립니다.',
  keepPictures: '화면에 있는 그림',
  keepPicturesHelp: '지금 보이는 그대로, 이 링크를 담아 저장합니다. SVG는 어떤 크기에서도 선명합니다.',
  keepTables: '표(CSV)',
  keepGenerations: '세대별 기록',
  keepDrive: '주행 기록',
  keepClose: '닫기',
};

/** @param {string} hash @param {number} generations */
export const fingerprint = (hash, generations) =>
  `0~${generations}세대의 지문: ${hash}. 이 링크를 어디에서 열어도 같습니다.`;

export const copied = '링크를 복사했습니다.';
export const notCopied =
  '이 브라우저는 페이지의 복사를 허용하지 않습니다. 링크를 선택해 두었으니 키보드로 복사하십시오.';

export const foreignFile = '이 페이지가 저장한 실행이 아닙니다.';

/** @param {unknown} found @param {number} own */
export const otherVersion = (found, own) =>
  `파일의 형식 버전은 ${String(found)}, 이 페이지가 읽는 버전은 ${own}입니다.`;

/** @param {string} fields */
export const damagedFile = (fields) => `파일이 손상되어 다음 항목을 읽을 수 없습니다: ${fields}.`;

/** @param {readonly string[]} problems */
export const damagedLink = (problems) => `파일이 손상되었습니다. ${problems.join(' ')}`;

/** @param {string} said @param {string} found */
export const otherHash = (said, found) =>
  `파일에 적힌 진화의 지문은 ${said}, 실제 지문은 ${found}입니다. 파일이 바뀌었습니다.`;

export const largeFile = '실행 파일이라고 하기에는 너무 큽니다.';

/** @param {string} name @param {string} reason */
export const notOpened = (name, reason) => `“${name}” 파일을 열지 못했습니다: ${reason}`;

/** @param {string} name @param {number} generations */
export const opened = (name, generations) =>
  `“${name}” 파일을 열었습니다. ${generations}세대까지 모두 저장한 것과 같습니다.`;

/** What is on screen, by its data-picture. @type {Readonly<Record<string, string>>} */
export const pictures = {
  plane: '평면',
  fitness: '적합도 곡선',
  sigmas: '변이 폭 σ',
  generation: '세대',
  curves: '시간에 따른 주행',
  stability: '시간에 따른 V와 V̇',
  landscape: 'J의 비용 지형',
  robustness: '출발점 지도',
  training: '학습 출발점',
  disturbance: '남은 오차',
  'luck-curve': '모든 시드의 적합도 곡선',
  'luck-gains': '모든 시드의 이득',
};

/** @param {string} picture @param {string} kind */
export const savePicture = (picture, kind) => `${picture}: ${kindName(kind)} 형식으로 저장`;

/** @param {string} picture @param {string} reason */
export const pictureNotSaved = (picture, reason) => `“${picture}” 그림을 저장하지 못했습니다: ${reason}.`;
