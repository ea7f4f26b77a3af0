// The controls of the disturbance: its kind, its two sizes, and another draw.
import { disturbanceSlice } from './state.js';
import { byId } from '../../kit/elements.js';
import { createRow } from '../../lab/gains.js';
import { messageOf } from '../../words/errors.js';
import { createSegmented } from '../../kit/segmented.js';
import { watch } from '../../kit/memo.js';
import { disturbance as words, lab } from '../../words/index.js';

/** @typedef {import('../part.js').Tools} PageParts */
/** @typedef {import('../../core/engine.js').Experiment['disturbance']} Disturbance */
/** @typedef {import('./state.js').DisturbanceState} DisturbanceState */

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

  const kind = createSegmented(byId('disturbance-kind'), words.kindLegend, words.kinds, (chosen) => {
    const { linear, angular } = tried();
    // A bound has no sign.
    const bounds = { linear: Math.abs(linear), angular: Math.abs(angular) };
    tryOut({ ...(chosen === 'random' && bounds), kind: chosen });
    actions.driveAgain();
  });
  const rows = { random: createRows('random'), slip: createRows('slip') };
  /** @type {HTMLFieldSetElement} */
  const fieldset = byId('disturbance-sizes');
  fieldset.append(...[...rows.random, ...rows.slip].map(({ row }) => row));
  const draw = byId('disturbance-draw');
  draw.addEventListener('click', () => {
    tryOut({ seed: engine.randomSeed() });
    actions.driveAgain();
  });

  const changed = watch();
  return {
    /** @param {Disturbance} now @param {DisturbanceState['error']} error */
    draw(now, error) {
      if (!changed(now, error)) return;
      kind.draw(now.kind);
      draw.hidden = now.kind !== 'random';
      fieldset.disabled = now.kind === 'none';
      const isSlip = now.kind === 'slip' || (now.kind === 'none' && Math.min(now.linear, now.angular) < 0);
      for (const [name, pair] of Object.entries(rows)) {
        const isShown = (name === 'slip') === isSlip;
        for (const [index, { row, draw: drawRow }] of pair.entries()) {
          row.hidden = !isShown;
          const low = isSlip ? -reach[index] : 0;
          if (isShown)
            drawRow(now[sizes[index]], error?.index === index ? error.text : '', [low, reach[index]]);
        }
      }
    },
  };
}
