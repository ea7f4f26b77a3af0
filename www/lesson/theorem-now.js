// Which of the inequalities of Theorem 2 hold at the robot's clock, and what follows.
import { disturbanceSlice } from '../parts/disturbance/state.js';
import { create } from '../kit/elements.js';
import { isInside, parts } from '../parts/disturbance/summary.js';
import { watch } from '../kit/memo.js';
import { disturbance as names } from '../words/index.js';

/** @typedef {import('./page.js').Live} Live */
/** @typedef {import('../parts/disturbance/summary.js').PartName} PartName */
/** @typedef {{ holds: { one: (holds: boolean, formula: string, size: string, set: string | null) => string, all: (time: number, count: number) => string } }} HoldsWords */

/** @param {import('./page.js').Tools} _tools @param {HoldsWords} words @returns {import('./page.js').Block} */
export function createTheoremNow(_tools, { holds: words }) {
  const rows = parts.map((part) => {
    const text = create('span', '');
    const row = create('li', `of-${part}`, create('span', 'holds-number', names.equations[part]), text);
    return { part, row, text };
  });
  const sum = create('p', '');
  const element = create('div', 'holds', create('ul', '', ...rows.map(({ row }) => row)), sum);
  element.id = 'theorem-now';
  const changed = watch();

  return {
    element,
    /** @param {Live} live */
    draw({ state, scene }) {
      const { measured } = disturbanceSlice.of(state);
      if (!measured) return;
      const { runs, disturbed } = measured;
      const { time } = runs[0];
      const now = Math.min(state.robot.time, scene.driving.finalTime);
      const at = Math.min(Math.round(now / (time[1] - time[0])), time.length - 1);
      if (!changed(measured, at)) return;
      const found = rows.map(({ part }) => {
        const [size, set] = [runs[0][part][at], part === 'y' ? runs[0].ySet[at] : disturbed.sets[part][0]];
        return { part, size, set, holds: set === 0 || !isInside(size, set) };
      });
      for (const [i, { part, size, set, holds }] of found.entries()) {
        rows[i].row.classList.toggle('held', holds);
        rows[i].text.textContent = words.one(
          holds,
          names.formulaText(part),
          names.sizeText(size),
          set === 0 ? null : names.sizeText(set),
        );
      }
      sum.textContent = words.all(time[at], found.filter(({ holds }) => holds).length);
    },
  };
}
