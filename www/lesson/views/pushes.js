// The terms of the law (5) at the robots' clock: what each adds to v and to ω, what is asked for in all, and what the limits leave.
import { html, nothing, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { signed } from '../../words/numbers.js';
import { termsOfLaw } from '../formulas/formulas.js';
import { piecesOf } from '../formulas/notation.js';
import { createStrip } from './push-strip.js';
import { pushesOf, reach } from './push-terms.js';
import { mathml, symbol, symbolInText } from '../formulas/symbols.js';

/** @import { Experiment, Sample } from '../../core/engine.js' */
/** @import { Block, Tools } from '../page.js' */
/** @import { StripWords } from './push-strip.js' */
/** @import { Side } from './push-terms.js' */
/** @typedef {{ speed: string, turnRate: string, moving: string, asked: string, left: string, otherLaw: string, tableLabel: string } & StripWords} PushWords */
/** @typedef {{ label: Node | string, colour: string, term?: string }} Head */

/** The terms in one line, for who hears them. @type {Record<Side, Record<string, string>>} */
const inWords = {
  linear: { kx: 'k x · x e · cos θ e', ky: '− k y · y e³ / sin θ e' },
  angular: {
    kt: 'k θ · sin θ e',
    ky: 'k y · x e · y e³ · cos θ e / sin² θ e',
    kx: 'k x · x e · y e · cos θ e',
  },
};

/** @param {Tools} tools @param {{ pushes: PushWords }} words @returns {Block} */
export function createPushes(tools, { pushes: words }) {
  const bars = create('div', 'push-bars');
  const strip = createStrip(tools, words);
  const element = create('div', { id: 'pushes' }, bars, strip.element);
  const sides = [createSide('linear', words.speed, words), createSide('angular', words.turnRate, words)];
  const changed = watch();
  return {
    element,
    draw({ decided: sample, samples, gains, state, scene: { experiment, driving } }) {
      const { finalTime } = driving;
      strip.draw({ samples, experiment, gains, time: Math.min(state.robot.time, finalTime), finalTime });
      if (!changed(sample, ...gains, experiment)) return;
      const isOurs = experiment.law === 'shim-kim';
      const pushes = isOurs ? pushesOf(experiment, gains, sample.error) : null;
      render(
        html`<table class="pushes" aria-label=${words.tableLabel}>
            ${sides.map((side) => side(sample, experiment, pushes))}
          </table>
          <p class="muted" ?hidden=${isOurs}>${words.otherLaw}</p>`,
        bars,
      );
    },
  };
}

/** All of v, or all of ω. @param {Side} side @param {string} unit @param {PushWords} words */
function createSide(side, unit, words) {
  const name = side === 'linear' ? 'v' : 'w';
  const head = symbolInText(name);
  const terms = Object.entries(termsOfLaw[side]).map(([gain, text]) => {
    const sign = side === 'linear' && gain === 'ky' ? '−' : '';
    const math = mathml('math', ...piecesOf(`{${sign} ${text}}`, symbol));
    math.setAttribute('role', 'math');
    math.setAttribute('aria-label', inWords[side][gain]);
    return { label: math, colour: `of-${gain === 'kt' ? 'theta' : gain[1]}`, term: gain };
  });
  const asked = {
    label: words.asked,
    colour: `of-${name === 'v' ? 'energy' : 'omega'} push-asked`,
    term: name,
  };

  return (
    /** @type {Sample} */ { command, velocity },
    /** @type {Experiment} */ { limits, referenceVelocity: { linear, angular } },
    /** @type {ReturnType<typeof pushesOf> | null} */ pushes,
  ) => {
    const free = (side === 'linear' ? limits.speed : limits.turnRate) ?? Number.POSITIVE_INFINITY;
    const isMoving = linear !== 0 || angular !== 0;
    let sum = 0;
    const next = (/** @type {Head} */ of, /** @type {number} */ amount) => {
      sum += amount;
      return bar(side, of, amount, sum);
    };
    const amounts = /** @type {Record<string, number>} */ (pushes?.[side] ?? {});
    return html`<tbody class=${free < reach[side] ? '' : 'all-free'} .style=${`--free: ${50 * Math.min(free / reach[side], 1)}%`}>
      <tr><th class="push-unit muted" scope="rowgroup" colspan="3">${head} ${unit}</th></tr>
      ${pushes && terms.map((of) => next(of, amounts[of.term]))}
      ${pushes && isMoving ? next({ label: words.moving, colour: 'of-moving' }, pushes.reference[side]) : ''}
      ${bar(side, asked, command[side])} ${bar(side, { label: words.left, colour: 'of-left' }, velocity[side])}
    </tbody>`;
  };
}

/** How much it is, as the last piece on the way to the sum. @param {Side} side @param {Head} head @param {number} amount @param {number} [sum] */
function bar(side, { label, colour, term }, amount, sum = amount) {
  const at = (/** @type {number} */ value) => Math.min(Math.max(value / reach[side], -1), 1);
  const [low, high] = [Math.min(sum - amount, sum), Math.max(sum - amount, sum)];
  // What pushes nothing leads nowhere.
  const [right, left] = low < high ? [high > reach[side], low < -reach[side]] : [false, false];
  return html`<tr class=${colour} data-term=${term ?? nothing}>
    <th class="push-name" scope="row">${label}</th>
    <td class="push-cell"><span class="push-track"
      ><span class="push-free"></span><span class="push-zero"></span
      ><span class="push" .style=${`left: ${50 + 50 * at(low)}%; right: ${50 - 50 * at(high)}%`}>${left ? beyond('◀') : nothing}${right ? beyond('▶', 'at-right') : nothing}</span
    ></span></td>
    <td class="push-value">${signed(amount, 2)}</td>
  </tr>`;
}

/** Where a piece is cut. @param {string} sign @param {string} [side] */
const beyond = (sign, side = '') =>
  html`<span class=${`push-beyond ${side}`} aria-hidden="true">${sign}</span>`;
