// What Generation says of the methods, each in its own terms, in Korean.
/** @import { Anatomy, Method, Phase } from '../record.js' */
import { areProbesOnePoint, deviationRatio, sigmaText, turnIn } from './common.js';
import { gains } from '../../../words/ko/lab.js';
import { fixed } from '../../../words/ko/numbers.js';

/** What was there before, and what is tried. @type {Readonly<Record<Method, readonly [before: string, tried: string]>>} */
const nouns = {
  ep: ['부모', '자손'],
  random: ['이전 표본', '표본'],
  de: ['개체', '시험 벡터'],
  'cma-es': ['이전 표본', '표본'],
  'one-plus-one-es': ['부모', '자손'],
  'nelder-mead': ['꼭짓점', '시험점'],
  'one-at-a-time': ['로봇', '시험점'],
  'finite-differences': ['로봇', '시험점'],
};

/** @param {Anatomy} anatomy @param {'parent' | 'offspring'} kind */
export const keyOf = ({ method }, kind) => nouns[method][kind === 'parent' ? 0 : 1];

/** An individual's name: those of generation 0 have no parents and no offspring. @param {Anatomy} anatomy @param {number} number */
export function nameOf({ count, record, method }, number) {
  if (record.offspring.length === 0) return `로봇 ${number + 1}`;
  const [before, tried] = nouns[method];
  return number < count ? `${before} ${number + 1}` : `${tried} ${number - count + 1}`;
}

/** @type {Readonly<Record<Method, Readonly<Partial<Record<Phase, string>>>>>} */
const phaseNames = {
  ep: { parents: '부모', mutation: '돌연변이', survivors: '생존' },
  random: { parents: '이전', mutation: '뽑기', survivors: '남는 것' },
  de: { parents: '개체', mutation: '차분', survivors: '교체' },
  'cma-es': { parents: '타원', mutation: '표본', ranking: '가중치', survivors: '새 타원' },
  'one-plus-one-es': { parents: '부모', mutation: '걸음', survivors: '1/5 규칙' },
  'nelder-mead': { parents: '심플렉스', mutation: '이동', survivors: '새 심플렉스' },
  'one-at-a-time': { parents: '로봇', mutation: '이득 하나', survivors: '다음 걸음' },
  'finite-differences': { parents: '로봇', mutation: '시험', survivors: '기울기' },
};
/** @type {Readonly<Partial<Record<Phase, string>>>} */
const usual = { drive: '주행', tournament: '토너먼트', ranking: '순위' };

/** @param {Pick<Anatomy, 'method'>} anatomy @param {Phase} phase */
export const phaseName = ({ method }, phase) => phaseNames[method][phase] ?? usual[phase] ?? phase;

const motions = {
  begin: '새 심플렉스',
  reflection: '반사',
  expansion: '확장',
  'outside-contraction': '바깥쪽 수축',
  'inside-contraction': '안쪽 수축',
  shrink: '축소',
};
const moves = {
  begin: '새 심플렉스: 하나를 뽑고, 그 점에서 이득마다 한 걸음씩 떨어진 점을 잡습니다.',
  reflection: '반사: 가장 나쁜 꼭짓점을 나머지 셋의 중심에 대하여 뒤집습니다.',
  expansion: '확장: 반사한 점이 모든 꼭짓점보다 좋으므로 두 배 멀리 가 봅니다.',
  'outside-contraction': '바깥쪽 수축: 반사한 점이 가장 나쁜 꼭짓점이 되므로 절반만 가 봅니다.',
  'inside-contraction':
    '안쪽 수축: 반사한 점이 모든 꼭짓점보다 나쁘므로 가장 나쁜 꼭짓점 쪽으로 절반을 가 봅니다.',
  shrink: '축소: 수축도 낫지 않아 세 꼭짓점이 가장 좋은 꼭짓점에 절반 다가갑니다.',
};

/** The gain whose turn it is. @param {Anatomy} anatomy */
function turnOf({ record: { generation, plan } }) {
  const turn = turnIn(generation);
  return { name: gains[turn].name, step: plan.steps?.[turn] ?? 0 };
}

/** @param {Anatomy} anatomy */
const isBetter = ({ record: { survivors, parents } }) => survivors.some((number) => number >= parents.length);

