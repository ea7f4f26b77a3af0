// Every word of the disturbance part, in Korean.
/** @import { Experiment } from '../../../core/engine.js' */
/** @import { PartName, Summary } from '../summary.js' */
import { edgePercent, usualStarts } from '../numbers.js';
import {
  amount,
  crestSeconds,
  edgeMark,
  equations,
  farthestOf,
  formulaText,
  hasEdge,
  isPromised,
  parts,
  unitOf,
} from './common.js';
import { grouped, sixDigits, threeDigits } from '../../../words/ko/numbers.js';

export * from './common.js';

export const texts = {
  disturbancePicture: '남은 오차',
  disturbanceTitle: '외란',
  disturbanceControls: '외란',
  disturbanceSizes: '외란의 크기',
  disturbanceDraw: '새로 뽑기',
  remainsPart: '오차',
  remainsDrive: '이 주행',
  remainsSet: '집합',
  remainsInside: '안에\u00a0남은 출발점',
  remainsInsideHint: `이 시간 동안 오차가 자기 집합의 최대 범위 안에 머문 다른 출발점의 수. ${edgeMark}: 경계에 이른 출발점의 수`,
  remainsEdge: '경계에 이른 출발점',
};

export const kindLegend = '외란의 종류';
/** @type {import('../../../kit/segmented.js').Choices<Experiment['disturbance']['kind']>} */
export const kinds = {
  none: '없음',
  random: { text: '무작위', hint: '샘플마다 −ε과 ε 사이에서 균등하게 새로 뽑습니다' },
  slip: { text: '미끄러짐', hint: '모든 샘플에서 같습니다' },
};

/** @param {Experiment['disturbance']} disturbance */
export const kindText = ({ kind, seed }) =>
  ({
    none: '로봇이 내는 속도에 아무것도 더하지 않습니다',
    random: `|δ1| ≤ ε1, |δ2| ≤ ε2, 샘플마다 새로 뽑음, ${seed}번째 뽑기`,
    slip: 'v와 ω에 모든 샘플에서 똑같이 δ1과 δ2를 각각 더합니다',
  })[kind];

/** Where the experiment has another. @param {Experiment['disturbance']} own */
export const ownText = ({ kind, linear, angular }) =>
  `이 외란은 여기서만 시험합니다. 실험의 외란: ${kind === 'random' ? '무작위' : '미끄러짐'}, ${threeDigits(linear)} m/s, ${threeDigits(angular)} rad/s`;

/** @param {string} message @param {boolean} kept */
export const failed = (message, kept) =>
  `${kept ? '마지막으로 계산된 결과입니다' : '계산하지 못했습니다'}: ${message}`;

/** @param {number} starts */
const startsText = (starts) => `다른 출발점 ${starts}개`;
/** Of all that was measured. @param {number} starts */
export const othersColumns = (starts) => [`${startsText(starts)}의 중앙값`, '그중 최댓값'];
/** @param {PartName} part */
export const measureText = (part) => `${formulaText(part)}${axisUnit(part)}`;
/** @param {PartName} part */
export const calmText = (part) => `${measureText(part)}, 외란 없음`;
/** @param {number} seconds */
export const tableCaption = (seconds) => `남은 오차: 마지막 ${sixDigits(seconds)}초의 최댓값`;
/** @param {number} seconds */
export const lastText = (seconds) => `마지막 ${sixDigits(seconds)}초`;
/** @param {Summary} summary */
export const captionText = (summary) =>
  `마지막 ${sixDigits(summary.seconds)}초의 최댓값${summary.disturbed ? '. 작은 글씨: 외란 없음' : ''}${hasEdge(summary) ? `. ${edgeMark}: 경계 ±${edgePercent}%` : ''}`;

export const legend = {
  solid: '이 주행',
  others: `다른 출발점, ${crestSeconds}초마다의 최댓값`,
  set: '정리 2의 집합 (6)~(8): 셋 모두의 밖에서 V̇ < 0',
};
export const equationHints = {
  x: 'ε1 / kx',
  y: '(ε1 |sin θₑ| / ky)의 세제곱근',
  theta: 'ε2 / kθ',
};

/** @param {PartName} part */
export const axisUnit = (part) => (unitOf[part] ? ` (${unitOf[part]})` : '');

