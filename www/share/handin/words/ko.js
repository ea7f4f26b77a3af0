// Every word of handing in, in Korean.
/** @import { Wanted } from '../../../run/aim.js' */
/** @import { Thing } from '../own.js' */
import { costBeside, costLine, gainsLine, head } from './common.js';

export * from './common.js';

export const texts = {
  handIn: '제출하기',
  title: '제출하기',
  close: '닫기',
  whoLabel: '이름 또는 학번',
  whoHelp: '한 번만 묻습니다. 그다음부터 주소와 여기서 복사하거나 저장하는 것에 들어갑니다.',
  whoDrawn: '이 이름으로 정해진 과제입니다. 다른 이름으로 하려면 교수님이 주신 과제 링크를 여십시오.',
  begin: '시작',
  whoFirst:
    '이 과제는 학생마다 조금씩 다릅니다. 이름이나 학번을 적으면 자신의 과제가 정해집니다. 그 전에 한 것은 남지 않습니다.',
  make: '제출물 만들기',
  help: '안내받은 방법대로 교수님께 내십시오. 텍스트를 붙여 넣거나 링크 또는 파일을 보내면 됩니다. 이 페이지는 아무것도 보내지 않습니다.',
  helpWithin:
    '이 페이지를 둘러싼 학습 플랫폼에 결과를 받았다는 안내가 없으면, 이것을 교수님께 내십시오. 텍스트를 붙여 넣거나 링크 또는 파일을 보내면 됩니다.',
  proves:
    '여는 사람은 로봇의 주행을 보게 되며, J는 그때 마지막 자리까지 다시 계산됩니다. 제출물은 결과를 증명할 뿐, 누구의 것인지는 증명하지 않습니다.',
  text: '제출물',
  link: '제출물의 링크',
  copyText: '텍스트 복사',
  copyLink: '링크 복사',
  save: '파일로 저장',
  computing: '계산하는 중…',
  made: '제출물을 만들었습니다.',
  counts: '판정은 주어진 과제로 합니다.',
  away: '“주차” 화면에서 해 본 것은 제출되지 않습니다.',
  toLab: '실험실로',
  backToExercise: '주어진 대로 되돌리기',
};

export const copied = '복사했습니다.';
export const notCopied =
  '이 브라우저는 페이지의 복사를 허용하지 않습니다. 선택해 두었으니 키보드로 복사하십시오.';

/** @param {string} reason */
export const failed = (reason) => `제출물을 만들지 못했습니다: ${reason}`;

/** @param {Wanted} wanted */
export const wantedText = (wanted) =>
  wanted.kind === 'cost'
    ? `J ${wanted.below} 미만`
    : wanted.kind === 'parks'
      ? `출발점 ${wanted.of}개 가운데 ${wanted.least}개 이상에서 주차`
      : `진화에 쓰지 않은 출발점 1,000개의 ${Math.round(1000 * wanted.share) / 10}% 이상에서 주차`;

/** @param {number | null} drives */
export const budgetText = (drives) => (drives === null ? '' : `, 주행 ${drives}회 이내`);

/** @param {Wanted} wanted @param {number} value */
export const valueText = (wanted, value) =>
  wanted.kind === 'cost'
    ? `J ${costBeside(value, wanted.below)}`
    : wanted.kind === 'parks'
      ? `${wanted.of}개 중 ${value}개`
      : `${Math.round(1000 * value) / 10}%`;

/** @type {Readonly<Record<Thing, string>>} */
const things = {
  starts: '출발',
  goal: '목표',
  referenceVelocity: '기준 속도',
  limits: '제한',
  tolerance: '허용 오차',
  weights: 'J의 가중치',
  law: '제어 법칙',
  sampleTime: '샘플링 주기',
  horizon: '제한 시간',
  disturbance: '외란',
  seed: '시드',
  evolution: '진화',
  drives: '주행에 쓰는 이득',
  gains: '이득',
  generation: '세대',
};

/** @param {readonly Thing[]} apart */
const listed = (apart) => apart.map((thing) => things[thing]).join(', ');

/** @param {readonly Thing[]} apart */
export const apartText = (apart) => `여기서 바꾼 것: ${listed(apart)}.`;

/** @param {boolean} isMet @param {boolean} isWithin Whether there are no more drives than the aim allows. */
export const metText = (isMet, isWithin) =>
  isMet ? '달성' : isWithin ? '아직 미달' : '미달, 주행 횟수 초과';

/** @param {boolean} isMet */
export const metWord = (isMet) => (isMet ? '달성' : '미달');

/** @param {number} drives @param {number} most */
export const drivesText = (drives, most) => `주행 ${most}회 중 ${drives}회`;

/** @param {number} points @param {number} most */
export const pointsText = (points, most) => `${most}점 만점에 ${points}점`;

/** The text of a receipt. @param {import('../receipt.js').Receipt} receipt */
export function receiptText(receipt, address = receipt.link) {
  const { who, program, exercise, cost, parked, starts, drives, minutes, answers } = receipt;
  const { apart, there, wanted, judged, gains, how } = receipt;
  const found =
    how.driver === 'evolved'
      ? `, ${how.method === 'ep' ? 'EP' : how.method}, 시드 ${how.seed}, ${how.generation}세대`
      : how.driver === 'hand'
        ? ', 직접 찾음'
        : ', 논문의 이득';
  const reached = wanted && wanted.kind !== 'cost' ? `: ${valueText(wanted, there.value)}` : '';
  return [
    head(program, exercise),
    `이름: ${who}`,
    `${costLine(cost)}, 출발점 ${starts}개 중 ${parked}개에서 주차`,
    ...(judged
      ? [
          `기준 ${metWord(judged.isMet)}${reached}${judged.points === null ? '' : `, ${judged.most}점 만점에 ${judged.points}점`}`,
        ]
      : []),
    ...(apart.length > 0
      ? [`주어진 과제에서(여기서 바꾼 것: ${listed(apart)}): ${costLine(there.cost)}`]
      : []),
    `${gainsLine(gains)}${found}`,
    `주행 ${drives}회, ${minutes}분`,
    ...(answers ? [`답: ${answers}`] : []),
    address,
  ].join('\n');
}

/** @param {string} who @param {number} cost */
export const held = (who, cost) =>
  `${who || '이름 없는 학생'}의 제출물: J = ${cost}. 여기서 다시 계산한 값과 마지막 자리까지 같습니다.`;

/** @param {number} told @param {number} found */
export const heldNot = (told, found) =>
  `이 제출물은 맞지 않습니다. 적힌 값은 J = ${told}, 실제 주행은 J = ${found}입니다.`;

export const broken = '이 제출물은 도중에 잘렸거나 바뀌었습니다. 다시 받으십시오.';

/** @param {string} program @param {string} own */
export const otherProgram = (program, own) =>
  `이 제출물을 만든 프로그램의 버전은 ${program}, 이 페이지의 버전은 ${own}입니다.`;
