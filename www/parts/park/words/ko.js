// Every word of Park in Korean.
/** @import { Bred } from '../state.js' */
/** @import { Model } from '../sight.js' */
import { fixed, grouped } from '../../../words/ko/numbers.js';

export const title = '모두 주차시키기';
export const pictureName = '주차장과 로봇';

/** @param {number} count */
export const invitation = (count) =>
  `로봇 ${count}대, 주차할 곳 하나. 모든 로봇은 같은 수 세 개를 따릅니다. 로봇을 모두 주차시키는 세 수를 찾아보십시오.`;

/** @param {Model} model @param {Bred} found */
export function ending({ best, count, most }, { gains, parked, generation }) {
  const mine = best?.parked ?? 0;
  if (parked <= mine)
    return `진화는 로봇 ${count}대 가운데 ${parked}대에서 멈추었고, 직접 찾은 세 수로는 ${mine}대였습니다. 운이 작용하니 다른 시드로 다시 해 보십시오.`;
  const beyond = gains[1] / most;
  const where =
    beyond > 1.5
      ? ` ky 슬라이더는 ${most}에서 끝나지만, 슬라이더가 없는 진화는 ${fixed(gains[1], 0)}까지 갔습니다.`
      : '';
  return parked === count
    ? `${generation}세대 만에 출발점 ${count}곳 모두에서 주차하는 로봇이 나왔습니다. 방법을 알려 준 사람은 없습니다. 진화는 로봇마다 수 하나를 받고, 잘 주행한 로봇을 남겼을 뿐입니다.${where}`
    : `${generation}세대 뒤에 진화는 로봇 ${count}대 가운데 ${parked}대를 주차시킵니다.${where}`;
}

/** @param {number} count */
export const ofParked = (count) => `/ ${count}대 주차`;
/** @param {number} parked @param {number} count */
export const share = (parked, count) => `${count}대 중 ${parked}대`;
export const yours = '직접 고른 세 수로';
/** Before anybody has moved one. */
export const given = '아래의 세 수로';
/** @param {number} generation @param {number} population */
export const swarm = (generation, population) =>
  generation === 0 ? `무작위 로봇 ${population}대 중 최우수` : `${generation}세대의 최우수 로봇`;

export const sliders = '세 수';
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

/** @param {Bred} newest */
export const climb = ({ generation, parked, drives }) =>
  `${generation}세대: ${parked}대 주차 · 지금까지 ${grouped(drives)}번 주행`;

export const parkedColumn = '주차';
export const bestByHand = '직접';
export const evolved = '진화';
export const how = '어떻게 찾았을까요?';
export const openLab = '이 진화를 실험실에서 열기';

/** @param {number} parked @param {number} count */
export const picture = (parked, count) => `로봇 ${count}대 가운데 ${parked}대가 주차했습니다.`;

/** What red means. @param {{ position: number, heading: number }} tolerance */
export const missed = ({ position, heading }) =>
  `빨간 로봇은 주차하지 못했습니다. ${fixed(100 * position, 0)} cm 또는 ${fixed((180 / Math.PI) * heading, 1)}° 넘게 벗어나 있습니다.`;
