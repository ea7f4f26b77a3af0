// What the colours of the map mean: a bar with its ticks, and the hatching where none or few arrive.
/** @import { Quantity } from './request.js' */
/** @import { Shading } from './scale.js' */
import { html, render } from 'lit-html';
import { createLayer } from '../../kit/canvas.js';
import { byIdIn } from '../../kit/elements.js';
import { shadeAt } from '../../kit/shades.js';
import { styled } from '../../kit/templates.js';
import { once, watch } from '../../kit/memo.js';
import words from './words/index.js';
import { hatch, hatchOver } from './view.js';

/** @typedef {{ shading: Shading, quantity: Quantity, heading: number | null, theme: number }} LegendModel */

/** @param {HTMLElement} root */
export function createLegend(root) {
  const [never, few] = ['never', 'few'].map((name) =>
    once(() => createLayer(byIdIn(root, `robustness-${name}`))),
  );
  const size = { width: 20, height: 14 };
  const changed = watch();
  return {
    /** @param {LegendModel} model */
    draw({ shading, quantity, heading, theme }) {
      if (!changed(shading, theme, devicePixelRatio)) return;
      render(sight(shading, quantity, heading === null), root);
      /** @param {CanvasRenderingContext2D} context @param {string | CanvasPattern} style */
      const fill = (context, style) => {
        context.fillStyle = style;
        context.fillRect(0, 0, size.width, size.height);
      };
      never().draw(size, (context) => fill(context, hatch(context)));
      few().draw(size, (context) => {
        fill(context, shadeAt(0.3));
        fill(context, hatchOver(context));
      });
    },
  };
}

/** @param {Shading} shading @param {Quantity} quantity @param {boolean} all Of all headings together. */
function sight({ few, part, ticks, high, open }, quantity, all) {
  const isPlain = quantity === 'share' && !all;
  const stops = Array.from({ length: 17 }, (_, i) => shadeAt(isPlain ? 0 : part((high * i) / 16)));
  const digits = ticks.some((tick) => tick % 1 !== 0) ? 1 : 0;
  const marks = ticks.map((tick, i) => {
    const text = words.tickText(quantity, tick, digits);
    const last = i === ticks.length - 1;
    return html`<span ${styled('left', `${(100 * tick) / high}%`)}>${last ? words.lastTick(quantity, text, open) : text}</span>`;
  });
  return html`
    <p>${words.legendTitle(quantity, all)}</p>
    <div class="legend-bar" ${styled('background', `linear-gradient(to right, ${stops.join(', ')})`)}></div>
    <div class="legend-ticks" .hidden=${isPlain}>${marks}</div>
    <div class="legend-hatched">
      <p class="legend-never"><canvas id="robustness-never"></canvas><span>${words.never(all)}</span></p>
      <p class="legend-never" .hidden=${few.length === 0}><canvas id="robustness-few"></canvas><span>${words.few}</span></p>
    </div>`;
}
