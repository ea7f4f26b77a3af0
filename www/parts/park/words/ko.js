// Every word of Park in Korean.
import { fixed } from '../../../words/ko/numbers.js';

export const title = '모두 주차시키기';
export const pictureName = '주차 자리';

/** @param {number} count */
export const invitation = (count) =>
  `로봇 ${count}대, 주차 자리 하나. 모든 로봇은 같은 숫자 세 개를 따릅니다. 몇\u00a0대나 주차시킬 수 있습니까?`;

/** @param {number} count */
export const ofParked = (count) => `/ ${count}대 주차`;
export const yours = '직접 고른 세 숫자로';
/** Before anybody has moved one. */
export const given = '아래의 세 숫자로';
/** @param {number} generation @param {number} population */
export const swarm = (generation, population) =>
  generation === 0 ? `무작위 로봇 ${population}대 중 최우수` : `${generation}세대의 최우수 로봇`;

export const sliders = '세 숫자';
/** What each of them is for. */
export const whatFor = ['앞으로', '옆으로', '회전'];
export const evolve = '진화에 맡기기';
export const stop = '멈추기';
export const otherSeed = '다른 시드로 다시 진화';
export const again = '다시 주행';
export const first =
  '먼저 슬라이더를 움직이십시오. 모든 로봇이 곧바로 다시 주행합니다. 그다음 진화에 맡길 수 있습니다.';
/** @param {number} population */
export const ready = (population) =>
  `막혔습니까? 진화는 무작위 로봇 ${population}대로 시작하고, 그 밖에는 아무것도 모릅니다.`;

/** @param {number} value */
export const gain = (value) => fixed(value, 1);

export const how = '어떻게 찾았을까요?';
export const openLab = '이 진화를 실험실에서 열기';

/** @param {number} parked @param {number} count */
export const picture = (parked, count) => `로봇 ${count}대 가운데 ${parked}대가 주차했습니다.`;

/** @param {number} parked @param {number} count */
export const planeLabel = (parked, count) => `${picture(parked, count)} 화살표 키로 로봇을 하나씩 봅니다.`;

/** What red means. @param {{ position: number, heading: number }} tolerance */
export const missed = ({ position, heading }) =>
  `속이 빈 빨간 로봇은 주차하지 못했습니다. ${fixed(100 * position, 0)} cm 또는 ${fixed((180 / Math.PI) * heading, 1)}° 넘게 벗어나 있습니다.`;
export const pressOne = '누르면 이유가 보입니다.';
