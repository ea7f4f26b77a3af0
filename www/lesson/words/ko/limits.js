// The step “limits” in Korean.
import { largest } from '../../../kit/extent.js';
import { costText, fixed, grouped } from '../../../words/ko/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */
/** @typedef {{ run: Run, rises: number }} Driven */

export const limits = {
  asked: {
    /** @param {string} asked @param {string} done */
    label: (asked, done) =>
      `시간에 따른 법칙의 명령과 바퀴의 실제 속도. 법칙은 ${asked} rad/s까지 명령하고, 바퀴는 ${done} rad/s까지 냅니다.`,
    linear: 'v, m/s, 로그',
    angular: 'ω, rad/s, 로그',
    asked: '명령',
    done: '실제',
    limit: '제한',
  },
  texts: {
    asked: `법칙이 명령하면 바퀴가 따릅니다. 논문의 EP 이득으로 달릴 때 법칙은 {=askedV} m/s와 {=askedW} rad/s까지 명령합니다. 논문의 로봇은 {=v} m/s와 {=w} rad/s까지만 낼 수 있습니다. 그림에서 가는 선이 명령, 굵은 선이 실제 속도입니다(0 근처를 빼면 로그 축). 제한(파선)을 넘는 부분은 잘립니다. 이를 *포화(saturation)*라고 합니다. 로봇은 길의 대부분을 최대 선속도로 달립니다.

제한이 없으면 더 좋을까요? 4단계의 증명은 제한이 없다고 가정합니다.`,
    theory: `증명과 실제 로봇 사이에는 틈이 있습니다. 증명에서는 법칙이 *매 순간* 작용하지만, 컴퓨터는 100분의 1초마다, 곧 *샘플*마다 한 번 명령을 정하고 다음 샘플까지 그 값을 유지합니다. 아주 큰 명령이 유지되면 로봇은 지나치게 많이 회전합니다. sin {te}가 0인 곳에서는 명령이 한없이 커지므로, 더 빠른 컴퓨터도 별로 도움이 되지 않습니다. 그래서 {V}가 샘플마다 줄어든다는 보장이 없습니다. 제한 없이 이 이득으로 달리면 샘플 {=samples}개 가운데 {=rises}개에서 {V}가 커집니다. (이런 주행은 아주 *민감하여*, 정확히 몇 개인지는 계산의 마지막 자리에 따라 달라집니다.)

속도 제한이 이 틈을 메울까요? 논문의 출발점만 보면 그렇게 보입니다. 제한이 있으면 {V}는 모든 샘플에서 줄어듭니다.`,
    clipped: `{v}의 항과 {w}의 항은 함께 있어야만 소거됩니다. 그런데 제한은 {v}와 {w}를 *따로* 자르므로, 소거되어야 할 것이 소거되지 않습니다. (둘을 같은 비율로 줄인다면 {V}는 계속 줄어듭니다.) 게다가 명령은 여전히 다음 샘플까지 유지됩니다. 그래서 제한이 있어도 {V}는 잠시 커질 수 있습니다. 바퀴가 포화된 로봇에 대해 증명은 아무것도 보장하지 않습니다. *가속도* 제한이 더해지면 로봇이 늦게 반응하여, 법칙이 멈추라는 곳에서 멈추지 못합니다.`,
    next: `그러니 이론만으로 정해지는 가장 좋은 이득은 없습니다. 무엇이 가장 좋은지는 바퀴와 출발점에, 그리고 무엇을 “좋다”고 하는지에 달려 있습니다. 다음 단계에서는 그 “좋다”는 말을 다룹니다.`,
  },
  quizzes: {
    free: {
      question: '논문의 EP 이득으로 속도 제한 없이 달리면 J는 어떻게 됩니까?',
      choices: ['낮아진다', '거의 그대로다', '높아진다'],
      /** @param {{ free: Driven, limited: Driven }} outcome */
      why: ({ free, limited }) =>
        `J는 ${costText(limited.run.cost.total)} → ${costText(free.run.cost.total)}입니다. 로봇은 ${arrival(free.run)}. 목표 가까이에서 {te}는 거의 0인데, 법칙은 그 사인으로 나눕니다. 그래서 명령이 큰 양수와 큰 음수 사이를 오갑니다. 이를 *채터링(chattering)*이라고 합니다. 가장 큰 각속도는 ${grouped(Math.round(largest(free.run.angular.map(Math.abs))))} rad/s이고, 에너지는 그 제곱에 비례합니다.`,
    },
    heals: {
      question:
        '속도 제한을 둔 채 논문의 EP 이득으로 출발점 100개에서 달립니다. 출발점은 목표에서 1~4 m 떨어져 있고 방향은 제각각입니다. {V}가 한 번이라도 커지는 주행은 몇 번입니까?',
      choices: ['10번 미만', '10~50번', '절반이 넘는다'],
      /** @param {{ drives: number, starts: number }} outcome */
      why: ({ drives, starts }) =>
        `${starts}번 중 ${drives}번입니다. 평면의 주행은 이들과 출발점이 다르지만 역시 그런 주행입니다. {V}의 선이 굵은 곳과 그 아래의 표시를 보십시오.`,
    },
    brakes: {
      question: '이득 10, 10, 10은 속도만 제한할 때 일찍 도착합니다. 이제 가속도도 제한하면 언제 도착합니까?',
      choices: ['더 일찍', '조금 늦게', '훨씬 늦게, 또는 도착하지 못한다'],
      /** @param {{ limited: Driven, sluggish: Driven }} outcome */
      why: ({ limited, sluggish }) =>
        `속도만 제한하면 로봇은 ${arrival(limited.run)}. 가속도까지 제한하면 ${arrival(sluggish.run)}. {V}가 커지는 샘플은 ${limited.rises}개 → ${sluggish.rises}개입니다. 큰 이득에는 빠른 바퀴가 필요합니다. J는 ${costText(limited.run.cost.total)} → ${costText(sluggish.run.cost.total)}입니다.`,
    },
  },
  tries: {
    raised: '3단계의 앞뒤로 오가는 주차, 제한을 둔 채: {V}가 커지지만 로봇은 그래도 점점 가까워진다',
    figure4: '그림 4: 속도 제한에서 EP 이득과 임의 이득',
    figure5: '그림 5: 같은 주행을 시간에 따라',
    figure6: '그림 6: 가속도 제한에서 EP 이득과 임의 이득',
    figure7: '그림 7: 같은 주행을 시간에 따라',
  },
  notice: [
    '가속도를 제한하면 선속도는 0에서 시작해 직선으로 커집니다. 어떤 명령으로도 바퀴를 단번에 돌리지 못합니다.',
    '이 페이지의 그림 7에서 점선의 로봇은 논문이 이 바퀴에 맞추어 고른 임의 이득 30, 30, 30으로 달립니다. 목표 방향각을 훨씬 넘게 돌았다가 되돌아오고, 끝내 도착하지 못합니다. 논문의 로봇은 그만큼 돌지 않습니다. 이 차이는 14단계에서 다시 다룹니다.',
    '{v}와 {w}의 곡선에서 가는 선은 법칙의 명령입니다. 굵은 선이 가는 선과 겹치는 곳에서는 법칙이, 그 밖에서는 제한이 로봇을 움직입니다.',
  ],
};

/** @param {Run} run */
const arrival = (run) => (run.arrived ? `${fixed(run.finalTime, 2)}초 뒤에 도착합니다` : '도착하지 못합니다');
