// What other methods than the paper's go by, how they make what they try, and what they learn from it, in the numbers of the record.
/** @import { TemplateResult } from 'lit-html' */
/** @import { Statistics, Triple } from '../../core/engine.js' */
/** @import { Anatomy, Method } from './record.js' */
import { html, nothing } from 'lit-html';
import { deviationOf } from '../../kit/ellipse.js';
import words from './words/index.js';
import { bar, bell, shareOf } from './bell.js';
import { becoming, gainRows, headline, link, rulesOf, symbol } from './detail.js';
import { trialOf } from './record.js';
import { centreOf, simplexOf } from './sketch.js';

/** Of the last steps. @typedef {{ steps: number, won: number }} Successes */
/** What is told of a gain: two lines, with a picture beside them or none. @typedef {{ beside?: TemplateResult, lines: readonly unknown[] }} Row */
/** @typedef {(i: number) => Row} RowOf */

/** How far back successes are counted. */
const remembered = 20;

/** @param {RowOf} rowOf */
function rows(rowOf) {
  const all = [0, 1, 2].map(rowOf);
  const isPlain = all.every(({ beside }) => beside === undefined);
  return gainRows(isPlain ? 'gain-rows plain' : 'gain-rows', (i) => {
    const { beside, lines } = all[i];
    return html`${beside ?? nothing}${lines.map((line) => html`<p class="equation">${line}</p>`)}`;
  });
}

/** @param {string} letter @param {number} i @param {string} text */
const equals = (letter, i, text) => html`${symbol(letter, i)} = ${text}`;

/** @param {readonly number[]} steps @param {number} i */
const partOf = (steps, i) => steps[i] / Math.max(...steps.map(Math.abs));

/** What is added, with its sign. @param {number} value */
const added = (value) => (value < 0 ? ` − ${words.sigmaText(-value)}` : ` + ${words.sigmaText(value)}`);

/** k + d = k′, with as many digits as d needs, and what came of k′ before it was tried. @param {number} i @param {number} from @param {number} to @param {number} tried */
function moved(i, from, to, tried) {
  const write = (/** @type {number} */ value) => words.gainText(value, to - from);
  return html`${becoming('k', i)} ${write(from)}${added(to - from)} = ${words.becomes(write(to), write(tried))}`;
}

/** Nobody draws so many σ. */
const unheard = 8;

/** A gain that was drawn around another; where that cannot be told, for it was held at 0 or may have been mirrored there, what is. @param {Anatomy} anatomy @param {number} i @param {number} from @param {number} to @param {readonly number[]} sigmas @returns {Row} */
function drawnAround({ belowZero }, i, from, to, sigmas) {
  const sigma = sigmas[i];
  const share = shareOf(sigmas, i);
  const isHeld = belowZero === 'clamp' && to === 0;
  if (isHeld || (belowZero === 'mirror' && from + to < unheard * sigma))
    return {
      beside: bell(null, 'gaussian', share),
      lines: [equals('k', i, words.gainText(to)), isHeld ? words.heldText : words.mirroredText],
    };
  const times = sigma > 0 ? (to - from) / sigma : 0;
  return {
    beside: bell(times, 'gaussian', share),
    lines: [moved(i, from, to, to), words.apartText(words.drawText(times), words.sigmaText(sigma))],
  };
}

/** @param {Parameters<typeof deviationOf>[0]} ellipse */
const deviationsOf = (ellipse) => [0, 1, 2].map((i) => deviationOf(ellipse, i));

/** @param {Anatomy} anatomy @returns {RowOf} */
function distribution({ record: { ellipse } }) {
  if (!ellipse) return () => ({ beside: bell(null), lines: [] });
  const sigmas = deviationsOf(ellipse);
  return (i) => ({
    beside: bell(null, 'gaussian', shareOf(sigmas, i)),
    lines: [equals('m', i, words.gainText(ellipse.mean[i])), equals('σ', i, words.sigmaText(sigmas[i]))],
  });
}

/** The steps that come next, beside a gain. @param {Triple | null} steps @param {(i: number) => unknown} first @returns {RowOf} */
const withSteps = (steps, first) => (i) => ({
  ...(steps && { beside: bar(partOf(steps, i)) }),
  lines: [first(i), ...(steps ? [words.nextStep(words.signedText(steps[i]))] : [])],
});

