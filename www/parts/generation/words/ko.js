// Every word of the generation part, in Korean.
/** @import { Anatomy, Phase } from '../record.js' */
/** @import { Others } from './common.js' */
import { costsApart, costWriter, luckSign, tellingApart } from './common.js';
import { nameOf, sentenceOfMethod } from './methods-ko.js';
import { arrivedText } from '../../../words/ko/arrived.js';
import { fixed } from '../../../words/ko/numbers.js';

export * from './common.js';
export * from './methods-ko.js';

export const texts = {
  generationPicture: '세대',
  generationTable: '세대 표',
  generationStep: '세대의 단계',
  generationBack: '이전 단계',
  generationDetails: '선택한 개체',
};

export const phaseLegend = '세대의 단계';

/** @param {number} generation */
export const title = (generation) => `${generation}세대`;

/** @param {Anatomy} anatomy */
export const beginText = ({ record }) => `${record.generation + 1}세대 만들기`;
export const next = '다음';
/** @param {string} name */
export const nextPhase = (name) => `: ${name}`;
/** @param {number} generation */
export const nextGeneration = (generation) => `: ${generation}세대`;

/** Korean has no capitals. @param {string} text */
export const capital = (text) => text;

/** What happens in a phase. @param {Anatomy} anatomy @param {Phase} phase */
export function sentence(anatomy, phase) {
  const { count, all, record, method } = anatomy;
  const { generation, offspring, parents, survivors } = record;
  if (method !== 'ep') return sentenceOfMethod(anatomy, phase, costWriter(anatomy));
  if (generation === 0)
    return phase === 'survivors'
      ? count === 1
        ? '이 로봇이 남아 1세대의 부모가 됩니다.'
        : `로봇 ${count}대가 모두 남아 J 순서로 늘어섭니다. 이들이 1세대의 부모입니다.`
      : `무작위 이득을 가진 로봇 ${count}대를 뽑은 순서대로 보여 줍니다. 아직 경쟁은 없었습니다.`;
  const better = offspring.filter(({ cost }, i) => cost < parents[i].cost).length;
  const stayed = survivors.filter((number) => number < count).length;
  const crossed = record.donors.filter(({ length }) => length > 0).length;
  return {
    parents: `${generation > 1 ? `${generation - 1}세대에서 살아남은 로봇 ${count}대를 순위가 높은 것부터` : `0세대의 로봇 ${count}대를 J가 낮은 것부터`} 보여 줍니다. J는 낮을수록 좋습니다.`,
    mutation: `부모마다 자손을 하나씩 만듭니다. 이득은 이전 σ에 난수를 곱한 만큼 움직입니다.${crossed > 0 ? ` 부모 로봇 ${count}대 중 ${crossed}대는 그에 앞서 다른 부모와 교차합니다.` : ''}`,
    drive: `자손이 주행하여 J를 얻습니다. 자손 로봇 ${count}대 중 부모보다 잘 주행하는 것은 ${better}대입니다.`,
    tournament: `로봇 ${all.length}대가 각각 무작위로 뽑은 로봇 ${record.opponents[0]?.length}대와 겨룹니다. J가 상대보다 높지 않으면 이깁니다.`,
    ranking:
      record.wins.length > 0
        ? `승수가 많은 순서로, 승수가 같으면 J가 낮은 순서로 늘어섭니다. 선은 ${count}위 아래에 긋습니다.`
        : `살아남는 로봇, 탈락하는 로봇의 순서로, 각 무리 안에서는 J가 낮은 순서로 늘어섭니다. 선은 ${count}위 아래에 긋습니다.`,
    survivors: `σ와 함께 남는 것은 부모 로봇 ${stayed}대, 자손 로봇 ${count - stayed}대입니다. 이들이 ${generation + 1}세대의 부모입니다.`,
  }[phase];
}

/** @param {number} count */
export const winsText = (count) => `${count}승`;

