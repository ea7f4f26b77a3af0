// What Park says once something has been tried, in Korean.
/** @import { Bred } from '../../state.js' */
/** @import { Model } from '../../sight.js' */
/** @import { Missed } from '../told.js' */
import { fixed, grouped } from '../../../../words/ko/numbers.js';

/** @param {Pick<Model, 'best' | 'count'>} model @param {Pick<Bred, 'parked' | 'generation'>} found @param {boolean} isDone Else somebody has stopped it. @param {boolean} [isFurther] The best by hand was on no slider before. */
export function ending({ best, count }, { parked, generation }, isDone, isFurther = false) {
  if (!isDone)
    return `${generation}세대에서 진화를 멈추었습니다. 로봇 ${count}대 가운데 ${parked}대가 주차합니다.`;
  if (best && parked <= best.parked && isFurther)
    return `진화는 로봇 ${count}대 가운데 ${parked}대를 주차시켰고, 슬라이더가 그만큼 길어진 지금은 직접 ${best.parked}대를 주차시킵니다.`;
  if (best && parked <= best.parked)
    return `진화는 로봇 ${count}대 가운데 ${parked}대를 주차시켰고, 직접 찾은 세 숫자로는 ${best.parked}대였습니다. 운이 작용하니 다른 시드로 다시 해 보십시오.`;
  return parked === count
    ? `${generation}세대 만에 출발점 ${count}개 모두에서 주차하는 로봇이 나왔습니다. 방법을 알려 준 사람은 없습니다. 진화가 로봇마다 아는 것은 평균 비용 J뿐이었습니다.`
    : `${generation}세대 뒤에 진화는 로봇 ${count}대 가운데 ${parked}대를 주차시킵니다.`;
}

/** Where evolution has gone beyond the slider, and where that ends now. @param {number} before @param {number} ky @param {number} now */
export const beyond = (before, ky, now) =>
  `ky 슬라이더는 ${before}에서 끝났고 진화는 ${fixed(ky, 0)}까지 갔습니다. 이제 ${now}까지 움직일 수 있으니 직접 해 보십시오.`;

/** @param {Bred} newest */
export const climb = ({ generation, parked, drives }) =>
  `${generation}세대의 최우수: ${parked}대 주차 · ${grouped(drives)}번 주행`;
/** At its upper end. @param {number} count */
export const climbAxis = (count) => `주차 ${count}대`;
/** @param {number} parked */
export const yoursParked = (parked) => `직접 ${parked}`;

/** @param {number} parked */
export const youParked = (parked) => `직접 찾은 숫자로 주차한 로봇은 ${parked}대입니다.`;

export const parkedColumn = '주차';
export const bestByHand = '직접';
export const evolved = '진화';
export const sliders = '슬라이더: 직접 고른 숫자';
/** What moves along the sliders. @param {boolean} isWalking */
export const marks = (isWalking) => (isWalking ? '그 사이의 숫자' : '진화의 최우수');
/** @param {number} value */
export const gain = (value) => fixed(value, 1);
/** @param {number} parked @param {number} count */
export const share = (parked, count) => `${count}대 중 ${parked}대`;

export const walk = '직접 고른 세 숫자에서 진화의 세 숫자로';
/** @param {number} percent */
export const walked = (percent) => `진화의 세 숫자 쪽으로 ${percent}%`;
/** @param {readonly string[]} gains @param {number} parked @param {number} count */
export const walkedTo = (gains, parked, count) => `${gains.join(', ')}: ${count}대 중 ${parked}대 주차`;

/** @param {number} robot @param {number} count @param {number} seconds */
export const parkedAfter = (robot, count, seconds) =>
  `로봇 ${count}대 중 ${robot}번 로봇은 ${fixed(seconds, 1)}초 만에 주차했습니다.`;
/** @param {number} robot @param {number} count @param {Missed} missed */
export function missed(robot, count, { seconds, ahead, aside, degrees, gain: name, asks }) {
  const off = [
    ahead && `${ahead > 0 ? '목표에 못 미쳐' : '목표를 지나쳐'} ${fixed(Math.abs(ahead), 2)} m`,
    aside && `옆으로 ${fixed(Math.abs(aside), 2)} m`,
    degrees && `방향으로 ${fixed(Math.abs(degrees), 1)}°`,
  ];
  const asked = asks.map(({ value, unit }) => `${fixed(value, 3)} ${unit}`).join(', ');
  return `로봇 ${count}대 중 ${robot}번 로봇은 주차하지 못했습니다. ${fixed(seconds, 0)}초 뒤에 ${off.filter(Boolean).join(', ')} 벗어나 있습니다. 이를 바로잡는 이득은 ${name}이며, 그곳에서 ${asked}를 명령합니다.`;
}
export const watchThis = '이 로봇을 실험실에서 보기';
export const previous = '앞 로봇';
export const next = '다음 로봇';
export const close = '닫기';