/** What it goes by before anything is tried. @param {Anatomy} anatomy @param {number} chosen */
export function standsBy(anatomy, chosen) {
  const { method, record, all } = anatomy;
  const gain = (/** @type {number} */ i) => equals('k', i, words.gainText(all[chosen].gains[i]));
  // Generation 0 has come to be before there was anything to go by.
  const { steps } = record.offspring.length > 0 ? record.plan : record.next;
  if (method === 'cma-es') return rows(distribution(anatomy));
  if (method === 'one-at-a-time' || method === 'finite-differences') return rows(withSteps(steps, gain));
  if (method === 'one-plus-one-es' && steps)
    return rows((i) => ({ beside: bell(null), lines: [gain(i), equals('σ', i, words.sigmaText(steps[i]))] }));
  return rows((i) => ({ lines: [gain(i)] }));
}

/** @typedef {(anatomy: Anatomy, own: number) => RowOf} Making */

/** @type {Making} */
const difference = ({ record, belowZero }, own) => {
  const { parents, offspring, donors, bases } = record;
  const [a, b, c] = donors[own].map((donor) => parents[donor].gains);
  const [mutant, trial, parent] = [bases[own], offspring[own], parents[own]].map(({ gains }) => gains);
  return (i) => {
    const write = (/** @type {number} */ value) => words.gainText(value, b[i] - c[i]);
    const half = `½ (${write(b[i])} − ${words.bracketed(write(c[i]))})`;
    const isOwn = trial[i] === parent[i] && mutant[i] !== trial[i];
    // Which of the two it was cannot be told.
    const mayBeHeld = belowZero === 'clamp' && mutant[i] < 0;
    return {
      lines: [
        html`${becoming('k', i)} ${write(a[i])} + ${half} = ${write(mutant[i])}`,
        isOwn
          ? (trial[i] === 0 && mayBeHeld ? words.heldOrKeptText : words.keptText)(write(trial[i]))
          : words.takenText(words.becomes(words.gainText(mutant[i]), words.gainText(trial[i]))),
      ],
    };
  };
};

/** @type {Making} */
const sample = (anatomy, own) => {
  const { ellipse, offspring } = anatomy.record;
  const { gains } = offspring[own];
  const sigmas = ellipse ? deviationsOf(ellipse) : [];
  return (i) => (ellipse ? drawnAround(anatomy, i, ellipse.mean[i], gains[i], sigmas) : { lines: [] });
};

/** @type {Making} */
const normalStep = (anatomy, own) => {
  const { parents, offspring, plan } = anatomy.record;
  const [from, to] = [parents[0].gains, offspring[own].gains];
  return (i) => drawnAround(anatomy, i, from[i], to[i], plan.steps ?? [0, 0, 0]);
};

/** How far a move goes from the centre, in the way from the worst corner to there. */
const factors = /** @type {const} */ ({
  reflection: ['+ ', 1],
  expansion: ['+ 2 ', 2],
  'outside-contraction': ['+ ½ ', 0.5],
  'inside-contraction': ['− ½ ', -0.5],
});

/** @type {Making} */
const move = (anatomy, own) => {
  const { record } = anatomy;
  const { motion } = record.plan;
  const trial = record.offspring[own].gains;
  const corners = simplexOf(anatomy);
  if (motion === 'begin' || motion === null)
    return (i) => ({ lines: [equals('k', i, words.gainText(trial[i]))] });
  if (motion === 'shrink') {
    const [best, corner] = [corners[0], corners[own + 1]];
    return (i) => {
      const write = (/** @type {number} */ value) => words.gainText(value, corner[i] - best[i]);
      const half = `½ (${write(corner[i])} − ${words.bracketed(write(best[i]))})`;
      const sum = best[i] + 0.5 * (corner[i] - best[i]);
      return { lines: [html`${becoming('k', i)} ${write(best[i])} + ${half} = ${write(sum)}`] };
    };
  }
  const [centre, worst] = [centreOf(corners), corners[3]];
  const [sign, factor] = factors[motion];
  return (i) => {
    const apart = centre[i] - worst[i];
    const write = (/** @type {number} */ value) => words.gainText(value, apart);
    const sum = centre[i] + factor * apart;
    const tried = Math.abs(sum - trial[i]) < 1e-9 ? sum : trial[i];
    const way = `(${write(centre[i])} − ${words.bracketed(write(worst[i]))})`;
    return {
      lines: [
        html`${becoming('k', i)} ${write(centre[i])} ${sign}${way} = ${words.becomes(write(sum), write(tried))}`,
      ],
    };
  };
};

