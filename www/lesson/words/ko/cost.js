// The step “cost” in Korean.
import { costText, fixed } from '../../../words/ko/numbers.js';

/** @typedef {import('../../../core/engine.js').Run} Run */

export const cost = {
  texts: {
    parts: `급한 주행, 느긋한 주행, 끝내 도착하지 못하는 주행 가운데 어느 것이 *좋은* 주행일까요? 누군가 정해서 수 하나로 말해야 합니다. 저자들은 다섯 가지 비용을 더합니다.`,
    each: `*시간*은 도착할 때까지 걸린 시간입니다. *최종* 오차는 마지막에 남은 오차입니다. *경로*는 주행하는 동안의 위치와 방향의 오차를 제곱하여 시간에 대해 적분한 것이어서, 멀리 오래 머물수록 커집니다. *에너지*는 선속도와 각속도를 제곱하여 적분한 것입니다. 경로와 에너지는 적분한 값의 절반만 더합니다. 그렇게 계산한 이 주행의 에너지는 {=energy}입니다. 끝으로 *벌점*은 0보다 작은 이득에 매깁니다. ({p}는 자세, {pr}은 목표의 자세, {q}는 {v}와 {w}입니다.) 한 부분을 가리키면 막대에서 그 몫이 강조됩니다.`,
    weights: `1초의 비용은 얼마이고, 급한 회전의 비용은 얼마일까요? 그것을 정하는 수가 *가중치*입니다. {Rv}와 {Rw}는 주행과 회전의 가중치이고(둘을 묶어 {R}), {W}는 마지막에 남은 오차의, {kappa}는 벌점의 가중치입니다. *논문에는 이 값들이 없습니다.* 여기서는 1로, {kappa}만 1,000으로 정했습니다. 가중치가 달라지면 가장 좋은 주행도 달라집니다. 주행 네 개가 글 옆에 있습니다. 하나를 눌러 몰아 보고, 가중치를 움직여 보십시오.`,
    ky: `{ky}는 어떨까요? 이 페이지의 가중치로 논문의 출발점에서 {kx} = 3, {kt} = 5로 달리면 J는 {ky}가 0일 때 {=none}, 1일 때 {=one}, 8일 때 {=eight}입니다. 3단계에서 보았듯이 거기서는 {ky}가 필요 없으므로, 쓰는 만큼 비용만 늘어납니다. J는 이 주행 하나만 계산합니다. 이 점을 기억해 두십시오.`,
    next: `이렇게 진화는 낮추어야 할 수 하나를 받습니다. 로봇에 대해 아는 것은 그것뿐입니다. 그것만으로 어떻게 찾을까요?`,
  },
  standings: {
    caption: '지금의 가중치로 계산한 주행들의 비용',
    /** @param {string} seconds */
    dots: (seconds) => `점은 ${seconds}초마다 하나, 간격이 넓을수록 빠릅니다. 옅은 선: 다른 주행.`,
    gentle: '느긋하게',
    lowest: '가장 낮음',
    nobody: '이득을 움직이면 직접 조정한 주행이 여기에 나타납니다.',
  },
  quizzes: {
    heavier: {
      question:
        '{Rv}와 {Rw}가 1이면 논문의 EP 이득이 임의 이득이나 느긋한 이득보다 비용이 낮습니다. 5로 올리면 주행과 회전의 비용이 다섯 배가 됩니다. 그때는 어느 이득의 비용이 가장 낮습니까?',
      choices: [
        '이번에도 EP 이득: 진화가 찾은 것이므로',
        '임의 이득: 가장 먼저 도착하므로',
        '느긋한 이득: 가장 늦게 도착하지만',
      ],
      /** @param {{ runs: Run[] }} outcome */
      why: ({ runs: [ep, arbitrary, gentle] }) =>
        `이제 J는 EP 이득이 ${costText(ep.cost.total)}, 임의 이득이 ${costText(arbitrary.cost.total)}, 느긋한 이득이 ${costText(gentle.cost.total)}입니다. 그중 에너지는 차례로 ${fixed(ep.cost.energy, 1)}, ${fixed(arbitrary.cost.energy, 1)}, ${fixed(gentle.cost.energy, 1)}입니다. 주행은 그대로이고, 비용을 매기는 기준만 바뀌었습니다.`,
    },
    home: {
      question:
        '두 가중치가 100이고, 이득이 모두 0인 로봇이 있습니다. 10초 동안 제자리에 서 있을 뿐 도착하지 못합니다. 느긋한 로봇은 도착합니다. 어느 로봇의 J가 더 낮습니까?',
      choices: ['느긋한 로봇: 할 일을 하므로', '제자리에 머무는 로봇'],
      /** @param {{ stays: Run, drives: Run }} outcome */
      why: ({ stays, drives }) =>
        `제자리에 있으면 ${costText(stays.cost.total)}입니다. 시간 ${fixed(stays.cost.time, 0)}, 경로 ${fixed(stays.cost.path, 1)}, 최종 ${fixed(stays.cost.finalError, 1)}입니다. 느긋한 주행은 ${costText(drives.cost.total)}이고 그중 에너지가 ${fixed(drives.cost.energy, 1)}입니다. J는 우리의 뜻을 모릅니다. 더하라고 한 것을 더할 뿐입니다.`,
    },
  },
  tries: {
    cheap: '두 가중치 0.1, 움직임의 비용이 작다: 급한 주행이 이긴다',
    evolved: '두 가중치 100: 60세대의 진화가 찾아낸 것',
    final: '두 가중치 100, {W}도 100: 제자리에 머무는 비용이 다시 커진다',
    negative: '이득 하나를 0보다 조금 작게, {ky} = −0.01: 벌점이 붙고, 로봇은 더 이상 도착하지 못한다',
  },
  notice: [
    '가중치는 지금 보는 주행을 바꾸지 않습니다. 주행의 비용을 바꾸고, 그래서 진화가 남길 주행을 바꿉니다.',
    '도착하면 마지막에 남은 오차의 비용은 거의 없습니다. 여기서 도착이란 5 cm와 0.05 rad 안에 드는 것입니다.',
  ],
};
