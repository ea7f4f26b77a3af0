// The step “disturbance” in Korean.
import { fixed } from '../../../words/numbers.js';

export const disturbance = {
  texts: {
    slip: `지금까지 바퀴는 제한 안에서는 시킨 대로 정확히 움직였습니다. 이제 바닥이 미끄러집니다. 이런 방해를 *외란(disturbance)*이라고 합니다. 로봇이 내는 선속도가 얼마이든 거기에 {=push} m/s가 더해집니다. 로봇은 목표를 지나쳐 {=distance}\u00a0m 떨어진 곳에 서고, 더는 움직이지 않습니다. 확대한 그림은 마지막 몇 센티미터를 보여 줍니다.`,
    why: `왜 하필 거기일까요? 그 자리에서 법칙은 {=command} m/s를 명령합니다. 바닥이 앞으로 미끄러지는 만큼 뒤로 가라는 명령입니다. 목표에 더 가까우면 명령 {kx} {xe} cos {te}가 바닥의 미끄러짐보다 약합니다.`,
    theorem: `바닥이 어떻게 미는지 알아야 할까요? 정리 2에는 크기의 *상한*만 있으면 됩니다. 선속도에 더해지는 {d1}의 크기는 {e1}을, 각속도에 더해지는 {d2}의 크기는 {e2}를 넘지 않습니다. 외란은 {V}의 변화율에 ({ye} sin {te} − {xe} cos {te}) {d1} − {d2} sin {te}를 더합니다. 이것을 풀어 쓰면 4단계의 세 항과 하나씩 짝을 이룹니다. 4단계의 각 항이 자기 짝보다 큰 동안(크기로 비교하여), 곧 다음 세 부등식이 성립하는 동안 {V}는 줄어듭니다.`,
    sets: `목표 가까이에서는 셋이 모두 성립할 수 없습니다. 우선 (6)의 우변부터 끝없이 커지기 때문입니다. 그래서 오차가 남을 수 있습니다. 부등식을 각각 오차에 대해 풀면 0을 둘러싼 *집합*이 하나씩 나옵니다. 곡선 아래의 띠와, 목표 둘레를 확대한 그림의 띠가 그것이며, 가장자리는 파선입니다. *이득이 클수록 집합은 작아집니다.* 논문에 따르면 이렇게 하여 허용할 오차에 맞는 이득을 고릅니다.`,
    unknown: `정리가 다루지 않는 것은 무엇일까요? *제한*: 논문은 제한이 잘라 낸 만큼을 외란의 일부로 보지만, sin {te} = 0 가까이에서는 그 크기에 상한이 없습니다. *샘플링*: 이득이 250이면 1초에 100번만 명령을 바꾸는 로봇은 *채터링*을 일으킵니다. 그리고 *시간*: 외란이 없고 이득이 모두 0보다 크면 오차는 0으로 수렴하지만, 얼마나 빨리 수렴하는지는 말하지 않습니다. {ky} = {=ky}일 때 다른 출발점 {=starts}개에서는 {=horizon}초 가운데 마지막 {=last}초에도 {ye}가 최대 {=left}\u00a0m 남아 있습니다.`,
    next: `증명할 수 있는 것은 여기까지입니다. 이제 논문의 수치를 봅시다. 이 페이지의 수치와 맞을까요?`,
  },
  near: {
    again: '다시 주행',
    /** @param {number} across @param {number} time @param {number} distance */
    caption: (across, time, distance) =>
      `위에서 본 모습, 폭 ${metres(across)} m. ${fixed(time, 2)}초 뒤 로봇은 목표에서 ${fixed(distance, 3)} m 떨어져 있습니다.`,
    /** @param {number} across @param {number} distance */
    label: (across, distance) =>
      `위에서 본 목표, 폭 ${metres(across)} m. 마지막에 로봇은 목표에서 ${fixed(distance, 3)} m 떨어져 있습니다.`,
  },
  holds: {
    /** @param {boolean} holds @param {string} formula @param {string} size @param {string | null} set Null: nothing pushes against it. */
    one: (holds, formula, size, set) => {
      if (set === null) return '성립: 외란 없음';
      const just = size === set ? '바로 ' : '';
      return holds
        ? `성립: ${formula} = ${size}, 경계 ${set}의 ${just}바깥쪽`
        : `불성립: ${formula} = ${size}, 경계 ${set}의 ${just}안쪽`;
    },
    /** @param {number} time @param {number} count @param {boolean} isCut Whether the limits leave less of the command. */
    all: (time, count, isCut) =>
      count < 3
        ? `${fixed(time, 2)}초: 셋 모두 성립하지는 않습니다. 여기서 정리는 아무것도 보장하지 않습니다.`
        : isCut
          ? `${fixed(time, 2)}초: 셋 모두 성립합니다. 그러나 제한이 명령을 잘라 냈고 이만큼의 외란은 여기의 ε에 들어 있지 않으므로, {V}가 커질 수도 있습니다.`
          : `${fixed(time, 2)}초: 셋 모두 성립합니다. 정리에 따라 {V}가 줄어듭니다.`,
  },
  quizzes: {
    double: {
      question: '세 이득을 모두 두 배로 합니다. 로봇은 어디에 섭니까?',
      choices: ['같은 곳', '목표까지의 거리가 약 절반인 곳', '목표 위'],
      /** @param {{ before: number, after: number }} outcome */
      why: ({ before, after }) =>
        `${fixed(before, 3)} m가 아니라 ${fixed(after, 3)} m 떨어진 곳입니다. 이득이 두 배이면 오차가 절반이어도 같은 명령이 나옵니다. 그러나 어떤 이득도 오차를 0으로 만들지는 못합니다. 오차가 없으면 명령도 없고, 바닥은 계속 미끄러지기 때문입니다.`,
    },
    random: {
      question:
        '이번에는 *무작위 외란*입니다. 1초에 100번, 매번 −0.1과 0.1 m/s 사이에서 새로 뽑습니다. 논문의 EP 이득으로 달리는 로봇은 마지막에 목표에서 얼마나 떨어져 있습니까?',
      choices: ['미끄러질 때보다 멀리', '똑같이', '미끄러질 때보다 가까이'],
      /** @param {{ steady: number, random: number }} outcome */
      why: ({ steady, random }) =>
        `마지막 2초 동안 ${fixed(random, 3)} m 안에 머뭅니다. 미끄러질 때는 ${fixed(steady, 3)} m였습니다. 부호가 계속 바뀌는 외란은 대부분 서로 상쇄되지만 일정한 미끄러짐은 사라지지 않습니다. 어려운 것은 일정한 외란입니다.`,
    },
  },
  tries: {
    turning: '회전까지 일으키는 미끄러짐: 0.2 rad/s',
    aside: '옆에서 출발하면 셋이 성립하는가?',
    evolved: '회전을 일으키는 미끄러짐과, 출발점 하나로 진화시킨 이득',
    huge: '이득 250과 0.1 m/s의 미끄러짐',
  },
  notice: [
    '앞으로 미끄러질 때 로봇은 정확히 (6)의 집합의 경계에서 멈춥니다. 집합이 이보다 작다면 정리가 틀린 것이 됩니다.',
    '회전을 일으키는 미끄러짐에서는 |sin θₑ|가 자기 집합을 조금 벗어납니다. 그래도 모순이 아닙니다. 정리가 무언가를 보장하는 곳은 *세 집합 모두*의 밖뿐이며, 하나라도 그 안에 있으면 다른 오차가 아무리 커도 아무것도 보장하지 않습니다.',
    '{ky}가 0에 가까우면 (7)의 집합은 폭이 몇 미터나 됩니다. 진화가 아낀 {ky}가 여기서는 아쉽습니다.',
    '선속도의 무작위 외란에서는 {xe}와 {ye}가 집합의 훨씬 안쪽에 머뭅니다. 정리는 가장 나쁜 경우를 가정하기 때문입니다.',
  ],
};

/** @param {number} value */
const metres = (value) => String(Number(value.toFixed(1)));