/** @type {Making} */
const step = ({ method, record: { generation, parents, offspring, plan } }, own) => {
  const [from, to] = [parents[0].gains, offspring[own].gains];
  const isItsTurn = (/** @type {number} */ i) =>
    method === 'finite-differences' || i === words.turnIn(generation);
  const steps = to.map((gain, i) => (plan.steps ? (isItsTurn(i) ? plan.steps[i] : 0) : gain - from[i]));
  const isMoved = steps.some((one) => one !== 0);
  return (i) => ({
    beside: bar(isMoved ? partOf(steps, i) : 0),
    lines: [
      steps[i] === 0
        ? html`${symbol('k', i)} ${words.staysText(words.gainText(from[i]))}`
        : moved(i, from[i], from[i] + steps[i], to[i]),
    ],
  });
};

/** @type {Making} */
const draw =
  ({ record: { offspring } }, own) =>
  (i) => ({
    lines: [equals('k', i, words.gainText(offspring[own].gains[i]))],
  });

/** @type {Readonly<Record<Exclude<Method, 'ep'>, Making>>} */
const makings = {
  random: draw,
  de: difference,
  'cma-es': sample,
  'one-plus-one-es': normalStep,
  'nelder-mead': move,
  'one-at-a-time': step,
  'finite-differences': step,
};

/** How what is tried is made. @param {Anatomy} anatomy @param {number} chosen @param {(number: number) => void} choose */
export function madeBy(anatomy, chosen, choose) {
  const { method, record, count } = anatomy;
  if (method === 'ep') return html``;
  const own = trialOf(anatomy, chosen);
  const donors = record.donors[own]?.map(
    (donor, i) => html` <span><i>${words.donorNames[i]}</i> ${link(anatomy, donor, choose)}</span>`,
  );
  return html`
    ${headline(anatomy, own + count, words.madeText(anatomy, own))}
    ${donors ? html`<p class="donors">${donors}</p>` : nothing}
    ${rows(makings[method](anatomy, own))}
    ${rulesOf(anatomy)}`;
}

/** Of CMA-ES: what a rank counts. @param {Anatomy} anatomy @param {number} chosen */
export const weighedBy = ({ record, ranks }, chosen) =>
  html`<p>${words.weighedText(record.plan.weights[ranks[chosen]] ?? 0)}</p>`;

/** @param {Anatomy} anatomy @param {readonly Statistics[]} history @returns {Successes | null} */
export function successesIn({ method, record }, history) {
  if (method !== 'one-plus-one-es' || record.generation === 0) return null;
  const from = Math.max(1, record.generation - remembered + 1);
  // σ shrinks with a failure, and with nothing else; at its largest, and from 0, it does not grow.
  const won = history
    .slice(from, record.generation + 1)
    .filter(({ meanSigmas }, i) => meanSigmas[0] >= history[from + i - 1].meanSigmas[0]);
  return { steps: record.generation - from + 1, won: won.length };
}

/** What it learns. @param {Anatomy} anatomy @param {Successes | null} successes */
export function learntBy({ method, record, all }, successes) {
  const { plan, next, ellipse, survivors } = record;
  if (method === 'cma-es' && ellipse && next.ellipse) {
    const after = next.ellipse;
    const from = (/** @type {string} */ letter, /** @type {number} */ i, /** @type {string[]} */ [a, b]) =>
      html`${symbol(letter, i)} ${a} → ${b}`;
    return rows((i) => ({
      lines: [
        from(
          'm',
          i,
          [ellipse.mean[i], after.mean[i]].map((mean) => words.gainText(mean, deviationOf(after, i))),
        ),
        from(
          'σ',
          i,
          [ellipse, after].map((one) => words.sigmaText(deviationOf(one, i))),
        ),
      ],
    }));
  }
  if (method === 'one-plus-one-es' && plan.steps && next.steps)
    return html`
      <p class="equation">σ ${words.sigmaText(plan.steps[0])} → ${words.sigmaText(next.steps[0])}</p>
      ${successes ? html`<p>${words.successText(successes)}</p>` : nothing}`;
  const gain = (/** @type {number} */ i) => equals('k', i, words.gainText(all[survivors[0]].gains[i]));
  if (method === 'one-at-a-time') return rows(withSteps(next.steps, gain));
  const { slope } = next;
  if (method === 'finite-differences' && slope)
    return rows((i) => ({
      beside: bar(partOf(slope, i)),
      lines: [
        html`<i>∂J</i>/<i>∂</i>${symbol('k', i)} = ${words.signedText(slope[i])}`,
        words.nextStep(words.signedText(next.steps?.[i] ?? 0)),
      ],
    }));
  return nothing;
}
