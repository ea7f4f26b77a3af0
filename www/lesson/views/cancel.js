// The terms of V̇ strike each other out, in three presses.
import { html, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { isFree } from '../../run/guard.js';
import { signed } from '../../words/numbers.js';
import { rateAmounts, rateTerms } from '../formulas/formulas-motion.js';
import { piecesOf } from '../formulas/notation.js';
import { mathml, symbol } from '../formulas/symbols.js';

/** @import { Block, Live, Tools } from '../page.js' */
/** @typedef {{ cancel: { label: string, said: readonly string[], amounts: string, otherLaw: string, presses: readonly string[], again: string } }} CancelWords */

const presses = 3;

/** @param {Tools} tools @param {CancelWords} words @returns {Block} */
export function createCancel({ store, actions }, { cancel: words }) {
  const element = create('div', { id: 'cancel', class: 'cancel' });
  let pressed = 0;
  const terms = rateTerms.map(({ text, pair, of }) => {
    const math = mathml('math', ...piecesOf(text, symbol));
    math.setAttribute('displaystyle', 'true');
    return { math, pair, of };
  });
  const changed = watch();
  /** @type {Live | null} */
  let latest = null;
  const press = () => {
    pressed = (pressed + 1) % (presses + 1);
    if (pressed === 1 && latest && isOver(latest) && isFree(latest.state, 'clock'))
      actions.scrub(weightiestAt(latest));
    store.redraw();
  };
  /** When a pair is struck out. @param {'kx' | 'ky' | null} pair */
  const isStruck = (pair) => (pair === 'ky' && pressed >= 2) || (pair === 'kx' && pressed >= 3);

  return {
    element,
    draw(/** @type {Live} */ live) {
      latest = live;
      const { gains, sample, state } = live;
      if (!changed(pressed, gains, sample)) return;
      const amounts = rateAmounts(gains, sample.error);
      const isTheLaw = state.experiment.law === 'shim-kim';
      const items = terms.map(
        (
          { math, pair, of },
          i,
        ) => html`<li class=${`of-${of}${isStruck(pair) ? ' struck' : ''}${pair ? '' : ' stays'}`}>
          ${math}<span class="muted">${isTheLaw ? signed(amounts[i], 2) : ''}</span></li>`,
      );
      render(
        html`<ul class="cancel-terms" aria-label=${words.label} ?hidden=${pressed === 0}>${items}</ul>
          <p class="cancel-said" role="status">${words.said[pressed]} ${pressed === 1 ? (isTheLaw ? words.amounts : words.otherLaw) : ''}</p>
          <button id="cancel-press" type="button" class="primary" @click=${press}>${words.presses[pressed] ?? words.again}</button>`,
        element,
      );
    },
  };
}

/** Whether the clock stands where a drive ends: there nearly all terms are zero. @param {Live} live */
const isOver = ({ at, samples }) => at === samples.length - 1;

/** The core is asked no oftener: the page would stand still. */
const mostMoments = 2000;

/** When both pairs that cancel weigh much. @param {Live} live */
function weightiestAt({ samples, gains }) {
  const weightOf = (/** @type {Live['sample']} */ { error }) => {
    const [, steep, cross] = rateAmounts(gains, error);
    return Math.min(Math.abs(steep), Math.abs(cross));
  };
  const every = Math.ceil(samples.length / mostMoments);
  const moments = samples.map((one) => one).filter((_, i) => i % every === 0);
  return moments.reduce((most, one) => (weightOf(one) > weightOf(most) ? one : most)).time;
}