/** One that survives though a better one fell. @param {Anatomy} anatomy */
export function upsetText(anatomy) {
  const { upset, all, record } = anatomy;
  if (!upset)
    return `${record.wins.length > 0 ? '이번에는 ' : ''}J가 가장 낮은 로봇 ${anatomy.staying}대가 그대로 남습니다.`;
  const { survivor, fallen } = upset;
  const [a, b] = [all[survivor].cost, all[fallen].cost];
  const write = costsApart(a - b);
  if (record.wins.length === 0)
    return `${nameOf(anatomy, survivor)}(J ${write(a)}): 생존. 더 좋은 ${nameOf(anatomy, fallen)}(J ${write(b)}): 탈락. 서로 겨루지 않고 각자 ${record.mutations.length > 0 ? '자기 부모' : '원래 개체'}와만 비교합니다.`;
  return `${nameOf(anatomy, survivor)}(J ${write(a)}): ${winsText(record.wins[survivor])}, 생존. ${nameOf(anatomy, fallen)}(J ${write(b)}): ${winsText(record.wins[fallen])}, 탈락. 상대를 잘 만난 운입니다.`;
}

/** @param {number} expected @param {number} wins */
export const luckText = (expected, wins) => `기대 ${fixed(expected, 1)}승, 운 ${luckSign(expected, wins)}`;

/** @param {string} name @param {number} generation */
export const drivingText = (name, generation) => `${generation}세대의 ${name}`;

/** @param {Anatomy} anatomy @param {Phase} phase @param {Others} others */
export function othersText({ method, record }, phase, { drawn, all, isAmong, arrived }) {
  const kind =
    method === 'ep'
      ? { parents: '부모 로봇', mutation: '부모 로봇', drive: '자손 로봇', survivors: '생존 로봇' }
      : { parents: '로봇', mutation: '로봇', drive: '시험 로봇', survivors: isAmong ? '로봇' : '남은 로봇' };
  const these = isAmong ? '나머지 ' : '';
  const bouts = `대결 ${record.opponents[0]?.length ?? 0}번에서 만난 상대 로봇`;
  const who = phase === 'tournament' ? bouts : `${these}${phase === 'ranking' ? '로봇' : kind[phase]}`;
  const told = drawn < all ? `${who} ${all}대 중 ${drawn}대` : `${who} ${all}대`;
  return arrived === null ? told : `${told}, ${arrivedText(arrived, drawn)}`;
}

export const pictureLabel = '이 세대의 개체. 화살표 키로 하나를 고릅니다';

/** What is said of the one that is chosen. @param {Anatomy} anatomy @param {Phase} phase @param {number} number */
export function chosenText(anatomy, phase, number) {
  const { count, staying, all, record, ranks } = anatomy;
  const undriven = phase === 'mutation' && number >= count;
  return [
    nameOf(anatomy, number),
    undriven ? '아직 주행하지 않음' : `J ${costWriter(anatomy)(all[number].cost)}`,
    ...(phase === 'ranking' || phase === 'survivors' ? standing() : []),
  ].join(', ');

  function standing() {
    const rank = ranks[number] + 1;
    if (record.generation === 0) return [`${rank}위`];
    return [
      ...(record.wins.length > 0 ? [winsText(record.wins[number])] : []),
      `로봇 ${all.length}대 중 ${rank}위`,
      rank <= staying ? '생존' : '탈락',
    ];
  }
}

/** The axis of J where it is too narrow for J itself. @param {string} text how far, from the best on @param {number} i */
export const beyondBest = (text, i) => (i === 0 ? '최소' : `+${text}`);
/** Of the thin lines that lead to the marks. */
export const byCostText = '— J만으로 정한 순위에서';
export const winsAxis = '승';
export const pairAxis = '쌍';
export const robotAxis = '로봇';
/** Of those that stay, best ranked first. @param {Anatomy['method']} method */
export const survivorAxis = (method) => (method === 'ep' ? '부모' : '순위');
export const wonText = '승, 상대:';
export const lostText = '패, 상대:';

/** @param {number} rank @param {number} generation */
export const ranked = (rank, generation) => `${generation}세대 ${rank}위`;

/** Whom one followed until then. @param {Anatomy} anatomy @param {string} name */
export const fallenText = ({ record, method }, name) =>
  `여기까지 보던 ${name}: ${record.generation - 1}세대에서 ${method === 'ep' ? '탈락' : '버려짐'}`;

/** Of the pictures beside k and σ. */
export const bellsText = '종 모양: 자손의 이득이 놓일 법한 곳, 세 이득에 같은 눈금';

export const commonText = ': 세 σ에 공통인 난수 N';
export const crossedWith = '교차 상대: ';
/** @param {readonly string[]} gains */
export const givenText = (gains) =>
  gains.length > 0 ? `, σ와 함께 받은 이득: ${gains.join(', ')}` : ', 받은 이득 없음';
