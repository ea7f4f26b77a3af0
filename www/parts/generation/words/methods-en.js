// What Generation says of the methods, each in its own terms.
/** @import { Anatomy, Method, Phase } from '../record.js' */
import { areProbesOnePoint, deviationRatio, sigmaText, turnIn } from './common.js';
import { gains } from '../../../words/en/lab.js';
import { counted } from '../../../words/en/counted.js';
import { fixed } from '../../../words/en/numbers.js';

/** What was there before, and what is tried. @type {Readonly<Record<Method, readonly [before: string, tried: string]>>} */
const nouns = {
  ep: ['parent', 'offspring'],
  random: ['earlier draw', 'draw'],
  de: ['member', 'trial'],
  'cma-es': ['earlier draw', 'draw'],
  'one-plus-one-es': ['parent', 'offspring'],
  'nelder-mead': ['corner', 'trial'],
  'one-at-a-time': ['robot', 'trial'],
  'finite-differences': ['robot', 'trial'],
};

/** @param {Anatomy} anatomy @param {'parent' | 'offspring'} kind */
export const keyOf = ({ method }, kind) => nouns[method][kind === 'parent' ? 0 : 1];

/** An individual's name: those of generation 0 have no parents and no offspring. @param {Anatomy} anatomy @param {number} number */
export function nameOf({ count, record, method }, number) {
  if (record.offspring.length === 0) return `robot ${number + 1}`;
  const [before, tried] = nouns[method];
  return number < count ? `${before} ${number + 1}` : `${tried} ${number - count + 1}`;
}

/** @type {Readonly<Record<Method, Readonly<Partial<Record<Phase, string>>>>>} */
const phaseNames = {
  ep: { parents: 'Parents', mutation: 'Mutation', survivors: 'Survivors' },
  random: { parents: 'Before', mutation: 'Draw', survivors: 'What stays' },
  de: { parents: 'Members', mutation: 'Difference', survivors: 'Who stays' },
  'cma-es': { parents: 'Ellipse', mutation: 'Sample', ranking: 'Weights', survivors: 'New ellipse' },
  'one-plus-one-es': { parents: 'Parent', mutation: 'Step', survivors: '1/5 rule' },
  'nelder-mead': { parents: 'Simplex', mutation: 'Move', survivors: 'New simplex' },
  'one-at-a-time': { parents: 'Robot', mutation: 'One gain', survivors: 'Next step' },
  'finite-differences': { parents: 'Robot', mutation: 'Trial', survivors: 'Slope' },
};
/** @type {Readonly<Partial<Record<Phase, string>>>} */
const usual = { drive: 'Drive', tournament: 'Tournament', ranking: 'Ranking' };

/** @param {Pick<Anatomy, 'method'>} anatomy @param {Phase} phase */
export const phaseName = ({ method }, phase) => phaseNames[method][phase] ?? usual[phase] ?? phase;

