// Which of the inequalities of Theorem 2 hold at the robot's clock, and what follows.
import { html, nothing, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { disturbanceSlice } from '../../parts/disturbance/state.js';
import { parts } from '../../parts/disturbance/summary.js';
import { watch } from '../../kit/memo.js';
import names from '../../parts/disturbance/words/index.js';
import { inline } from '../prose.js';

/** @import { Block, Tools } from '../page.js' */
/** @typedef {{ holds: { one: (holds: boolean, formula: string, size: string, set: string | null) => string, all: (time: number, count: number, isCut: boolean) => string } }} HoldsWords */

/** @param {Tools} _tools @param {HoldsWords} words @returns {Block} */
export function createTheoremNow(_tools, { holds: words }) {
  const element = create('div', { id: 'theorem-now', class: 'holds' });
  const changed = watch();

  return {
    element,
    draw({ state, scene, decided }) {
      const { measured } = disturbanceSlice.of(state);
      if (!measured) return;
      const { runs, disturbed, spec } = measured;
      const { time } = runs[0];
      const now = Math.min(state.robot.time, scene.driving.finalTime);
      const at = Math.min(Math.round(now / (time[1] - time[0])), time.length - 1);
      const { command, velocity } = decided;
      const isCut = command.linear !== velocity.linear || command.angular !== velocity.angular;
      if (!changed(measured, at, isCut)) return;
      if (spec.experiment.law !== 'shim-kim') return render(nothing, element);
      const found = parts.map((part) => {
        const [size, set] = [runs[0][part][at], part === 'y' ? runs[0].ySet[at] : disturbed.sets[part][0]];
        const holds = set === 0 || !(size <= set);
        const bound = set === 0 ? null : names.sizeText(set);
        return { part, holds, text: words.one(holds, names.formulaText(part), names.sizeText(size), bound) };
      });
      const rows = found.map(
        ({ part, holds, text }) => html`<li class=${`of-${part}${holds ? ' held' : ''}`}>
          <span class="holds-number">${names.equations[part]}</span>${text}
        </li>`,
      );
      const count = found.filter(({ holds }) => holds).length;
      const said = inline(words.all(time[at], count, isCut), (link) => `#${link}`);
      render(html`<ul>${rows}</ul><p>${said}</p>`, element);
    },
  };
}