/** What becomes of gains that are drawn there. */
export const belowZeroText = {
  mirror: '0보다 작은 이득은 시험하기 전에 0을 기준으로 뒤집습니다.',
  clamp: '0보다 작은 이득은 시험하기 전에 0으로 바꿉니다.',
};
/** @param {string} sigma */
export const floorText = (sigma) => `σ는 ${sigma} 아래로 내려가지 않습니다.`;
export const cauchyText = 'C는 코시 분포에서, N은 정규분포에서 뽑은 난수입니다.';

/** What stands before the name of the other. @param {number} own @param {number} other */
export const comparedText = (own, other) =>
  own === other ? '다음과 같음: ' : own < other ? '다음보다 좋음: ' : '다음보다 나쁨: ';

/** @param {number} starts */
export const meanText = (starts) => `J는 출발점 ${starts}개의 평균이며, 평면은 첫 번째를 보여 줍니다.`;

/** @param {number} wins @param {number} bouts */
export const sumText = (wins, bouts) => `${bouts}전 ${winsText(wins)}`;

/** @param {number} rest */
export const moreBouts = (rest) => `그 밖에 ${rest}전`;

/** @param {Anatomy} anatomy @param {number} number */
export function fateText({ ranks, staying, record, all, method }, number) {
  const rank = ranks[number] + 1;
  if (method === 'random') return `로봇 ${staying}대 중 ${rank}위`;
  if (method !== 'ep') return rank > staying ? '버려짐' : `남음(로봇 ${staying}대 중 ${rank}위)`;
  if (rank > staying) return `탈락(로봇 ${all.length}대 중 ${rank}위)`;
  return `생존\u2060(${record.generation + 1}세대의 부모 ${rank})`;
}

/** @param {Anatomy['method']} method @param {number} before @param {number} after @param {(cost: number) => string} usual */
export function bestText(method, before, after, usual) {
  const write = tellingApart(before, after, usual);
  if (method === 'random')
    return `이번에 뽑은 것 가운데 최소 J는 ${write(after)}, 앞 세대에서는 ${write(before)}입니다. 기억하는 것은 지금까지의 최소뿐입니다.`;
  return after < before
    ? `최소 J가 ${write(before)}에서 ${write(after)}까지 내려갑니다.`
    : after === before
      ? `최소 J는 ${write(after)} 그대로입니다.${method === 'ep' ? ' 최우수 개체는 언제나 살아남습니다.' : ''}`
      : `최소 J가 ${write(before)}에서 ${write(after)}까지 올라갑니다. 이 탐색은 전에 찾은 것을 잊습니다.`;
}

/** Where the slope was probed. @param {string} cost of the robot @param {boolean} isLower Whether a probe's is lower. */
export const probedText = (cost, isLower) =>
  `로봇의 J는 ${cost} 그대로입니다.${isLower ? ' 시험점은 기울기만 재므로, J가 더 낮아도 채택하지 않습니다.' : ''}`;

/** @param {Anatomy} anatomy */
export function tableCaption(anatomy) {
  const { record, count, all } = anatomy;
  const counts = (/** @type {number} */ number) => `${nameOf(anatomy, number)}의 번호는 ${number}`;
  return record.generation === 0
    ? `0세대: 무작위 이득을 가진 로봇 ${count}대. 코어의 기록은 0부터 셉니다. ${counts(0)}입니다.`
    : `${record.generation}세대의 로봇 ${all.length}대 전체. 코어의 기록은 0부터 셉니다. ${counts(0)}, ${counts(count)}입니다. ${record.wins.length > 0 ? '승수가 많은' : '남는 로봇이 먼저 오는'} 순서입니다.`;
}
const columns = ['순위', '개체', '번호', '부모', 'kx', 'ky', 'kθ', 'σx', 'σy', 'σθ', 'J', '승', '생존'];
/** @param {Anatomy['method']} method */
export const columnsOf = (method) => {
  const own = { de: { 부모: '원래 개체, a, b, c' }, 'cma-es': { 승: '가중치' } };
  const names = /** @type {Readonly<Record<string, string>>} */ (
    method === 'de' || method === 'cma-es' ? own[method] : {}
  );
  return columns.map((name) => names[name] ?? name);
};
export const yes = '예';
export const no = '아니요';