const motions = {
  begin: 'a new simplex',
  reflection: 'reflection',
  expansion: 'expansion',
  'outside-contraction': 'contraction outside',
  'inside-contraction': 'contraction inside',
  shrink: 'shrinking',
};
const moves = {
  begin: 'A new simplex: a draw, and a step from it in each gain.',
  reflection: 'Reflection: the worst corner is mirrored at the centre of the other three.',
  expansion: 'Expansion: the reflected corner is the best of all, so twice as far is tried.',
  'outside-contraction':
    'Contraction outside: the reflected one would be the worst, so half as far is tried.',
  'inside-contraction':
    'Contraction inside: the reflected one is worse than all; halfway to the worst is tried.',
  shrink: 'Shrinking: contraction was no better; three corners move halfway to the best.',
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
  `J ${write(offspring[0].cost)}, against ${write(parents[0].cost)} before.`;

/** @typedef {(anatomy: Anatomy, write: (cost: number) => string) => string} Say */

/** @type {Readonly<Record<Exclude<Method, 'ep'>, Readonly<Partial<Record<Phase, Say>>>>>} */
const sentences = {
  random: {
    parents: ({ count, record }) =>
      count === 1
        ? `The draw of generation ${record.generation - 1}. Nothing is taken over from it.`
        : `The ${count} draws of generation ${record.generation - 1}. Nothing is taken over from them.`,
    mutation: ({ record }) =>
      `${counted(record.offspring.length, 'new draw', 'new draws')}, anywhere in the dashed box: nothing was learned from those before.`,
    drive: ({ count }) => (count === 1 ? 'It drives and gets its J.' : 'They drive and get their J.'),
    survivors: ({ count }) =>
      count === 1
        ? 'The next draw comes from the same box. Only the best of all is remembered.'
        : 'The next draws come from the same box. Only the best of all is remembered.',
  },
  de: {
    parents: ({ count }) => `${count} members, best ranked first. Each is to have one trial.`,
    mutation: () => 'A trial moves from a by half of the way from c to b; some gains stay the member’s own.',
    drive: ({ record: { parents, offspring } }) =>
      `The trials drive: ${offspring.filter(({ cost }, i) => cost <= parents[i].cost).length} of ${parents.length} cost no more than their member.`,
    survivors: ({ record: { survivors, parents } }) => {
      const taken = survivors.filter((number) => number >= parents.length).length;
      return `${counted(taken, 'trial takes its member’s place', 'trials take their members’ places')}; ${counted(parents.length - taken, 'member stays', 'members stay')}.`;
    },
  },
  'cma-es': {
    parents: ({ record }) =>
      `What is left of generation ${record.generation - 1}: a normal distribution, drawn at one and two σ.`,
    mutation: ({ record }) => `${record.offspring.length} robots are drawn from it.`,
    drive: () => 'They drive and get their J. Only their order will count.',
    ranking: ({ counting, ranked }) =>
      counting === 1
        ? `The best one counts alone; the other ${counted(ranked - counting, 'is', 'are')} left aside.`
        : `The better ${counting} count, the best one most (bars: weights); the other ${counted(ranked - counting, 'is', 'are')} left aside.`,
    survivors({ record: { ellipse, next } }) {
      const ratio = ellipse && next.ellipse ? deviationRatio(ellipse, next.ellipse) : 1;
      return `The mean moves to the weighted robots; the ellipse nears their shape, ${fixed(ratio, 2)} times as wide.`;
    },
  },
  'one-plus-one-es': {
    parents: ({ record }) =>
      `One parent, and one σ for all gains, ${sigmaText(record.plan.steps?.[0] ?? 0)}: the rings are at one and two σ.`,
    mutation: () => 'Its offspring: a normal step of this σ in each gain.',
    drive: (anatomy, write) => `The offspring drives: ${duel(anatomy, write)}`,
    survivors: (anatomy) =>
      isBetter(anatomy)
        ? 'Success: the offspring stays, σ × 1.5. With one success in five σ would keep its size.'
        : 'Failure: the parent stays, σ × 0.904. With one success in five σ would keep its size.',
  },
  'nelder-mead': {
    parents: ({ record: { plan, parents } }) =>
      plan.motion === 'begin'
        ? `${Number.isFinite(parents[0].cost) ? 'The simplex has shrunk to a point' : 'J is infinite at all corners of the simplex'}: it begins anew.`
        : parents.length > 4
          ? 'Four corners, and beside them the reflected one: another trial decides over it.'
          : 'A simplex of four corners. The worst one is to be replaced.',
    mutation: ({ record }) => moves[record.plan.motion ?? 'begin'],
    drive: ({ record: { offspring, parents } }, write) =>
      offspring.length > 1
        ? `${offspring.length} trials drive.`
        : `The trial drives: J ${write(offspring[0].cost)}. The best of the others has ${write(parents[0].cost)}.`,
    survivors({ record: { plan, next, survivors, parents, offspring } }) {
      const stays = survivors.includes(parents.length);
      const what =
        offspring.length > 1
          ? 'The corners are new.'
          : survivors.length > 4
            ? 'The trial waits beside the simplex.'
            : stays
              ? 'The trial takes the place of the worst corner.'
              : plan.motion === 'expansion'
                ? 'Farther is no better: the reflected corner stays.'
                : 'The trial is dropped.';
      return `${what} Next: ${motions[next.motion ?? 'begin']}.`;
    },
  },
  'one-at-a-time': {
    parents: () => 'One robot, and the next step of each of its gains.',
    mutation(anatomy) {
      const { name, step } = turnOf(anatomy);
      return `It is the turn of ${name}: a step ${step < 0 ? 'down' : 'up'}, ${sigmaText(Math.abs(step))} far. The others stay.`;
    },
    drive: (anatomy, write) => `It drives: ${duel(anatomy, write)}`,
    survivors(anatomy) {
      const { name } = turnOf(anatomy);
      return isBetter(anatomy)
        ? `J falls: the robot stays there. The next step of ${name} goes twice as far.`
        : `J does not fall: back. The next step of ${name} is half as long, and the other way.`;
    },
  },
  'finite-differences': {
    parents: ({ record: { plan } }) =>
      plan.steps ? 'One robot, and the way in which J falls.' : 'One robot. Where J falls is not known yet.',
    mutation: (anatomy) => {
      const { steps } = anatomy.record.plan;
      return steps
        ? `A step down the slope, ${lengthOf(steps)} far.`
        : `Three probes, each 10⁻⁴ beside the robot in one gain${areProbesOnePoint(anatomy) ? ': so near that here all are one point' : ''}.`;
    },
    drive: (anatomy, write) =>
      anatomy.record.plan.steps
        ? `It drives: ${duel(anatomy, write)}`
        : 'The probes drive. How much J changes from the robot to each of them gives the slope.',
    survivors(anatomy) {
      const { plan, next } = anatomy.record;
      if (!plan.steps)
        return next.steps
          ? `The slope is known. The next step goes down it, ${lengthOf(next.steps)} far.`
          : 'No slope can be told: J is level here, or infinite.';
      if (isBetter(anatomy))
        return 'J falls: the robot stays there. The slope is probed anew; then a step twice as long.';
      return next.steps
        ? 'J does not fall: back, and half as far is tried.'
        : 'J does not fall even so near: the slope is probed anew.';
    },
  },
};

/** What happens in a phase of a rival's generation. @param {Anatomy} anatomy @param {Phase} phase @param {(cost: number) => string} write */
export function sentenceOfMethod(anatomy, phase, write) {
  const { method, count, record } = anatomy;
  if (method === 'ep') return '';
  if (record.generation > 0) return sentences[method][phase]?.(anatomy, write) ?? '';
  const robots = count === 1 ? 'One robot' : `${count} robots`;
  if (phase === 'survivors')
    return count === 1
      ? 'It stays: from here the search sets out.'
      : `All ${count} stay, now in the order of their J.`;
  return `${robots}: ${beginnings[method]}. No one has competed yet.`;
}

/** @type {Readonly<Record<Exclude<Method, 'ep'>, string>>} */
const beginnings = {
  random: 'drawn anywhere in the dashed box',
  de: 'drawn evenly from the initial range',
  'cma-es': 'drawn around one point that was drawn from the initial range',
  'one-plus-one-es': 'drawn from the initial range',
  'nelder-mead': 'one that was drawn from the initial range, and a step from it in each gain',
  'one-at-a-time': 'drawn from the initial range',
  'finite-differences': 'drawn from the initial range',
};
/** @param {Anatomy} anatomy */
export const initialText = ({ method }) =>
  method === 'ep' ? 'drawn evenly from the initial range, σ as set' : beginnings[method];

/** At the corners of a simplex. */
export const cornerNames = { best: 'best', worst: 'worst', reflected: 'reflected' };

/** How a trial was made. @param {Anatomy} anatomy @param {number} own */
export function madeText({ method, record }, own) {
  const made = {
    ep: '',
    random: 'drawn anywhere in the box',
    de: `a + ½ (b − c), crossed with member ${own + 1}`,
    'cma-es': 'drawn from the ellipse',
    'one-plus-one-es': 'a normal step from the parent',
    'nelder-mead': motions[record.plan.motion ?? 'begin'],
    'one-at-a-time': 'one gain moved',
    'finite-differences': record.plan.steps ? 'a step down the slope' : 'a probe of the slope',
  };
  return made[method];
}

/** @param {string} gain */
export const keptText = (gain) => `stays the member’s own: ${gain}`;
/** @param {string} gain */
export const takenText = (gain) => `is taken: ${gain}`;
/** @param {string} gain */
export const staysText = (gain) => `stays ${gain}`;
/** @param {string} times @param {string} sigma */
export const apartText = (times, sigma) => `${times} times σ, which is ${sigma}`;
/** Where it cannot be told what was drawn. */
export const heldText = 'drawn below 0, held at 0';
/** Of a trial of differential evolution whose member is at 0. @param {string} gain */
export const heldOrKeptText = (gain) => `held at 0, or the member’s own: ${gain}`;
export const mirroredText = 'as drawn, or mirrored at 0';
/** @param {string} step */
export const nextStep = (step) => `next step: ${step}`;
/** @param {number} weight */
export const weightText = (weight) => fixed(weight, 3);
/** @param {number} weight */
export const weighedText = (weight) =>
  weight > 0 ? `It counts with a weight of ${weightText(weight)} of 1.` : 'It does not count.';
/** @param {import('../detail-methods.js').Successes} successes */
export const successText = ({ steps, won }) =>
  steps === 1
    ? `The only step so far has ${won === 1 ? 'succeeded' : 'failed'}.`
    : `Of the last ${steps} steps ${won} succeeded: ${5 * won > steps ? 'more than' : 5 * won === steps ? 'exactly' : 'fewer than'} one in five.`;
/** @param {Anatomy} anatomy @param {number} count */
export const stay = ({ method }, count) =>
  method === 'cma-es' ? counted(count, 'counts', 'count') : counted(count, 'stays', 'stay');
/** @param {Anatomy} anatomy @param {number} count */
export const fall = ({ method }, count) =>
  method === 'cma-es' ? counted(count, 'does not', 'do not') : counted(count, 'falls', 'fall');
