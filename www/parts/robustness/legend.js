// What the colours of the map mean: a bar with its ticks, and the hatching where no robot arrives.
import { createLayer } from '../../kit/canvas.js';
import { shadeAt } from '../../kit/shades.js';
import { watch } from '../../kit/memo.js';
import { robustness as words } from '../../words/index.js';
import { hatch } from './view.js';

/** @typedef {import('./request.js').Quantity} Quantity */
/** @typedef {import('./scale.js').Shading} Shading */
/** @typedef {{ shading: Shading, quantity: Quantity, heading: number | null, theme: number }} LegendModel */

/** @param {HTMLElement} root */
export function createLegend(root) {
  const [title, bar, ticks, never] = ['p', 'div', 'div', 'p'].map((name) => document.createElement(name));
  const swatch = document.createElement('canvas');
  const neverText = document.createElement('span');
  bar.className = 'legend-bar';
  ticks.className = 'legend-ticks';
  never.className = 'legend-never';
  never.append(swatch, neverText);
  root.replaceChildren(title, bar, ticks, never);
  const layer = createLayer(swatch);
  const changed = watch();
  return {
    /** @param {LegendModel} model */
    draw({ shading, quantity, heading, theme }) {
      if (!changed(shading, theme)) return;
      const all = heading === null;
      title.textContent = words.legendTitle(quantity, all);
      neverText.textContent = words.never(all);
      drawBar(bar, shading, quantity === 'share' && !all);
      ticks.hidden = quantity === 'share' && !all;
      ticks.replaceChildren(...tickMarks(shading, quantity));
      layer.draw({ width: 20, height: 14 }, (context) => {
        context.fillStyle = hatch(context);
        context.fillRect(0, 0, 20, 14);
      });
    },
  };
}

/** @param {HTMLElement} bar @param {Shading} shading @param {boolean} plain */
function drawBar(bar, { part, high }, plain) {
  const stops = Array.from({ length: 17 }, (_, i) => shadeAt(plain ? 0 : part((high * i) / 16)));
  bar.style.background = `linear-gradient(to right, ${stops.join(', ')})`;
}

/** @param {Shading} shading @param {Quantity} quantity */
function tickMarks({ ticks, high, open }, quantity) {
  const digits = ticks.some((tick) => tick % 1 !== 0) ? 1 : 0;
  return ticks.map((tick, i) => {
    const mark = document.createElement('span');
    const text = words.tickText(quantity, tick, digits);
    mark.textContent = i === ticks.length - 1 ? words.lastTick(quantity, text, open) : text;
    mark.style.left = `${(100 * tick) / high}%`;
    return mark;
  });
}
