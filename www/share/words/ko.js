// Every word of Share: links, frames, exercises, files, tables, pictures; in Korean.
import { kindName } from './common.js';

export * from './common.js';

export const texts = {
  keepLink: '링크',
  keepLinkHelp: '어디서나 바로 이 실험을 엽니다. 로봇도 진화도 화면도 같습니다.',
  keepLinkHere: '바로 이 실험을 엽니다. 로봇도 진화도 화면도 같습니다.',
  keepLinkOnDisk:
    '이 페이지는 이 컴퓨터의 디스크에 있는 파일입니다. 다른 사람은 자기 파일의 주소 뒤에 #부터 붙여서 엽니다.',
  keepCopy: '링크 복사',
  keepParkHelp:
    '누구나 이어서 해 볼 수 있도록 지금 슬라이더 값으로 “주차” 화면을 엽니다. 진화가 찾은 것은 담기지 않습니다.',
  keepParkTitle: '여기서 찾은 것',
  keepParkFound:
    '실험실에서 여는 실험으로 공유할 수 있습니다. 링크, 로봇에 쓸 코드, 파일, 표가 거기에 있습니다.',
  keepParkEmpty:
    '슬라이더를 움직이거나 진화에 맡기면, 그 결과를 실험실에서 여는 실험으로 공유할 수 있습니다.',
  keepParkLab: '실험실에서 열기',
  keepFile: '파일',
  keepSave: '실험 저장',
  keepOpen: '실험 열기',
  keepFileHelp: '이 페이지에서 다시 열 수 있는 파일입니다. 페이지 아무 곳에나 끌어다 놓아도 열립니다.',
  keepPictures: '화면에 있는 그림',
  keepPicturesHelp: '지금 보이는 그대로, 이 링크를 담아 저장합니다. SVG는 어떤 크기에서도 선명합니다.',
  keepTables: '표(CSV)',
  keepGenerations: '세대별 기록',
  keepDrive: '주행 기록',
  embedTitle: '삽입',
  embedHelp:
    '지금 보이는 화면을 강의 페이지, 블로그, 슬라이드 같은 다른 페이지에 넣습니다. 조작하기 전까지는 움직이지 않습니다.',
  embedParkHelp:
    '지금 슬라이더 값의 “주차” 화면을 강의 페이지, 블로그, 슬라이드 같은 다른 페이지에 넣습니다. 조작하기 전까지는 움직이지 않습니다.',
  embedText: '붙여 넣을 코드',
  embedCopy: '복사',
  embedDisk: '이 페이지는 디스크에서 열었습니다. 코드를 붙여 넣을 페이지와 같은 폴더에 이 파일을 두십시오.',
  keepExerciseTitle: '과제',
  keepExerciseHelp:
    '이 실험에 과제를 붙여 학생에게 줍니다. 방해가 되거나 답을 미리 알려 주는 조작은 잠그거나 숨길 수 있습니다. 학생들이 낸 것은 여기서 한꺼번에 확인합니다.',
  keepExercise: '과제 만들기',
  keepCollect: '제출물 확인',
  keepCodeTitle: '코드',
  keepCodeHelp:
    '이 주행의 제어기를 Python, C, MATLAB이나 Octave, JavaScript 코드로 로봇이나 시뮬레이터에 가져갑니다.',
  keepCode: '코드 보기',
  makerTitle: '과제 만들기',
  makerHelp:
    '학생이 보게 될 모습이 페이지에 바로 나타납니다. 비밀은 아닙니다. 학생도 전체 페이지를 열 수 있습니다.',
  makerWithin:
    '열려 있는 과제에서 잠그거나 숨긴 것은 여기서도 그대로입니다. 바꾸려면 먼저 전체 페이지를 여십시오.',
  makerTask: '과제 내용',
  makerLink: '과제 링크',
  makerCopyLink: '링크 복사',
  makerFrame: '다른 페이지에 넣을 프레임',
  makerCopyFrame: '프레임 복사',
  makerPage: '페이지',
  makerPreview: '학생이 보게 될 모습',
  makerAim: '해결 기준',
  makerValue: '기준값',
  makerDrives: '주행 횟수 제한(비우면 없음)',
  makerPoints: '두 값에서의 점수, 그 사이는 직선으로(비우면 없음)',
  makerPointsAt: '점을 줄 값',
  makerVary: '학번에 따라 학생마다 다르게',
  makerUneven:
    '그러면 도달할 수 있는 J가 학생마다 다릅니다. 모두가 도달할 수 있는 J로 하거나 주차를 기준으로 하십시오.',
  makerSeeds:
    '주행은 한 번의 진화에서만 셉니다. 시드나 설정을 잠그지 않으면 학생이 여러 번 진화시켜 가장 좋은 것을 낼 수 있습니다.',
  makerWrong: '위의 칸을 바로잡으면 복사하거나 저장할 수 있습니다.',
  makerTurned: '더 좋은 결과의 점수가 더 낮습니다. 의도한 것이 아니면 두 값을 서로 바꾸십시오.',
  makerPaperInLesson: '수업에는 논문의 이득이 나오므로 함께 숨깁니다.',
  makerPark:
    '“주차” 화면에서 해 본 것은 제출할 수 없습니다. 실험실에도 같은 출발점 32개와 슬라이더, 진화가 있습니다.',
  makerToLab: '실험실에서 이어서 만들기',
  makerOnDisk:
    '이 페이지는 이 컴퓨터의 디스크에 있는 파일입니다. 학생에게도 이 파일이 있어야 하며, 파일 주소 뒤에 링크의 #부터 붙여서 엽니다. 또는 패키지를 나누어 주십시오.',
  scormButton: 'Moodle용 패키지(SCORM 1.2)',
  scormTitle: '과제: 로봇의 이득 찾기',
  scormFile: '파일 하나로 된 이 페이지',
  makerClose: '과제 만들기 닫기',
};

