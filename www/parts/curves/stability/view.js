// The Lyapunov function of the run on screen: V, what the law promises of its rate, and what the robot makes of that.
/** @import { Experiment, Stability, Triple } from '../../../core/engine.js' */
/** @import { Pins } from '../../../run/pins.js' */
/** @import { Tools } from '../../part.js' */
/** @import { View } from '../page.js' */
import { html, render } from 'lit-html';
import { checkOf } from '../../../kit/fields.js';
import { formula } from '../../../kit/templates.js';
import { once, remember, watch } from '../../../kit/memo.js';
import { createTeller } from '../../../lab/announcer.js';
import { showTable } from '../../../lab/table-sheet.js';
import { sampleBefore } from '../../../lab/track.js';
import words from './words/index.js';
import { createPicture } from '../picture.js';
import { curvesSlice } from '../state.js';
import { plotsOfStability } from './plots.js';
import { summaryOf } from './summary.js';
import { stabilityTable } from './table.js';

/** @typedef {{ name: string, driving: Stability, law: Experiment['law'], sample: number, label: string, note: string, isLog: boolean }} Model */

/** @param {HTMLElement} root @param {Tools} tools @returns {View} */
export function createStability(root, tools) {
  const { engine, store } = tools;
  const stabilityOne = () =>
    remember((/** @type {Experiment} */ experiment, /** @type {Triple} */ gains) =>
      engine.stability(experiment, gains),
    );
  const [drivingOf, comparisonOf] = [stabilityOne(), stabilityOne()];
  const pinnedOf = remember((/** @type {Pins} */ pins) =>
    pins.map(({ experiment, gains }) => engine.stability(experiment, gains)),
  );
  const textsOf = remember(
    /** @param {string} name @param {Stability} driving @param {Experiment} experiment @param {Triple} gains */
    (name, driving, experiment, gains) => {
      const summary = summaryOf(driving, experiment, gains);
      return { label: words.pictureLabel(name, summary), note: words.noteText(summary) };
    },
  );
  const picture = once(() => createPicture(root, tools, plotsOfStability));
  const onLog = (/** @type {boolean} */ isLog) =>
    curvesSlice.update(store, { scale: isLog ? 'log' : 'linear' });
  const changed = watch();
  const tell = createTeller('stability');

  return {
    draw(state, { experiment, gains, compared }, { name, time }) {
      const { pins, theme } = state;
      const { law } = experiment;
      const isLog = curvesSlice.of(state).scale === 'log';
      const driving = drivingOf(experiment, gains);
      const texts = textsOf(name, driving, experiment, gains);
      const sample = sampleBefore(driving, time);
      if (changed(driving, law, sample, texts, isLog))
        render(contentOf({ name, driving, law, sample, ...texts, isLog }, onLog), root);
      tell(texts.note, state.evolving);
      const comparison = comparisonOf(compared.experiment, compared.gains);
      const pinned = pinnedOf(pins);
      picture().draw({ driving, law, comparison, pins, pinned, isLog, theme }, time);
    },
  };
}

/** @param {Model} model @param {(isLog: boolean) => void} onLog */
const contentOf = ({ name, driving, law, sample, label, note, isLog }, onLog) => html`
  <dl id="stability-readout" class="stability-readout" data-picture="stability">${readingsOf(driving, law, sample)}</dl>
  <div id="stability-picture" class="stability-picture picture layers" data-picture="stability" data-name=${words.texts.stabilityPicture}>
    <canvas id="stability-lines" role="img" aria-label=${label}></canvas>
    <canvas id="stability-cursor" aria-hidden="true"></canvas>
  </div>
  <div class="stability-foot row not-in-small-figure">
    <p id="stability-note" class="muted">${note}</p>
    ${checkOf('stability-log', words.texts.stabilityLog, isLog, onLog, { more: 'muted' })}
    <button id="stability-table" type="button" class="link muted" @click=${() => showTable(stabilityTable(name, driving))}>${words.texts.stabilityTable}</button>
  </div>`;

/** @type {readonly (readonly [id: keyof typeof words.terms.kanayama, read: (run: Stability, i: number) => number])[]} */
const readings = [
  ['lyapunov', (run, i) => run.lyapunov[i]],
  ['rate', (run, i) => run.rate[i]],
  ['promised', (run, i) => run.promisedX[i] + run.promisedY[i] + run.promisedTheta[i]],
  ['x', (run, i) => run.promisedX[i]],
  ['y', (run, i) => run.promisedY[i]],
  ['theta', (run, i) => run.promisedTheta[i]],
];

/** The values at the cursor, those of the law as the equation that they are. @param {Stability} run @param {Experiment['law']} law @param {number} i */
function readingsOf(run, law, i) {
  const [lyapunov, ...rates] = readings.map(([, read]) => read(run, i));
  const texts = [words.amount(lyapunov), ...words.amounts(rates)];
  return readings.map(
    ([id], n) =>
      html`<div class=${id}><dt>${formula(words.terms[law][id])}</dt><dd id="stability-${id}">${texts[n]}</dd></div>`,
  );
}
