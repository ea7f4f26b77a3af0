// Every word of the robustness part, in Korean.
/** @import { Quantity } from '../request.js' */
/** @import { Drive, Place } from './common.js' */
import { placeText, shareText } from './common.js';
import { costText, degrees, fixed, grouped, tookText } from '../../../words/ko/numbers.js';

export * from './common.js';

export const texts = {
  robustnessPicture: '출발점 지도',
  robustnessTitle: '강인성',
  robustnessExtent: '목표에서 지도 가장자리까지의 거리(m)',
  robustnessAround: '목표 주변',
};

export const quantityLegend = '색의 의미';
/** @type {import('../../../kit/segmented.js').Choices<Quantity>} */
export const quantities = {
  share: { text: '도착', hint: '도착하는 방향각의 비율' },
  time: { text: '시간', hint: '도착한 주행의 시간' },
  cost: { text: 'J', hint: '도착한 주행의 비용' },
};

export const headingLegend = '출발 방향각';
/** @type {import('../../../kit/segmented.js').Choices<'all' | 'one'>} */
export const headingChoices = {
  all: { text: '전체', hint: '모든 방향각을 함께' },
  one: { text: '방향각 하나', hint: '다이얼에서 고른 방향각 하나' },
};

/** @param {number} share */
export const percent = (share) => `${shareText(share)}%`;

/** @param {number} starts @param {number} milliseconds */
export const startsText = (starts, milliseconds) => `출발점 ${grouped(starts)}개, ${tookText(milliseconds)}`;

export const tracking = '기준 자세가 움직이므로 도착으로 끝나는 주행이 없습니다.';
export const computing = '로봇이 주행하고 있습니다…';

/** @param {string} message @param {boolean} kept */
export const failed = (message, kept) =>
  `${kept ? '지도를 새로 계산하지 못했습니다' : '계산하지 못했습니다'}: ${message}`;

/** What follows the share, which is of all headings also where the map shows one. @param {string} name @param {boolean} isOne */
export const summary = (name, isOne) => `${isOne ? '모든 방향각의 ' : ''}도착 비율(${name})`;

/** @param {string} name @param {number | null} share */
export const rivalText = (name, share) => `${name}: ${share === null ? '…' : percent(share)}`;

/** @param {Record<'behind' | 'front' | 'left' | 'right', number>} shares */
export const sides = ({ behind, front, left, right }) =>
  `도착하는 출발점의 비율: 목표 뒤쪽 ${percent(behind)}, 앞쪽 ${percent(front)}, 왼쪽 ${percent(left)}, 오른쪽 ${percent(right)}.`;

export const mapLabel =
  '목표 주변 출발점의 지도. 화살표 키로 커서를 한 칸씩, Shift와 함께 여덟 칸씩 옮깁니다. Enter를 누르면 그곳에서 로봇이 주행합니다.';
/** @param {number} step In degrees. */
export const roseLabel = (step) =>
  `출발 방향각. 왼쪽·오른쪽 화살표로 ${step}°씩 돌립니다. Esc를 누르면 모든 방향각을 함께 봅니다.`;

/** @param {number | null} angle */
export const headingText = (angle) => (angle === null ? '모든 방향각' : degrees(angle));
export const allShort = '전체';
/** What the ring shows, and the lines where one points. @param {number} headings @param {boolean} withLines */
export const ring = (headings, withLines) =>
  withLines
    ? `고리와 선: 한 곳의 방향각 ${headings}개. 빈칸과 파선은 도착하지 못함.`
    : `고리: 한 곳의 방향각 ${headings}개. 빈칸은 도착하지 못함.`;
/** The same where the disturbance is random: the map drives each start with a draw of its own. @param {number} headings @param {boolean} withLines */
export const ownDraws = (headings, withLines) =>
  `고리: 한 곳의 방향각 ${headings}개. ${withLines ? '선과 지금 보는 주행은' : '지금 보는 주행은'} 외란을 따로 뽑은 것입니다.`;
/** @param {'x' | 'y'} axis */
export const axisName = (axis) => `출발점 ${axis} (m)`;

/** @param {Quantity} quantity @param {boolean} all */
export const legendTitle = (quantity, all) =>
  ({
    share: all ? '도착하는 방향각' : '도착',
    time: all ? '도착한 주행의 평균 시간' : '시간',
    cost: all ? '도착한 주행의 평균 J' : 'J',
  })[quantity];

/** @param {Quantity} quantity @param {string} text @param {boolean} open */
export const lastTick = (quantity, text, open) =>
  `${open ? '≥\u202f' : ''}${text}${{ share: '%', time: '초', cost: '' }[quantity]}`;

/** @param {boolean} all */
export const never = (all) => (all ? '모두 미도착' : '미도착');
export const few = '절반 미만 도착';

export const goal = '목표';
export const ownStart = '원래 출발점';

/** @param {number} arrived @param {number} headings */
const arrivals = (arrived, headings) =>
  arrived === headings
    ? `방향각 ${headings}개 모두 도착`
    : arrived === 0
      ? `방향각 ${headings}개 모두 미도착`
      : `방향각 ${headings}개 중 ${arrived}개 도착`;

/** @param {Place} place @param {{ arrived: number, headings: number, time: number, cost: number }} cell */
export const cellText = (place, { arrived, headings, time, cost }) =>
  `${placeText(place)}: ${arrivals(arrived, headings)}${
    arrived === 0
      ? ''
      : `, ${arrived > 1 ? (arrived < headings ? '도착한 주행의 평균 ' : '평균 ') : ''}${fixed(time, 2)}초, J\u00a0${fixed(cost, 2)}`
  }.`;

/** @param {Place} place @param {Drive} drive */
export const driveText = (place, drive) =>
  `${placeText(place)}, 방향각 ${degrees(drive.heading)}: ${drive.outcome}, J\u00a0${costText(drive.cost)}.`;

/** @param {Drive} drive @param {number} next */
export const watching = (drive, next) =>
  `보고 있는 방향각 ${degrees(drive.heading)}: ${drive.outcome}. 다시 누르면: ${degrees(next)}.`;

/** @param {number} worst @param {boolean} arrives */
export const invitation = (worst, arrives) =>
  arrives
    ? `누르면 J가 가장 높은 ${degrees(worst)} 주행을 봅니다.`
    : `누르면 실패하는 것 중 가장 나쁜 ${degrees(worst)} 주행을 봅니다.`;

/** @param {boolean} watched */
export const clickToWatch = (watched) =>
  watched ? '지금 보고 있는 주행입니다.' : '누르면 이 주행을 봅니다.';

/** Of the run on the plane. @param {Place} place @param {Drive} drive */
export const watched = (place, drive) => `보고 있는 출발점: ${driveText(place, drive)}`;

/** @param {number} arrived @param {number} headings */
export const there = (arrived, headings) => `그 부근의 출발점: ${arrivals(arrived, headings)}.`;
