// What each method sees and does in a phase, in gains: ellipses, steps from one point to another, and the names of points.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Ellipsoid, Place, Shadow } from '../../kit/ellipse.js' */
/** @import { Anatomy, Method, Phase } from './record.js' */
import { deviationOf, ringOf } from '../../kit/ellipse.js';
import words from './words/index.js';
import { isInitial, trialOf } from './record.js';

/** A closed line. @typedef {{ outline: (shadow: Shadow) => Place[], faint?: boolean }} Ring */
/** An edge, a step to a robot, a shift of something else, or what is only thought of. @typedef {{ from: Triple, to: Triple, kind: 'edge' | 'step' | 'shift' | 'faint' }} Line */
/** @typedef {{ at: Triple, text: string }} Named */
/** @typedef {{ rings: Ring[], lines: Line[], names: Named[] }} Sketch */
/** @typedef {(anatomy: Anatomy, phase: Phase, chosen: number) => Partial<Sketch>} Draw */

const deviations = /** @type {const} */ ([1, 2]);

/** @param {Ellipsoid | null} ellipse @param {boolean} [faint] @returns {Ring[]} */
const ringsOf = (ellipse, faint = false) =>
  ellipse ? deviations.map((count) => ({ outline: (shadow) => ringOf(ellipse, shadow, count), faint })) : [];

/** @param {Triple} a @param {Triple} b @returns {Triple} */
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];

/** Only along one axis. @param {number} i @param {number} step @returns {Triple} */
const along = (i, step) => [i === 0 ? step : 0, i === 1 ? step : 0, i === 2 ? step : 0];

/** Equal in all gains. @param {Triple} mean @param {Triple | null} steps @returns {Ellipsoid | null} */
const ball = (mean, steps) => steps && { mean, axes: steps.map((step, i) => along(i, step)) };

/** A step along each axis. @param {Triple} from @param {Triple | null} steps @returns {Line[]} */
const arms = (from, steps) =>
  (steps ?? []).map((step, i) => ({
    from,
    to: plus(from, along(i, step)),
    kind: 'faint',
  }));

/** Each with each. @param {readonly Triple[]} corners @param {Line['kind']} kind @returns {Line[]} */
const edges = (corners, kind) =>
  corners.flatMap((from, i) => corners.slice(i + 1).map((to) => ({ from, to, kind })));

/** From where it stands to what is tried. @param {Anatomy} anatomy @param {number} chosen @returns {Line} */
const tried = ({ record: { parents, offspring } }, chosen) => ({
  from: parents[0].gains,
  to: offspring[chosen].gains,
  kind: 'step',
});

/** The corners of the simplex before the generation, best first; none where it begins. @param {Anatomy} anatomy @returns {Triple[]} */
export const simplexOf = ({ record: { plan, parents } }) => plan.corners.map((place) => parents[place].gains);

/** @param {Anatomy} anatomy @returns {Triple[]} */
const simplexAfter = ({ record: { next, survivors }, all }) =>
  next.corners.map((place) => all[survivors[place]].gains);

/** What they are called, and the one that waits beside them. @param {Anatomy} anatomy @returns {Named[]} */
function namesOf({ record: { plan, parents } }) {
  const { best, worst, reflected } = words.cornerNames;
  const [first, , , last] = plan.corners;
  if (last === undefined) return [];
  const waiting = parents.findIndex((_, place) => !plan.corners.includes(place));
  return [
    { at: parents[first].gains, text: best },
    { at: parents[last].gains, text: worst },
    ...(waiting < 0 ? [] : [{ at: parents[waiting].gains, text: reflected }]),
  ];
}

/** The middle of all corners but the worst. @param {readonly Triple[]} corners @returns {Triple} */
export function centreOf([a, b, c]) {
  const mean = (/** @type {number} */ j) => (a[j] + b[j] + c[j]) / 3;
  return [mean(0), mean(1), mean(2)];
}

