// Every word of the Lyapunov function beside the robot, in Korean.
/** @import { Summary } from '../summary.js' */
import { amount, errorNames, gainNames, termsOf } from './common.js';
import { fixed, threeDigits } from '../../../../words/ko/numbers.js';

export * from './common.js';

export const texts = {
  stabilityPicture: '시간에 따른 V와 V̇',
  stabilityTable: '표',
  stabilityLog: '로그',
};

export const terms = termsOf({ rate: ['실제 V̇'], promised: ['이론 V̇ ='] });

/** @param {boolean} limited */
export const limitedText = (limited) => (limited ? '예' : '');

/** @param {string} name @param {number} step */
export const tableCaption = (name, step) =>
  `${name}: ${threeDigits(step)}초마다 한 줄, 그리고 마지막. 이론 V̇는 세 항의 합이고, 실제 V̇는 제한과 외란을 거친 값입니다.`;

export const tableColumns = [
  't s',
  'xₑ m',
  'yₑ m',
  'θₑ °',
  'V',
  'xₑ의 항',
  'yₑ의 항',
  'θₑ의 항',
  '이론 V̇',
  '실제 V̇',
  '제한됨',
];

/** What the picture shows, in whole sentences. @param {Summary} summary */
export const noteText = (summary) =>
  summary.seconds === 0
    ? '로봇이 출발한 곳에서 이미 도착했으므로 주행하지 않습니다.'
    : [valueText, raisedText, limitsText, samplingText, lawText]
        .map((text) => text(summary))
        .filter(Boolean)
        .join(' ');

/** @param {Summary} summary */
function valueText({ from, to, rising, seconds }) {
  if (from === 0 && to === 0) return 'V는 0입니다. 로봇이 처음부터 목표에 있습니다.';
  const [first, last] = [from, to].map(amount);
  const ends = `${first} → ${last}`;
  if (rising > 0)
    return `V는 ${fixed(seconds, 2)}초 중 ${fixed(rising, 2)}초 동안 커집니다(굵은 선, 아래에 표시). 처음 → 마지막: ${ends}.`;
  if (first === last) return `V는 한 번도 커지지 않고 ${first}에 머뭅니다.`;
  return to < 0.01 * from ? `V는 끝까지 줄어듭니다(${ends}).` : `V는 한 번도 커지지 않습니다(${ends}).`;
}

/** @param {Summary} summary */
function raisedText({ raised, negative, referenceSpeed }) {
  if (raised.length === 0) return '';
  const guilty = raised.filter((part) => negative.includes(part));
  const why =
    guilty.length > 0
      ? `${guilty.map((part) => gainNames[part]).join(', ')}의 값이 음수여서 `
      : referenceSpeed < 0
        ? '기준 자세가 뒤로 달려서 '
        : '';
  return `${why}${raised.map((part) => errorNames[part]).join(', ')}의 항이 0보다 크므로, 법칙 자체가 V를 키웁니다.`;
}

/** @param {Summary} summary */
function limitsText({ limited, disturbed, isPromised, isLaw }) {
  const pushed = disturbed ? `외란${limited === 0 ? '이' : '도'} 실제 V̇를 이론 V̇에서 벗어나게 합니다.` : '';
  if (limited === 0)
    return disturbed || !isPromised
      ? pushed
      : isLaw
        ? '명령이 제한에 걸리지 않으므로 실제 V̇는 이론 V̇와 같습니다.'
        : '명령이 제한에 걸리지는 않지만, 0으로 나누게 되는 곳에서는 법칙 대신 정해 둔 값을 씁니다. 그곳에서는 실제 V̇가 이론 V̇와 다릅니다.';
  return `위쪽 막대 아래: ${fixed(limited, 2)}초 동안 명령이 제한에 걸려 실제 V̇가 이론 V̇와 다릅니다. ${pushed}`.trim();
}

/** @param {Summary} summary */
const samplingText = ({ causes, sampleTime }) =>
  causes.includes('sampling')
    ? `한 명령을 ${threeDigits(sampleTime)}초 동안 유지하므로, V̇가 샘플마다 0보다 작아도 샘플 사이에서는 V가 커질 수 있습니다.`
    : '';

/** @param {Summary} summary */
function lawText({ law, isPromised, referenceSpeed }) {
  if (law !== 'kanayama') return '';
  if (!isPromised)
    return 'Kanayama의 규칙은 ky > 0이 아니면 아무것도 보장하지 않습니다. 여기의 V는 법칙 (5)의 것입니다.';
  return referenceSpeed === 0
    ? 'Kanayama의 규칙에서 목표가 멈춰 있으면 V̇에는 앞쪽으로 잰 목표까지의 거리 x만 남습니다. 목표 옆에 이르면 로봇은 그 자리에 머뭅니다.'
    : 'Kanayama의 규칙에는 고유한 V가 있습니다. x는 로봇의 앞쪽으로 잰 기준 자세까지의 거리입니다.';
}

/** @param {string} name @param {Summary} summary */
export const pictureLabel = (name, summary) =>
  `시간에 따른 V와 V̇: ${name}. ${noteText(summary)} “표”\u2060에서 수치를 볼 수 있습니다.`;