/** @param {PartName} part @param {Summary} summary */
export const plotLabel = (part, summary) => {
  const { rows, seconds, horizon } = summary;
  const { drive, set } = rows[part];
  return `${sixDigits(horizon)}초 동안의 ${formulaText(part)}. 마지막 ${sixDigits(seconds)}초의 최댓값: 이 주행 ${amount(part, drive)}${isPromised(summary) ? `, 정리 2의 집합 ${amount(part, set)}` : ''}.`;
};

/** What came out, in whole sentences. @param {Summary} summary */
export function summaryText(summary) {
  return [driveText(summary), othersText(summary), fewText(summary), theoremText(summary)]
    .filter(Boolean)
    .join(' ');
}

/** @param {readonly PartName[]} of */
const setsText = (of) =>
  of.length === 3 ? '세 집합' : `집합 ${of.map((part) => equations[part]).join(', ')}`;

/** @param {Summary} summary */
function driveText(summary) {
  const { rows, pushed, seconds, disturbed } = summary;
  const last = `마지막 ${sixDigits(seconds)}초 동안`;
  if (!disturbed || !isPromised(summary)) {
    const left = parts.map((part) => `${formulaText(part)} ${amount(part, rows[part].drive)}`).join(', ');
    const promise = isPromised(summary) ? '외란이 없으면 정리 2에 따라 오차는 0에 수렴합니다. ' : '';
    return `${promise}${last} 이 주행에 남은 최대 오차: ${left}.`;
  }
  const { outside, edge } = farthestOf(summary);
  if (outside.length === 0)
    return edge.length === 0
      ? `${last} 이 주행은 ${setsText(pushed)}의 최대 범위 안에 머뭅니다.`
      : `${last} 이 주행은 ${setsText(edge)}의 경계(±${edgePercent}%)에 이릅니다.`;
  const excess = outside.map(
    (part) =>
      `${formulaText(part)} 최대 ${amount(part, rows[part].drive)}(집합의 경계 ${amount(part, rows[part].set)})`,
  );
  return `${last} 이 주행은 ${setsText(outside)}의 최대 범위를 벗어납니다: ${excess.join('; ')}.`;
}

/** @param {Summary} summary */
function othersText(summary) {
  const { calm, starts, allInside, allEdge, pushed, worst, disturbed } = summary;
  const most = `남는 최대 오차는 ${formulaText(worst)} ${amount(worst, calm[worst].largest)}입니다.`;
  if (!isPromised(summary)) return `${startsText(starts)}에서 ${disturbed ? '외란이 없어도 ' : ''}${most}`;
  const atEdge = allEdge > 0 ? `, 경계(±${edgePercent}%)에 이르는 것은 ${allEdge}개` : '';
  const others = disturbed
    ? `${startsText(starts)} 중 ${setsText(pushed)}의 최대 범위 안에 머무는 것은 ${allInside}개${atEdge}입니다. 외란이 없어도 ${most}`
    : `${startsText(starts)}에서 ${most}`;
  return `${others} 정리는 얼마나 빨리 줄어드는지 말하지 않으며, 제한과 샘플링은 빠져 있습니다.`;
}

/** Why there are so few others. @param {Summary} summary */
const fewText = ({ starts, horizon, samples }) =>
  starts < usualStarts
    ? `${sixDigits(horizon)}초를 주행하면 샘플이 ${grouped(samples)}개나 되므로, 다른 출발점은 ${usualStarts}개가 아니라 ${starts}개만 계산합니다.`
    : '';

/** Why the theorem is not about this drive, or a set so wide that it says nothing. @param {Summary} summary */
function theoremText({ law, isPositive, rows, ky, disturbed }) {
  if (law !== 'shim-kim') return '정리는 법칙 (5)에 대한 것이며, 지금 쓰는 규칙에는 해당하지 않습니다.';
  if (!isPositive) return '정리는 0보다 큰 이득에 대한 것입니다. 그렇지 않은 이득에는 집합이 없습니다.';
  if (!disturbed || rows.y.set < 1) return '';
  return `ky ${threeDigits(ky)}에서 ${formulaText('y')}의 집합은 ${amount('y', rows.y.set)}까지 이르므로, 보장하는 것이 거의 없습니다.`;
}
