// The controls of the disturbance: its kind, its two sizes, and another draw.
/** @import { DisturbanceState } from './state.js' */
import { listed } from '../../kit/segmented.js';
import { disturbanceSlice } from './state.js';
import { html } from 'lit-html';
import { createRow } from '../../lab/gains.js';
import { isLost, messageOf } from '../../words/errors.js';
import { segmentedOf } from '../../kit/fields.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';

/** @typedef {import('../part.js').Tools} PageParts */
/** @typedef {import('../../core/engine.js').Experiment['disturbance']} Disturbance */

const sizes = /** @type {const} */ (['linear', 'angular']);
/** What the sliders reach; more can be typed. */
const reach = /** @type {const} */ ([0.5, 1]);

/** @param {PageParts} parts */
export function createControls({ engine, store, actions }) {
  const tried = () => store.get().tried;

  /** @param {Partial<Disturbance>} patch */
  const tryOut = (patch) => {
    actions.tryDisturbance({ ...tried(), ...patch });
    disturbanceSlice.update(store, { error: null });
  };

  /** @param {number} index @param {string} text */
  const refuse = (index, text) => disturbanceSlice.update(store, { error: { index, text } });

  /** @param {Partial<Disturbance>} patch @param {number} index Of the size that is to blame. @param {string} name */
  const attempt = (patch, index, name) => {
    try {
      tryOut(patch);
    } catch (error) {
      if (isLost(error)) throw error;
      refuse(index, lab.gainRefused(name, messageOf(error)));
    }
  };

  /** @param {'random' | 'slip'} kind */
  const createRows = (kind) =>
    words.sizes[kind].map((size, index) => {
      const events = {
        onSlide: (/** @type {number} */ _, /** @type {number} */ value) =>
          attempt({ [sizes[index]]: value }, index, size.name),
        onSlid: actions.driveAgain,
        onType(/** @type {number} */ _, /** @type {string} */ text) {
          const value = lab.numberOf(text);
          if (!Number.isFinite(value)) return refuse(index, lab.notANumber(size.name, text));
          attempt({ [sizes[index]]: value }, index, size.name);
          actions.driveAgain();
        },
      };
      return createRow(size, index, events, words.units[index]);
    });

  const rows = { random: createRows('random'), slip: createRows('slip') };
  const chooseKind = (/** @type {Disturbance['kind']} */ chosen) => {
    const { linear, angular } = tried();
    // A bound has no sign.
    const bounds = { linear: Math.abs(linear), angular: Math.abs(angular) };
    tryOut({ ...(chosen === 'random' && bounds), kind: chosen });
    actions.driveAgain();
  };
  const onDraw = () => {
    tryOut({ seed: engine.randomSeed() });
    actions.driveAgain();
  };

  /** The rows of the sizes in question, as they are now. @param {Disturbance} now @param {DisturbanceState['error']} error */
  const rowsOf = (now, error) => {
    const isSlip = now.kind === 'slip' || (now.kind === 'none' && Math.min(now.linear, now.angular) < 0);
    return rows[isSlip ? 'slip' : 'random'].map(({ row, draw }, index) => {
      const low = isSlip ? -reach[index] : 0;
      draw(now[sizes[index]], error?.index === index ? error.text : '', [low, reach[index]]);
      return row;
    });
  };

  return (/** @type {Disturbance} */ now, /** @type {DisturbanceState['error']} */ error) => html`
    <fieldset id="disturbance-controls" class="around" aria-label=${words.texts.disturbanceControls}>
      <div class="bar">
        ${segmentedOf('disturbance-kind', words.kindLegend, listed(words.kinds), now.kind, chooseKind)}
        <button id="disturbance-draw" type="button" .hidden=${now.kind !== 'random'} @click=${onDraw}>${words.texts.disturbanceDraw}</button>
      </div>
      <fieldset id="disturbance-sizes" class="sizes large-figure-only" aria-label=${words.texts.disturbanceSizes}
        .disabled=${now.kind === 'none'}>${rowsOf(now, error)}</fieldset>
    </fieldset>`;
}