/** @param {string} hash @param {number} generations */
export const fingerprint = (hash, generations) =>
  `${generations === 0 ? '0세대' : `0~${generations}세대`}의 지문: ${hash}. 이 링크를 어디에서 열어도 같습니다.`;

export const copied = '링크를 복사했습니다.';
export const notCopied =
  '이 브라우저는 페이지의 복사를 허용하지 않습니다. 링크를 선택해 두었으니 키보드로 복사하십시오.';

/** The exercise as a package for a learning platform. */
export const scorm = {
  /** What the package says by itself; … is what the platform says. */
  sentences: {
    refused: '학습 플랫폼이 저장하지 못했습니다(…). ‘제출하기’를 누르고 제출물을 복사하여 직접 제출하십시오.',
    tooLong: '제출물이 이 플랫폼에는 너무 깁니다. ‘제출하기’를 누르고 제출물을 복사하여 직접 제출하십시오.',
    noRoom:
      '이 플랫폼에는 지금 하는 작업을 저장할 자리가 없습니다. 나가기 전에 제출하지 않으면 다시 들어왔을 때 남아 있지 않습니다.',
    changed:
      '작업한 뒤에 과제가 바뀌어 처음부터 다시 시작합니다. 플랫폼이 이미 받은 결과는 다시 제출할 때까지 남습니다.',
    kept: '학습 플랫폼이 이 결과를 받았습니다. 다시 제출하면 새 결과로 바뀝니다.',
    nobody:
      '응답하는 학습 플랫폼이 없어 아무것도 저장되지 않습니다. ‘제출하기’를 누르고 제출물을 복사하십시오.',
  },
  writing: '패키지를 만드는 중…',
  /** @param {number} bytes */
  written: (bytes) =>
    `패키지를 저장했습니다(${(bytes / 1e6).toFixed(1)} MB). SCORM 패키지로 올리십시오. Moodle에서는 “활동 추가”\u2060에서 “SCORM 패키지”\u2060를 고르십시오.`,
  /** @param {number} characters */
  long: (characters) =>
    `과제 링크가 깁니다(${characters}자). 학생이 제출한 뒤에 하는 작업은 플랫폼에 저장할 자리가 없을 수 있습니다. 과제 내용이나 고정한 주행을 줄이면 짧아집니다.`,
  /** @param {string} file */
  choose: (file) =>
    `여기서는 페이지가 자신의 파일을 읽지 못합니다. 파일 하나로 된 페이지 ${file}을 고르십시오.`,
  /** @param {string} reason */
  failed: (reason) => `패키지를 만들지 못했습니다: ${reason}`,
};

export const foreignFile = '이 페이지가 저장한 실험이 아닙니다.';
export const handInFile =
  '제출물입니다. “제출물 확인”\u2060에서 읽거나, 그 안의 링크를 주소 표시줄에 붙여 넣으십시오.';

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

/** @param {string} said @param {string} found */
export const otherGains = (said, found) =>
  `파일에 적힌 주행의 이득은 ${said}, 실제 이득은 ${found}입니다. 파일이 바뀌었습니다.`;

/** @param {string} said @param {number} found */
export const otherCost = (said, found) =>
  `파일에 적힌 주행의 J는 ${said}, 실제 J는 ${found}입니다. 파일이 바뀌었습니다.`;

/** @param {string} field */
export const changedFile = (field) => `${field} 항목이 실험과 다릅니다. 파일이 바뀌었습니다.`;

export const cutFile = '파일이 손상되었습니다. 끝부분이 없습니다.';

export const largeFile = '실험 파일이라고 하기에는 너무 큽니다.';

export const reading = '파일을 읽고 그 실험을 다시 계산하는 중입니다. 이 창을 닫으면 그만둡니다.';

/** @param {string} name @param {string} reason */
export const notOpened = (name, reason) => `“${name}” 파일을 열지 못했습니다: ${reason}`;