/** @param {readonly number[] | null} steps */
const lengthOf = (steps) => sigmaText(Math.hypot(...(steps ?? [0])));

/** @param {Anatomy} anatomy @param {(cost: number) => string} write */
const duel = ({ record: { parents, offspring } }, write) =>
  `J ${write(offspring[0].cost)}, 이전에는 ${write(parents[0].cost)}.`;

/** @typedef {(anatomy: Anatomy, write: (cost: number) => string) => string} Say */

/** @type {Readonly<Record<Exclude<Method, 'ep'>, Readonly<Partial<Record<Phase, Say>>>>>} */
const sentences = {
  random: {
    parents: ({ count, record }) =>
      `${record.generation - 1}세대에서 뽑은 로봇 ${count}대입니다. ${count === 1 ? '이 로봇' : '이들'}에게서 이어받는 것은 없습니다.`,
    mutation: ({ record }) =>
      `파선 상자 안 어디서나 로봇 ${record.offspring.length}대를 새로 뽑습니다. 앞의 결과에서 배운 것은 없습니다.`,
    drive: ({ count }) => `${count === 1 ? '' : '모두 '}주행하여 J를 얻습니다.`,
    survivors: () => '다음 세대도 같은 상자에서 뽑습니다. 지금까지 가장 좋은 로봇만 기억합니다.',
  },
  de: {
    parents: ({ count }) =>
      `개체 ${count}개를 순위가 높은 것부터 보여 줍니다. 개체마다 시험 벡터가 하나씩 생깁니다.`,
    mutation: () => '시험 벡터는 a에서 c→b의 절반만큼 움직이고, 일부 이득은 원래 개체의 값을 그대로 씁니다.',
    drive: ({ record: { parents, offspring } }) =>
      `시험 벡터가 주행합니다. ${parents.length}개 중 ${offspring.filter(({ cost }, i) => cost <= parents[i].cost).length}개의 J가 원래 개체보다 높지 않습니다.`,
    survivors: ({ record: { survivors, parents } }) => {
      const taken = survivors.filter((number) => number >= parents.length).length;
      return `원래 개체의 자리를 차지한 시험 벡터는 ${taken}개, 그대로 남은 개체는 ${parents.length - taken}개입니다.`;
    },
  },
  'cma-es': {
    parents: ({ record }) =>
      `${record.generation - 1}세대에서 남은 것은 정규분포뿐입니다. 타원은 1σ와 2σ입니다.`,
    mutation: ({ record }) => `이 분포에서 로봇 ${record.offspring.length}대를 뽑습니다.`,
    drive: () => '모두 주행하여 J를 얻습니다. 다음에는 그 순서만 쓰입니다.',
    ranking: ({ counting, ranked }) =>
      counting === 1
        ? `가장 좋은 로봇 1대만 반영합니다. 나머지 ${ranked - counting}대는 쓰지 않습니다.`
        : `좋은 쪽 로봇 ${counting}대만, 좋을수록 크게 반영합니다(막대: 가중치). 나머지 ${ranked - counting}대는 쓰지 않습니다.`,
    survivors({ record: { ellipse, next } }) {
      const ratio = ellipse && next.ellipse ? deviationRatio(ellipse, next.ellipse) : 1;
      return `평균이 가중 평균으로 옮겨 가고, 타원은 그 모양에 가까워지며 너비가 ${fixed(ratio, 2)}배가 됩니다.`;
    },
  },
  'one-plus-one-es': {
    parents: ({ record }) =>
      `부모 하나와, 모든 이득에 공통인 σ ${sigmaText(record.plan.steps?.[0] ?? 0)}입니다. 고리는 1σ와 2σ입니다.`,
    mutation: () => '자손: 이득마다 이 σ의 정규분포로 한 걸음 움직입니다.',
    drive: (anatomy, write) => `자손이 주행합니다. ${duel(anatomy, write)}`,
    survivors: (anatomy) =>
      isBetter(anatomy)
        ? '성공: 자손이 남고 σ × 1.5. 다섯 번에 한 번꼴로 성공하면 σ의 크기가 유지됩니다.'
        : '실패: 부모가 남고 σ × 0.904. 다섯 번에 한 번꼴로 성공하면 σ의 크기가 유지됩니다.',
  },
  'nelder-mead': {
    parents: ({ record: { plan, parents } }) =>
      plan.motion === 'begin'
        ? `${Number.isFinite(parents[0].cost) ? '심플렉스가 한 점으로 줄어들어' : '심플렉스의 모든 꼭짓점에서 J가 무한대여서'} 새로 시작합니다.`
        : parents.length > 4
          ? '꼭짓점 넷과 반사한 점입니다. 다음 시험점이 반사한 점을 쓸지를 정합니다.'
          : '꼭짓점 넷의 심플렉스입니다. 가장 나쁜 꼭짓점을 바꾸려 합니다.',
    mutation: ({ record }) => moves[record.plan.motion ?? 'begin'],
    drive: ({ record: { offspring, parents } }, write) =>
      offspring.length > 1
        ? `시험점 ${offspring.length}개가 주행합니다.`
        : `시험점이 주행합니다. J ${write(offspring[0].cost)}, 나머지 가운데 최소는 ${write(parents[0].cost)}입니다.`,
    survivors({ record: { plan, next, survivors, parents, offspring } }) {
      const stays = survivors.includes(parents.length);
      const what =
        offspring.length > 1
          ? '꼭짓점이 바뀌었습니다.'
          : survivors.length > 4
            ? '시험점이 심플렉스 옆에서 기다립니다.'
            : stays
              ? '시험점이 가장 나쁜 꼭짓점의 자리를 차지합니다.'
              : plan.motion === 'expansion'
                ? '더 멀리 가도 나아지지 않아 반사한 점이 남습니다.'
                : '시험점을 버립니다.';
      return `${what} 다음: ${motions[next.motion ?? 'begin']}.`;
    },
  },
  'one-at-a-time': {
    parents: () => '로봇 한 대와, 이득마다 다음에 옮길 걸음입니다.',
    mutation(anatomy) {
      const { name, step } = turnOf(anatomy);
      return `${name}의 차례입니다. ${sigmaText(Math.abs(step))}만큼 ${step < 0 ? '내립니다' : '올립니다'}. 다른 이득은 그대로입니다.`;
    },
    drive: (anatomy, write) => `주행합니다. ${duel(anatomy, write)}`,
    survivors(anatomy) {
      const { name } = turnOf(anatomy);
      return isBetter(anatomy)
        ? `J가 내려가므로 로봇은 그 자리에 남습니다. ${name}의 다음 걸음은 두 배가 됩니다.`
        : `J가 내려가지 않아 되돌아갑니다. ${name}의 다음 걸음은 반대쪽으로 절반입니다.`;
    },
  },
  'finite-differences': {
    parents: ({ record: { plan } }) =>
      plan.steps
        ? '로봇 한 대와, J가 내려가는 방향입니다.'
        : '로봇 한 대입니다. J가 어느 쪽으로 내려가는지는 아직 모릅니다.',
    mutation: (anatomy) => {
      const { steps } = anatomy.record.plan;
      return steps
        ? `기울기를 따라 ${lengthOf(steps)}만큼 내려갑니다.`
        : `이득 하나씩 로봇에서 10⁻⁴ 떨어진 시험점 셋입니다.${areProbesOnePoint(anatomy) ? ' 너무 가까워 여기서는 한 점으로 보입니다.' : ''}`;
    },
    drive: (anatomy, write) =>
      anatomy.record.plan.steps
        ? `주행합니다. ${duel(anatomy, write)}`
        : '시험점이 주행합니다. 로봇에서 각 시험점까지 J가 얼마나 변하는지가 곧 기울기입니다.',
    survivors(anatomy) {
      const { plan, next } = anatomy.record;
      if (!plan.steps)
        return next.steps
          ? `기울기를 알았습니다. 다음에는 기울기를 따라 ${lengthOf(next.steps)}만큼 내려갑니다.`
          : '기울기를 알 수 없습니다. 이곳의 J가 평평하거나 무한대입니다.';
      if (isBetter(anatomy))
        return 'J가 내려가므로 로봇은 그 자리에 남습니다. 기울기를 다시 재고 두 배로 나아갑니다.';
      return next.steps
        ? 'J가 내려가지 않으므로 되돌아가서 절반만 가 봅니다.'
        : '이만큼 가까이에서도 J가 내려가지 않습니다. 기울기를 다시 잽니다.';
    },
  },
};

