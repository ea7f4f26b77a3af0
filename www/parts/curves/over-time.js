// The run on screen against time, with the values at the robots' clock.
/** @import { Experiment, Preset, Run } from '../../core/engine.js' */
/** @import { Scene } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Tools } from '../part.js' */
/** @import { View } from './page.js' */
import { html, render } from 'lit-html';
import { paidUntil } from '../../core/paid.js';
import { once, remember, watch } from '../../kit/memo.js';
import { pinTextsOf } from '../../lab/notes.js';
import { sampleBefore } from '../../lab/track.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { createPicture } from './picture.js';
import { plotsOverTime } from './plots.js';

/** @param {HTMLElement} root @param {Tools} tools @returns {View} */
export function createOverTime(root, tools) {
  const picture = once(() => createPicture(root, tools, plotsOverTime));
  const labelOf = remember(described);
  /** Whether nothing that drives differs from the paper's experiment. */
  const isPapers = remember((/** @type {Experiment} */ own, /** @type {Preset} */ preset) => {
    const text = (/** @type {Experiment} */ { evolution, ...rest }) => JSON.stringify(rest);
    return text(own) === text(tools.engine.experiment(preset));
  });
  const changed = watch();

  return {
    draw(state, scene, { name, time }) {
      const { driving } = scene;
      const sample = sampleBefore(driving, time);
      const label = labelOf(
        name,
        driving,
        rivalOf(state, scene),
        scene.comparison,
        state.pins,
        scene.pins,
        scene.experiment,
      );
      const isPaper = state.driver === 'paper-ep' && isPapers(state.experiment, state.preset);
      const note = isPaper ? words.figureNote(state.preset === 'velocity-limits' ? '5' : '7') : '';
      if (changed(driving, sample, label, note))
        render(contentOf(readingsOf(driving, sample), label, note), root);
      picture().draw(
        {
          driving,
          comparison: scene.comparison,
          pins: state.pins,
          pinned: scene.pins,
          limits: scene.experiment.limits,
          isFigure: isPaper,
          theme: state.theme,
        },
        time,
      );
    },
  };
}

/** @param {ReturnType<typeof readingsOf>} readings @param {string} label @param {string} note */
const contentOf = (readings, label, note) => html`
  <dl id="curves-readout" class="curves-readout row not-in-sight">${readings}</dl>
  <div id="curves-picture" class="curves-picture picture layers" data-picture="curves" data-name=${words.texts.curvesPicture}>
    <canvas id="curves-lines" role="img" aria-label=${label}></canvas>
    <canvas id="curves-cursor" aria-hidden="true"></canvas>
  </div>
  <p id="curves-note" class="muted">${note}</p>`;

/** The values at the cursor, each in a place of its own. @param {Run} run @param {number} i */
const readingsOf = (run, i) =>
  words.readings.map(
    ({ id, symbol, className, unit, text }) =>
      html`<div><dt class=${className}>${symbol}</dt><dd><span id="reading-${id}" class="value">${text(run, i, paidUntil(run, i))}</span>${unit}</dd></div>`,
  );

/** Whom the run on screen is compared with. @param {State} state @param {Scene} scene */
const rivalOf = ({ generation, found }, { withoutDisturbance, comparisonDriver }) =>
  withoutDisturbance ? lab.withoutDisturbance : lab.driverName(comparisonDriver, generation, found);

/** The picture in words. @param {string} name @param {Run} run @param {string} rival @param {Run} comparison @param {State['pins']} pins @param {readonly Run[]} pinned @param {Experiment} experiment */
function described(name, run, rival, comparison, pins, pinned, experiment) {
  const told = (/** @type {string} */ text, /** @type {Run} */ one) => `${text}, ${lab.outcomeText(one)}`;
  return words.pictureLabel(
    name,
    run,
    lab.outcomeText(run),
    told(lab.comparisonText(rival, comparison), comparison),
    pinTextsOf(pins, pinned, experiment).map((text, i) => told(text, pinned[i])),
  );
}