/** @type {Readonly<Record<Method, Draw>>} */
const drawings = {
  ep: () => ({}),

  random({ initialRange }) {
    const [low, high] = initialRange.map((end) => /** @type {Triple} */ ([end, end, end]));
    /** @param {Shadow} shadow @returns {Place[]} */
    const outline = (shadow) => {
      const [[left, bottom], [right, top]] = [shadow(low), shadow(high)];
      return [
        [left, bottom],
        [right, bottom],
        [right, top],
        [left, top],
      ];
    };
    return { rings: [{ outline, faint: true }] };
  },

  de(anatomy, phase, chosen) {
    const { parents, offspring, donors, bases } = anatomy.record;
    if (phase !== 'mutation') return {};
    const own = trialOf(anatomy, chosen);
    const [a, b, c] = donors[own].map((donor) => parents[donor].gains);
    const [mutant, trial] = [bases[own].gains, offspring[own].gains];
    return {
      lines: [
        { from: c, to: b, kind: 'faint' },
        { from: a, to: mutant, kind: 'step' },
        ...(mutant.join() === trial.join()
          ? []
          : [{ from: mutant, to: trial, kind: /** @type {const} */ ('faint') }]),
      ],
      names: [a, b, c].map((at, i) => ({ at, text: words.donorNames[i] })),
    };
  },

  'cma-es'({ record: { ellipse, next, offspring, parents } }, phase, chosen) {
    if (phase === 'survivors') {
      const moved = ellipse &&
        next.ellipse && {
          from: ellipse.mean,
          to: next.ellipse.mean,
          kind: /** @type {const} */ ('shift'),
        };
      return { rings: [...ringsOf(ellipse, true), ...ringsOf(next.ellipse)], lines: moved ? [moved] : [] };
    }
    const trial = phase === 'mutation' ? offspring[chosen - parents.length] : null;
    return {
      rings: ringsOf(ellipse),
      lines: ellipse && trial ? [{ from: ellipse.mean, to: trial.gains, kind: 'step' }] : [],
    };
  },

  'one-plus-one-es'(anatomy, phase) {
    const { all, record } = anatomy;
    const { parents, plan, next, survivors } = record;
    const before = ringsOf(ball(parents[0].gains, plan.steps), phase === 'survivors');
    const after = phase === 'survivors' ? ringsOf(ball(all[survivors[0]].gains, next.steps)) : [];
    return {
      rings: [...before, ...after],
      lines: phase === 'mutation' ? [tried(anatomy, 0)] : [],
    };
  },

  'nelder-mead'(anatomy, phase, chosen) {
    const { record } = anatomy;
    if (phase === 'survivors')
      return { lines: [...edges(simplexOf(anatomy), 'faint'), ...edges(simplexAfter(anatomy), 'edge')] };
    const corners = simplexOf(anatomy);
    const lines = edges(corners, 'edge');
    const names = namesOf(anatomy);
    if (phase === 'parents' || isInitial(record)) return { lines, names };
    const trials = record.offspring.map(({ gains }) => gains);
    const [own, motion] = [trialOf(anatomy, chosen), record.plan.motion];
    if (motion === 'begin') return { lines: edges(trials, 'faint') };
    if (motion === 'shrink')
      return { lines: [...lines, { from: corners[own + 1], to: trials[own], kind: 'step' }], names };
    const centre = centreOf(corners);
    return {
      lines: [
        ...lines,
        { from: corners[3], to: centre, kind: 'faint' },
        { from: centre, to: trials[0], kind: 'step' },
      ],
      names,
    };
  },

  'one-at-a-time'(anatomy, phase) {
    const { all, record } = anatomy;
    const { parents, plan, next, survivors } = record;
    if (phase === 'survivors') return { lines: arms(all[survivors[0]].gains, next.steps) };
    const lines = arms(parents[0].gains, plan.steps);
    return { lines: phase === 'mutation' ? [...lines, tried(anatomy, 0)] : lines };
  },

  'finite-differences'(anatomy, phase, chosen) {
    const { all, record } = anatomy;
    const { parents, plan, next, survivors } = record;
    if (phase === 'mutation') return { lines: [tried(anatomy, trialOf(anatomy, chosen))] };
    const [from, steps] =
      phase === 'survivors'
        ? [all[survivors[0]].gains, next.steps]
        : [parents[0].gains, isInitial(record) ? null : plan.steps];
    return { lines: steps ? [{ from, to: plus(from, steps), kind: 'faint' }] : [] };
  },
};

/** @param {Anatomy} anatomy @param {Phase} phase @param {number} chosen @returns {Sketch} */
export const sketchOf = (anatomy, phase, chosen) => ({
  rings: [],
  lines: [],
  names: [],
  ...drawings[anatomy.method](anatomy, phase, chosen),
});

/** So many deviations in every gain. @param {Ellipsoid} ellipse @param {number} factor @returns {Triple} */
const apart = (ellipse, factor) => [
  factor * deviationOf(ellipse, 0),
  factor * deviationOf(ellipse, 1),
  factor * deviationOf(ellipse, 2),
];

/** All points that some phase of the generation shows, so that the picture need not move between them. @param {Anatomy} anatomy @returns {Triple[]} */
export function pointsOf(anatomy) {
  const { all, record, initialRange, method } = anatomy;
  const { plan, next, parents, survivors } = record;
  const around = (/** @type {Ellipsoid | null} */ ellipse) =>
    ellipse ? [-2, 2].map((factor) => plus(ellipse.mean, apart(ellipse, factor))) : [];
  const [before, after] = [parents[0].gains, all[survivors[0]].gains];
  const reached = {
    random: () => initialRange.map((end) => /** @type {Triple} */ ([end, end, end])),
    de: () => record.bases.map(({ gains }) => gains),
    'cma-es': () => [...around(record.ellipse), ...around(next.ellipse)],
    'one-plus-one-es': () => [...around(ball(before, plan.steps)), ...around(ball(after, next.steps))],
    'one-at-a-time': () => [...arms(before, plan.steps), ...arms(after, next.steps)].map(({ to }) => to),
    'finite-differences': () => (next.steps ? [plus(after, next.steps)] : []),
    'nelder-mead': () => [],
    ep: () => [],
  };
  return [...all.map(({ gains }) => gains), ...reached[method]()];
}