/** What happens in a phase of a rival's generation. @param {Anatomy} anatomy @param {Phase} phase @param {(cost: number) => string} write */
export function sentenceOfMethod(anatomy, phase, write) {
  const { method, count, record } = anatomy;
  if (method === 'ep') return '';
  if (record.generation > 0) return sentences[method][phase]?.(anatomy, write) ?? '';
  if (phase === 'survivors')
    return count === 1
      ? '이 로봇에서 탐색을 시작합니다.'
      : `로봇 ${count}대가 모두 남아 J 순서로 늘어섭니다.`;
  return `로봇 ${count}대: ${beginnings[method]}. 아직 경쟁은 없었습니다.`;
}

/** @type {Readonly<Record<Exclude<Method, 'ep'>, string>>} */
const beginnings = {
  random: '파선 상자 안 어디서나 뽑음',
  de: '초기 범위에서 균등하게 뽑음',
  'cma-es': '초기 범위에서 뽑은 한 점의 둘레에서 뽑음',
  'one-plus-one-es': '초기 범위에서 뽑음',
  'nelder-mead': '초기 범위에서 뽑은 하나와, 그 점에서 이득마다 한 걸음 떨어진 점',
  'one-at-a-time': '초기 범위에서 뽑음',
  'finite-differences': '초기 범위에서 뽑음',
};
/** @param {Anatomy} anatomy */
export const initialText = ({ method }) =>
  method === 'ep' ? '초기 범위에서 균등하게 뽑음, σ는 설정값' : beginnings[method];