/** @param {string} name @param {number} generations @param {boolean} hasDrive */
export const opened = (name, generations, hasDrive) =>
  `“${name}” 파일을 열었습니다. ${generations}세대까지의 진화${hasDrive ? '와 주행이' : '가'} 모두 저장한 것과 같습니다.`;

/** What of the lab is on screen, by its data-picture; parts name their own. @type {Readonly<Record<string, string>>} */
export const pictures = {
  plane: '평면',
  fitness: '적합도 곡선',
  sigmas: '평균 변이 폭 σ',
  step: '이 단계의 그림',
};

/** @param {string} picture @param {string} kind */
export const savePicture = (picture, kind) => `${picture}: ${kindName(kind)} 형식으로 저장`;

/** Why. */
export const unreadable = '이 브라우저는 페이지가 그린 그림을 읽지 못하게 합니다. SVG로는 저장할 수 있습니다';
/** @param {string} picture @param {string} reason */
export const pictureNotSaved = (picture, reason) => `“${picture}” 그림을 저장하지 못했습니다: ${reason}.`;

export const sizeLegend = '프레임 크기';

export const textCopied = '코드를 복사했습니다.';

export const textNotCopied =
  '이 브라우저는 페이지의 복사를 허용하지 않습니다. 코드를 선택해 두었으니 키보드로 복사하십시오.';

/** What a screen reader says of the frame. @param {string} part */
export const frameTitle = (part) => `진화로 찾는 로봇 제어기: ${part}`;

/** @type {import('../../kit/segmented.js').Choices<import('../../words/common/kinds.js').Way>} */
export const ways = {
  free: '사용',
  locked: '잠금',
  hidden: '숨김',
};

/** @param {readonly string[]} names @param {string} group */
export const easyText = (names, group) =>
  `누르기만 해도 해결됩니다: ${names.join(', ')}. 더 어려운 값을 정하거나 “${group}” 항목을 잠그거나 숨기십시오.`;

/** @param {readonly string[]} groups */
export const uncountedText = (groups) =>
  `다음에서 한 주행은 세지 않습니다: ${groups.join(', ')}. 횟수 제한을 지키게 하려면 잠그거나 숨기십시오.`;

/** @param {number} drives */
export const manyText = (drives) =>
  `주어진 것만으로 이미 ${drives}회 주행했습니다. 횟수를 늘리거나, 0세대에서 “직접 조정”으로 내십시오.`;

/** @param {number} count @param {number} most */
export const countText = (count, most) => `최대 ${most}자 중 ${count}자`;

/** @typedef {typeof import('../../run/aim.js').most} Most */

/** @param {Exclude<import('../exercise/asked.js').Fields['kind'], 'none'>} kind @param {Most} most */
export const wrongValue = (kind, most) =>
  ({
    cost: `J의 기준값은 0보다 크고 ${most.cost} 이하인 수여야 합니다. 예: 8.1`,
    parks: `출발점 수는 28/32처럼 적되 앞의 수가 뒤의 수 이하이고 뒤의 수가 ${most.starts} 이하여야 합니다.`,
    unseen: '비율은 0보다 크고 1 이하여야 합니다. 예: 0.9 또는 90%',
  })[kind];

/** @param {Most} most */
export const wrongDrives = (most) => `주행 횟수는 1부터 ${most.drives}까지의 정수이거나 비어 있어야 합니다.`;

/** Where they are not all there. */
export const lacksPoints = '점수는 네 칸을 모두 채워야 합니다. 또는 네 칸을 모두 비우십시오.';

/** @param {number} i @param {Most} most */
export const wrongPoints = (i, most) => `${pointsLabel(i)}는 0부터 ${most.points}까지의 수여야 합니다.`;

/** @param {number} i @param {import('../../run/aim.js').Wanted} wanted @param {Most} most */
export const wrongAt = (i, wanted, most) =>
  `${pointsAtLabel(i)}은 ${
    wanted.kind === 'cost'
      ? `0부터 ${most.cost}까지의 J여야 합니다.`
      : wanted.kind === 'parks'
        ? `출발점 수로, 0부터 ${wanted.of}까지여야 합니다.`
        : '0부터 1까지의 비율이어야 합니다. 예: 0.3 또는 30%'
  }`;

export const sameAt = '둘째 값은 첫째 값과 달라야 합니다.';

/** @type {Readonly<Record<'none' | 'cost' | 'parks' | 'unseen', string>>} */
export const aims = {
  none: '기준 없음',
  cost: 'J가 다음보다 낮을 때',
  parks: '주차한 출발점/전체',
  unseen: '처음 보는 출발점의 비율',
};

/** @type {Readonly<Record<'goal' | 'starts' | 'seed', string>>} */
export const varied = { goal: '목표(25 cm 이내)', starts: '출발(25 cm, 15° 이내)', seed: '진화의 시드' };

/** @param {number} i */
export const pointsLabel = (i) => `${i === 0 ? '첫째' : '둘째'} 값의 점수`;

/** @param {number} i */
export const pointsAtLabel = (i) => `${i === 0 ? '첫째' : '둘째'} 값`;
