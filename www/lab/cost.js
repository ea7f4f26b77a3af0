// J and its parts.
/** @import { Run } from '../core/engine.js' */
import { html, render } from 'lit-html';
import { write } from '../kit/elements.js';
import { styled } from '../kit/templates.js';
import { watch } from '../kit/memo.js';
import { lab as strings } from '../words/index.js';

/** @typedef {{ title: string, starts: number, run: Run, note: string }} CostModel */

/** @param {HTMLElement} root @param {HTMLElement} beside Where J stands once more. */
export function createCost(root, beside) {
  const changed = watch();
  return {
    /** @param {CostModel} model */
    draw(model) {
      if (!changed(...Object.values(model))) return;
      render(costOf(model), root);
      write(beside, `J ${strings.costText(model.run.cost.total)}`);
    },
  };
}

/** @param {CostModel} model */
function costOf({ title, starts, run, note }) {
  const { cost } = run;
  const share = (/** @type {typeof strings.costParts[number][0]} */ part) =>
    Number.isFinite(cost.total) ? cost[part] / cost.total : 0;
  return html`
    <div class="heading">
      <h2 id="cost-title">${title}</h2>
      <p id="outcome" class="muted">${strings.outcomeText(run)}</p>
    </div>
    <p class="cost-line row"><span id="cost-total" class="cost-total">${strings.costText(cost.total)}</span> <span class="muted"><span>${strings.costMeaning(starts)}</span><br><span id="cost-note">${note}</span></span></p>
    <div id="cost-bar" class="cost-bar" aria-hidden="true">${strings.costParts.map(
      ([part]) =>
        html`<span class="cost-segment part-${part}" data-term=${part} .hidden=${!(share(part) >= 0.004)} ${styled('flex-grow', String(share(part)))}></span>`,
    )}</div>
    <ul id="cost-parts" class="cost-parts row muted">${strings.costParts.map(
      ([part, name]) =>
        // What only gains below zero pay is left out while nobody pays it.
        html`<li class="part-${part}" data-term=${part} .hidden=${part === 'penalty' && cost.penalty === 0}>${name} <span id="cost-${part}" class="cost-value">${strings.partText(cost[part])}</span></li>`,
    )}</ul>`;
}