/** At the corners of a simplex. */
export const cornerNames = { best: '최선', worst: '최악', reflected: '반사' };

/** How a trial was made. @param {Anatomy} anatomy @param {number} own */
export function madeText({ method, record }, own) {
  const made = {
    ep: '',
    random: '상자 안 어디서나 뽑음',
    de: `a + ½ (b − c), 교차 상대: 개체 ${own + 1}`,
    'cma-es': '타원에서 뽑음',
    'one-plus-one-es': '부모에서 정규분포로 한 걸음',
    'nelder-mead': motions[record.plan.motion ?? 'begin'],
    'one-at-a-time': '이득 하나를 옮김',
    'finite-differences': record.plan.steps ? '기울기를 따라 한 걸음' : '기울기를 재는 시험점',
  };
  return made[method];
}

/** @param {string} gain */
export const keptText = (gain) => `원래 개체의 값을 유지: ${gain}`;
/** @param {string} gain */
export const takenText = (gain) => `채택: ${gain}`;
/** @param {string} gain */
export const staysText = (gain) => `${gain} 그대로`;
/** @param {string} times @param {string} sigma */
export const apartText = (times, sigma) => `σ의 ${times}배, σ는 ${sigma}`;
/** Where it cannot be told what was drawn. */
export const heldText = '0보다 작게 뽑혀 0으로 바꿈';
/** Of a trial of differential evolution whose member is at 0. @param {string} gain */
export const heldOrKeptText = (gain) => `0으로 바꾼 값, 또는 원래 개체의 값: ${gain}`;
export const mirroredText = '뽑은 값 그대로, 또는 0을 기준으로 뒤집은 값';
/** @param {string} step */
export const nextStep = (step) => `다음 걸음: ${step}`;
/** @param {number} weight */
export const weightText = (weight) => fixed(weight, 3);
/** @param {number} weight */
export const weighedText = (weight) =>
  weight > 0 ? `가중치의 합을 1로 할 때 ${weightText(weight)}만큼 반영됩니다.` : '반영되지 않습니다.';
/** @param {import('../detail-methods.js').Successes} successes */
export const successText = ({ steps, won }) =>
  steps === 1
    ? `첫 걸음은 ${won === 1 ? '성공' : '실패'}했습니다.`
    : `최근 ${steps}걸음 중 ${won}걸음 성공: 다섯 번에 한 번${5 * won > steps ? '보다 많습니다' : 5 * won === steps ? '입니다' : '보다 적습니다'}.`;
/** @param {Anatomy} anatomy @param {number} count */
export const stay = ({ method }, count) => (method === 'cma-es' ? `${count}대 반영` : `${count}대 생존`);
/** @param {Anatomy} anatomy @param {number} count */
export const fall = ({ method }, count) => (method === 'cma-es' ? `${count}대 제외` : `${count}대 탈락`);
